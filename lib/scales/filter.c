/* filter.c - Algorithm 1: thresholds on the coefficients of a field (doc/mathematics.md 5.2). */
#include <math.h>
#include <stdlib.h>

#include "borderpart.h"
#include "filter.h"

/* x is the field to filter: f, or log f less its border part h.  C are its coefficients, a their
 * moduli. */
typedef struct Waves {
	double         *x, *h, *a;
	double complex *C;
} Waves;

static void
waves_free(Waves *w)
{
	free(w->x);
	free(w->h);
	free(w->a);
	free(w->C);
}

static int
set_field(Spectrum s, int logarithm, const double *f, Waves *w)
{
	size_t n = (size_t)s.g.nu*s.g.nv, p;
	int e = 0;

	for (p = 0; p < n; p++)
		w->x[p] = logarithm ? log(f[p]) : f[p];
	if (logarithm)
		e = border_part(s.g, 1, (const double *const[]){ w->x }, &w->h);
	for (p = 0; p < n; p++)
		w->x[p] -= w->h[p];
	return e ? FILTER_ENOMEM : 0;
}

static int
waves_init(Spectrum s, int logarithm, const double *f, Waves *w)
{
	size_t n = (size_t)s.g.nu*s.g.nv;
	int e = FILTER_ENOMEM;

	w->x = malloc(n*sizeof *w->x);
	w->h = calloc(n, sizeof *w->h);
	w->a = malloc(spectrum_size(s)*sizeof *w->a);
	w->C = malloc(spectrum_size(s)*sizeof *w->C);
	if (w->x && w->h && w->a && w->C)
		e = set_field(s, logarithm, f, w);
	if (!e)
		e = spectrum_forward(s, w->x, w->C);
	if (e)
		waves_free(w);
	else
		spectrum_moduli(s, w->C, w->a);
	return e;
}

/* The modulus |C| that corresponds to one percent in FILTER_PERCENT. */
static double
one_percent(Spectrum s, int logarithm, const Waves *w)
{
	size_t n = (size_t)s.g.nu*s.g.nv, p;
	double from = logarithm ? creal(w->C[0])/n : 0, sum = 0;

	for (p = 0; p < n; p++)
		sum += (w->x[p] - from)*(w->x[p] - from);
	return n*sqrt(sum/n)/100;
}

int
filter_percent(Spectrum s, int logarithm, const double *f, double *out)
{
	Waves w;
	int e = waves_init(s, logarithm, f, &w);
	double unit;
	size_t q;

	if (e)
		return e;
	unit = one_percent(s, logarithm, &w);
	for (q = 0; q < spectrum_size(s); q++)
		out[q] = unit > 0 ? w.a[q]/unit : 0;
	waves_free(&w);
	return 0;
}

typedef struct Ranked {
	double a;
	size_t q;
} Ranked;

static int
larger_first(const void *x, const void *y)
{
	const Ranked *r = x, *t = y;

	if (r->a != t->a)
		return r->a < t->a ? 1 : -1;
	return r->q > t->q ? 1 : -1;
}

/* The contribution of a coefficient to the sum that the rule bounds: for FILTER_KEEP the number of
 * coefficients, for FILTER_ENERGY the energy without the mean. */
static double
sum_term(Spectrum s, FilterRule rule, const Ranked *r)
{
	int weight = spectrum_weight(s, r->q%spectrum_columns(s));

	if (rule == FILTER_KEEP)
		return weight;
	return r->q ? weight*r->a*r->a : 0;
}

/* Adds up the coefficients from the largest on, until the sum reaches *bound (for FILTER_ENERGY,
 * *bound times the sum of all).  Replaces *bound by the modulus of the last coefficient added. */
static int
modulus_bound(Spectrum s, FilterRule rule, const double *a, double *bound)
{
	size_t n = spectrum_size(s), q;
	Ranked *r = malloc(n*sizeof *r);
	double sum = 0, goal = *bound;

	if (!r)
		return FILTER_ENOMEM;
	for (q = 0; q < n; q++)
		r[q] = (Ranked){ q ? a[q] : HUGE_VAL, q };      /* the mean comes first */
	qsort(r, n, sizeof *r, larger_first);
	if (rule == FILTER_ENERGY) {
		for (q = 0; q < n; q++)
			sum += sum_term(s, rule, &r[q]);
		goal = *bound < 1 ? *bound*sum : HUGE_VAL;      /* 1 keeps all, despite rounding */
	}
	for (sum = q = 0; q < n && sum < goal; q++)
		sum += sum_term(s, rule, &r[q]);
	*bound = q ? r[q-1].a : HUGE_VAL;
	free(r);
	return 0;
}

/* Replaces the moduli by the negative wave numbers and changes the sign of the bound: keeping
 * values >= the bound then keeps the long waves. */
static void
rank_by_wave(Spectrum s, double *a, double *bound)
{
	size_t q;

	for (q = 0; q < spectrum_size(s); q++)
		a[q] = -spectrum_wave(s, q);
	*bound = -*bound;
}

/* Sets the coefficients with a <= bound (a < bound if keep_equal) to 0, except C_00.  *kept is the
 * number of those that are kept, of nu nv.  Returns 1 if a coefficient has changed. */
static int
drop(Spectrum s, double complex *C, const double *a, double bound, int keep_equal, size_t *kept)
{
	size_t q;
	int changed = 0;

	for (*kept = q = 0; q < spectrum_size(s); q++)
		if (q == 0 || a[q] > bound || (keep_equal && a[q] == bound))
			*kept += spectrum_weight(s, q%spectrum_columns(s));
		else {
			changed |= C[q] != 0;
			C[q] = 0;                                       /* (32) */
		}
	return changed;
}

int
filter_field(Spectrum s, const Filter *by, double *f, size_t *kept)
{
	size_t n = (size_t)s.g.nu*s.g.nv, p;
	double bound = by->bound;
	Waves w;
	int e = waves_init(s, by->log, f, &w), changed;

	if (e)
		return e;
	switch (by->rule) {
	case FILTER_PERCENT: bound *= one_percent(s, by->log, &w); break;
	case FILTER_RAW:     break;
	case FILTER_KEEP:
	case FILTER_ENERGY:  e = modulus_bound(s, by->rule, w.a, &bound); break;
	case FILTER_LOWPASS: rank_by_wave(s, w.a, &bound); break;
	}
	changed = !e && drop(s, w.C, w.a, bound, by->rule != FILTER_PERCENT && by->rule != FILTER_RAW, kept);
	if (changed) {
		e = spectrum_inverse(s, w.C, w.x);
		for (p = 0; p < n && !e; p++)
			f[p] = by->log ? exp(w.h[p] + w.x[p]) : w.x[p];
	}
	waves_free(&w);
	return e ? e : changed;
}
