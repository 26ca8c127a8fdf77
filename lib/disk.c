/* disk.c - from a polygon soup to a disk, or the true reason why not. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "disk.h"
#include "meshpriv.h"
#include "polygon.h"
#include "repair.h"
#include "topology.h"

/* file[v] is the number that vertex v of d->m has in the file. */
typedef struct Build {
	Disk *d;
	int  *file;
} Build;

static void
addnote(Disk *d, const char *fmt, ...)
{
	size_t n = strlen(d->note);
	va_list ap;

	if (n > 0)
		n += (size_t)snprintf(d->note + n, sizeof d->note - n, "; ");
	va_start(ap, fmt);
	vsnprintf(d->note + n, sizeof d->note - n, fmt, ap);
	va_end(ap);
}

static int
checkcorners(const Soup *s, char *err)
{
	int f, i;

	for (f = 0; f < s->nf; f++)
		for (i = s->first[f]; i < s->first[f+1]; i++)
			if (s->idx[i] < 0 || s->idx[i] >= s->nv)
				return mesh_fail(err, MESH_EINDEX, "face %d names vertex %d of %d",
				    f, s->idx[i], s->nv);
	return 0;
}

static int
checkfinite(const Soup *s, char *err)
{
	size_t i;

	for (i = 0; i < 3*(size_t)s->nv; i++)
		if (!isfinite(s->xyz[i]))
			return mesh_fail(err, MESH_EVALUE,
			    "vertex %zu has a coordinate that is not finite", i/3);
	return 0;
}

/* Number the vertices anew: vertex v becomes to[v] < nnew, or goes where that is -1.
 * Of several that become one, the first gives position and name. */
static void
renumber(Build *b, const int *to, int nnew)
{
	Mesh *m = &b->d->m;
	int v, done = 0;
	size_t i;

	for (v = 0; v < m->nv; v++)
		if (to[v] == done) {
			memmove(m->xyz + 3*(size_t)done, m->xyz + 3*(size_t)v, 3 * sizeof *m->xyz);
			b->file[done++] = b->file[v];
		}
	for (i = 0; i < 3*(size_t)m->nf; i++)
		m->tri[i] = to[m->tri[i]];
	m->nv = nnew;
}

static void
dropunused(Build *b, int *to)
{
	Mesh *m = &b->d->m;
	const int before = m->nv;
	int v, n = 0;
	size_t i;

	memset(to, -1, (size_t)m->nv * sizeof *to);
	for (i = 0; i < 3*(size_t)m->nf; i++)
		to[m->tri[i]] = 0;
	for (v = 0; v < m->nv; v++)
		if (to[v] == 0)
			to[v] = n++;
	if (n == before)
		return;
	renumber(b, to, n);
	addnote(b->d, "%d unreferenced %s dropped", before - n,
	    before - n == 1 ? "vertex" : "vertices");
}

/* Do the faces, two or more, share no vertex at all? */
static int
issoup(const Soup *s, int *used)
{
	int i;

	memset(used, 0, (size_t)s->nv * sizeof *used);
	for (i = 0; i < s->first[s->nf]; i++)
		if (used[s->idx[i]]++)
			return 0;
	return s->nf > 1;
}

static int
weld(Build *b, int *to)
{
	Mesh *m = &b->d->m;
	const int before = m->nv;
	int n, e = repair_weld(m->nv, m->xyz, to, &n);

	if (e)
		return mesh_fail(b->d->err, MESH_ENOMEM, "no memory to weld %d vertices", m->nv);
	if (n == before)
		return 0;
	renumber(b, to, n);
	addnote(b->d, "%d vertices of a soup welded to %d", before, n);
	return 0;
}

/* Turn the faces marked in turn, or all others if the marked ones are the most.
 * Returns how many. */
static int
turnfaces(Mesh *m, const signed char *turn)
{
	int f, n = 0, most, t;

	for (f = 0; f < m->nf; f++)
		n += turn[f];
	most = n > m->nf - n;
	for (f = 0; f < m->nf; f++)
		if (turn[f] != most) {
			int *c = m->tri + 3*(size_t)f;

			t = c[1], c[1] = c[2], c[2] = t;
		}
	return most ? m->nf - n : n;
}

/* Make neighbours agree. */
static int
orient(Disk *d, Topology *t)
{
	signed char *turn = mesh_alloc(d->err, (size_t)d->m.nf, 1);
	int e, n;

	if (!turn)
		return MESH_ENOMEM;
	if ((e = topology_orient(t, turn)) == 0) {
		n = turnfaces(&d->m, turn);
		addnote(d, "%d of %d faces were turned to agree with the rest", n, d->m.nf);
		free(t->twin);
		e = topology_twins(t);
	}
	free(turn);
	return e;
}

static int
checkdisk(Build *b)
{
	Disk *d = b->d;
	Topology t = { .nv = d->m.nv, .nf = d->m.nf, .tri = d->m.tri, .file = b->file, .err = d->err };
	int e;

	if ((e = topology_twins(&t)) != 0)
		return e;
	if (t.odd)
		e = orient(d, &t);
	if (!e && (e = topology_connected(&t)) == 0 && (e = topology_fans(&t)) == 0)
		e = topology_loop(&t, &d->loop, &d->nb);
	free(t.twin);
	return e;
}

static int
build(Build *b, const Soup *s, int *scratch)
{
	Mesh *m = &b->d->m;
	int e, v;

	if ((e = polygon_split(s, &m->tri, &m->nf, b->d->err)) != 0)
		return e;
	m->xyz = mesh_alloc(b->d->err, (size_t)s->nv, 3 * sizeof *m->xyz);
	if (!m->xyz)
		return MESH_ENOMEM;
	m->nv = s->nv;
	memcpy(m->xyz, s->xyz, 3 * (size_t)s->nv * sizeof *m->xyz);
	for (v = 0; v < s->nv; v++)
		b->file[v] = v;
	dropunused(b, scratch);
	if (issoup(s, scratch) && (e = weld(b, scratch)) != 0)
		return e;
	return checkdisk(b);
}

int
disk_from_soup(Disk *d, const Soup *s)
{
	Build b = { d, NULL };
	int *scratch, e;

	memset(d, 0, sizeof *d);
	if ((e = checkcorners(s, d->err)) != 0 || (e = checkfinite(s, d->err)) != 0)
		return e;
	if (s->nf == 0)
		return mesh_fail(d->err, MESH_EDISK, "no faces: nothing to be a disk");
	b.file = mesh_alloc(d->err, (size_t)s->nv, sizeof *b.file);
	scratch = mesh_alloc(d->err, (size_t)s->nv, sizeof *scratch);
	e = b.file && scratch ? build(&b, s, scratch) : MESH_ENOMEM;
	free(b.file);
	free(scratch);
	if (e)
		disk_free(d);
	return e;
}
