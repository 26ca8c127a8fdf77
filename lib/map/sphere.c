/* sphere.c - linear elements, splitting where the map is least conformal, and quadratic elements. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "sphere.h"
#include "sphereface.h"
#include "sphereharmonic.h"
#include "sphereplace.h"
#include "worst.h"

enum { COLD = 4, WARM = 2 };            /* half rounds of Schwarz's method: from a dipole or for the last map, and between */
enum { FEWEST = 200 };                  /* vertices: less do not resolve a pole */

/* Makes room in m->Z for the vertices of the mesh, of which there were nv. */
static int
extend(SphereMap *m, int nv)
{
	Spinor *Z = realloc(m->Z, m->mesh.d.m.nv*sizeof *Z);

	if (!Z)
		return SPD_ENOMEM;
	m->Z = Z;
	sphereplace_extend(&m->mesh, nv, Z);
	return 0;
}

/* Solves on m's mesh, from m->Z; or, if `times` is 0, from a dipole. */
static int
solve_by(SphereMap *m, int elements, const Disk *coarse, int times, SpdReport *report)
{
	int n = m->mesh.d.m.nv, e;
	SphereHarmonic s;

	e = sphereharmonic_init(&s, &m->mesh.d, elements, coarse);
	if (e)
		return e;
	report->bytes = chol_bytes(&s.chol);
	if (times)
		sphereplace_get(n, m->Z, s.z);
	else
		e = sphereharmonic_dipole(&s, report);
	if (!e)
		e = sphereharmonic_alternate(&s, times ? times : COLD, report);
	if (!e)
		sphereplace_put(n, s.z, m->Z);
	sphereharmonic_free(&s);
	return e;
}

/* The same.  If the matrix is indefinite, or faces are turned over, solves with the weights of the intrinsic Delaunay
 * triangulation, and takes the map with fewer turned faces. */
static int
solve(SphereMap *m, int elements, const Disk *coarse, int times, SpdReport *report)
{
	size_t size = m->mesh.d.m.nv*sizeof *m->Z;
	Spinor *start = malloc(size), *first;
	int turned = INT_MAX, e;

	if (!start)
		return SPD_ENOMEM;
	memcpy(start, m->Z, size);
	e = solve_by(m, elements, coarse, times, report);
	if (!e)
		sphereface_beltrami(&m->mesh.d.m, m->Z, &m->mu, &turned);
	m->turned = turned;
	m->quadratic = elements == SPHEREHARMONIC_QUADRATIC;
	if ((!e && !turned) || (e && e != SPD_EINDEFINITE)) {
		free(start);
		return e;
	}
	first = m->Z;
	m->Z = start;
	e = solve_by(m, SPHEREHARMONIC_INTRINSIC, NULL, times, report);
	if (!e)
		sphereface_beltrami(&m->mesh.d.m, m->Z, &m->mu, &m->turned);
	if (e || m->turned >= turned) {
		e = turned < INT_MAX ? 0 : e;
		m->Z = first, first = start;
		m->turned = turned;
	} else
		m->quadratic = 0;
	free(first);
	return e;
}

/* Splits the faces with the largest terms, if the certificate is above the tolerance.  Returns the number of
 * new vertices, or SPD_ENOMEM. */
static int
refine(SphereMap *m, const AdaptOptions *o)
{
	int nf = m->mesh.d.m.nf, nv = m->mesh.d.m.nv, t, e;
	double *terms = malloc(2*(size_t)nf*sizeof *terms), least;
	unsigned char *marked = malloc(nf);

	e = terms && marked ? 0 : SPD_ENOMEM;
	for (m->certificate = 0, t = 0; !e && t < nf; t++)
		m->certificate += terms[t] = sphereface_term(&m->mesh.d.m, m->Z, t);
	m->certificate /= mesh_area(&m->mesh.d.m);
	if (!e && m->certificate > o->tolerance && nv < o->most) {
		least = worst_terms(terms, nf, (o->most - nv)/2, terms + nf);
		for (t = 0; t < nf; t++)
			marked[t] = terms[t] >= least;
		e = subdivision_refine(&m->mesh, marked, NULL, NULL) ? SPD_ENOMEM : m->mesh.d.m.nv - nv;
	}
	free(terms);
	free(marked);
	return e;
}

/* Splits every face into four, and solves by quadratic elements. */
static int
solve_quadratic(SphereMap *m, SpdReport *report)
{
	int nv = m->mesh.d.m.nv, e;
	Disk coarse = { 0 };

	e = subdivision_refine(&m->mesh, NULL, NULL, &coarse) || extend(m, nv) ? SPD_ENOMEM
	    : solve(m, SPHEREHARMONIC_QUADRATIC, &coarse, COLD, report);
	disk_free(&coarse);
	return e;
}

/* Solves by linear elements, and splits faces until the certificate is small enough, there are o->most vertices, or no
 * face can be split. */
static int
solve_linear(SphereMap *m, const AdaptOptions *o, SpdReport *report)
{
	int nv = m->mesh.d.m.nv, times = 0, n = 1, e;

	m->Z = calloc(nv, sizeof *m->Z);
	e = m->Z ? 0 : SPD_ENOMEM;

	while (!e && n > 0) {
		e = solve(m, SPHEREHARMONIC_LINEAR, NULL, times, report);
		n = e ? 0 : refine(m, o);
		e = n < 0 ? n : e ? e : extend(m, nv);
		nv = m->mesh.d.m.nv;
		times = WARM;
	}
	return e;
}

int
sphere_map(const Disk *d, const AdaptOptions *o, SphereMap *m, SpdReport *report)
{
	int e, k;

	memset(m, 0, sizeof *m);
	memset(report, 0, sizeof *report);
	e = subdivision_init(&m->mesh, d) ? SPD_ENOMEM : 0;
	while (!e && m->mesh.d.m.nv < FEWEST)
		e = subdivision_refine(&m->mesh, NULL, NULL, NULL) ? SPD_ENOMEM : 0;
	if (!e)
		e = solve_linear(m, o, report);
	for (k = 0; !e && k < o->split && m->mesh.d.m.nv <= o->most/4; k++)
		e = solve_quadratic(m, report);
	if (!e)
		sphereface_beltrami(&m->mesh.d.m, m->Z, &m->mu, &m->turned);
	else
		sphere_free(m);
	return e;
}

void
sphere_free(SphereMap *m)
{
	subdivision_free(&m->mesh);
	free(m->Z);
	m->Z = NULL;
}
