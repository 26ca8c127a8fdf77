/* relief.c - details between scales, each scale twice the one before, weighted by their height. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "relief.h"

enum { SCALES = 5, FIELDS = 4 };        /* H and the place */

typedef struct Details {
	size_t  n;
	double *kept[FIELDS];   /* the fields of the caller: the sum of the details kept so far */
	double *all[FIELDS];    /* the given fields */
	double *fine[FIELDS], *coarse[FIELDS];  /* x_j and x_(j+1) of relief.h */
	double *share;          /* g_j */
} Details;

/* Allocates the workspace and copies the fields.  Returns a pointer for the caller to free, or NULL. */
static double *
workspace(Details *d)
{
	double *work = malloc((3*FIELDS + 1)*d->n*sizeof *work), *next = work;
	int c;

	for (c = 0; work && c < FIELDS; c++, next += 3*d->n) {
		d->all[c] = next;
		d->fine[c] = next + d->n;
		d->coarse[c] = next + 2*d->n;
		memcpy(d->all[c], d->kept[c], d->n*sizeof *next);
		memcpy(d->fine[c], d->kept[c], d->n*sizeof *next);
		memset(d->kept[c], 0, d->n*sizeof *next);
	}
	d->share = next;
	return work;
}

/* Sets d->share to g_j.  (e_j/tau)^2 is |x_j - x_(j+1)|^2/tau^2 after one step of heat flow. */
static void
set_shares(Lowpass *free, double s, double tau, Details *d)
{
	double *e2 = d->share, x;
	size_t p;
	int c;

	memset(e2, 0, d->n*sizeof *e2);
	for (c = 1; c < FIELDS; c++)
		for (p = 0; p < d->n; p++) {
			x = (d->fine[c][p] - d->coarse[c][p])/tau;
			e2[p] += x*x;
		}
	lowpass_heat(free, s, e2);
	for (p = 0; p < d->n; p++)
		d->share[p] = e2[p] > 1 ? 1 - 1/e2[p] : 0;
}

/* Adds the share g_j of the details between the two scales to `kept`, and makes the coarser scale the
 * finer one. */
static void
keep(Details *d)
{
	double *swap;
	size_t p;
	int c;

	for (c = 0; c < FIELDS; c++) {
		for (p = 0; p < d->n; p++)
			d->kept[c][p] += d->share[p]*(d->fine[c][p] - d->coarse[c][p]);
		swap = d->fine[c];
		d->fine[c] = d->coarse[c];
		d->coarse[c] = swap;
	}
}

int
relief(Lowpass *free_sides, Lowpass *held, double s, double tau, double *H, double *const place[3])
{
	Details d = { .n = (size_t)held->g.nu*held->g.nv, .kept = { H, place[0], place[1], place[2] } };
	double *work = workspace(&d);
	size_t p;
	int j, c;

	if (!work)
		return RELIEF_ENOMEM;
	for (j = 0; j < SCALES; j++, s *= 2) {
		for (c = 0; c < FIELDS; c++) {
			memcpy(d.coarse[c], d.all[c], d.n*sizeof(double));
			lowpass(c ? held : free_sides, s, d.coarse[c]);
		}
		set_shares(free_sides, s, tau, &d);
		keep(&d);
	}
	for (c = 0; c < FIELDS; c++)
		for (p = 0; p < d.n; p++)
			d.kept[c][p] += d.fine[c][p];
	free(work);
	return 0;
}
