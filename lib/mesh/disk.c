/* disk.c - makes a disk of a polygon soup, or gives the reason why this is impossible. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "channel.h"
#include "disk.h"
#include "fail.h"
#include "polygon.h"
#include "remedy.h"
#include "repair.h"
#include "topology.h"

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
				return mesh_fail(err, MESH_EINDEX, "face %d refers to vertex %d, there are %d",
				    f, s->idx[i], s->nv);
	return 0;
}

static int
checkfinite(const Soup *s, char *err)
{
	int i, c;

	for (i = 0; i < s->first[s->nf]; i++)
		for (c = 0; c < 3; c++)
			if (!isfinite(s->xyz[3*(size_t)s->idx[i] + (size_t)c]))
				return mesh_fail(err, MESH_EVALUE,
				    "vertex %d has a coordinate that is not finite; mesh2disk drops its faces", s->idx[i]);
	return 0;
}

/* Renumbers the vertices: vertex v becomes to[v] < nnew, or is dropped if to[v] is -1.  The new
 * numbers must first appear in ascending order.  A vertex made of several has the position and the
 * number in the file of the first. */
static void
renumber(Disk *d, const int *to, int nnew)
{
	Mesh *m = &d->m;
	int v, done = 0;
	size_t i;

	for (v = 0; v < m->nv; v++)
		if (to[v] == done) {
			memmove(m->xyz + 3*(size_t)done, m->xyz + 3*(size_t)v, 3 * sizeof *m->xyz);
			d->file[done++] = d->file[v];
		}
	for (v = 0; v < d->nfile; v++)
		if (d->became[v] >= 0)
			d->became[v] = to[d->became[v]];
	for (i = 0; i < 3*(size_t)m->nf; i++)
		m->tri[i] = to[m->tri[i]];
	m->nv = nnew;
}

static void
dropunused(Disk *d, int *to)
{
	Mesh *m = &d->m;
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
	renumber(d, to, n);
	addnote(d, "%d unreferenced %s dropped", before - n,
	    before - n == 1 ? "vertex" : "vertices");
}

/* Whether there are several faces, and no vertex belongs to two of them. */
static int
no_vertex_shared(const Soup *s, int *used)
{
	int i;

	memset(used, 0, (size_t)s->nv * sizeof *used);
	for (i = 0; i < s->first[s->nf]; i++)
		if (used[s->idx[i]]++)
			return 0;
	return s->nf > 1;
}

static int
weld(Disk *d, int *to)
{
	Mesh *m = &d->m;
	const int before = m->nv;
	int n, e = repair_weld(m->nv, m->xyz, to, &n);

	if (e)
		return mesh_fail(d->err, MESH_ENOMEM, "no memory to weld %d vertices", m->nv);
	if (n == before)
		return 0;
	renumber(d, to, n);
	addnote(d, "%d vertices of a soup welded to %d", before, n);
	return 0;
}

/* Turns the marked faces; or, if more than half are marked, all others.  Returns how many it
 * turned. */
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

/* Turns faces so that neighbours agree, then computes the twins again. */
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

/* Checks that there is one component and that every vertex has one fan of faces, in two threads. */
static int
check_pieces(const Topology *t)
{
	char err[MESH_ERRLEN];
	Topology other = *t;
	int e = 0, e1 = 0;

	other.err = err;
#pragma omp parallel sections
	{
#pragma omp section
		e = topology_connected(t);
#pragma omp section
		e1 = topology_fans(&other);
	}
	if (!e && e1)
		memcpy(t->err, err, sizeof err);
	return e ? e : e1;
}

/* What from_soup makes: a disk; a disk or a closed surface of genus 0; or any faces. */
typedef enum Wanted { DISK, DISK_OR_CLOSED, LOOSE } Wanted;

static int
check_closed(Disk *d, const Topology *t)
{
	int genus = topology_genus(t);

	if (genus > 0)
		return mesh_fail(d->err, MESH_EDISK, "a closed surface with %d handle%s, a sphere has none; mesh2disk "
		    "--handles=cut cuts them", genus, genus == 1 ? "" : "s");
	d->loop = mesh_alloc(d->err, 1, sizeof *d->loop);
	return d->loop ? 0 : MESH_ENOMEM;
}

static int
checkdisk(Disk *d, Wanted wanted)
{
	Topology t = { .nv = d->m.nv, .nf = d->m.nf, .tri = d->m.tri, .file = d->file, .err = d->err };
	int e;

	if ((e = topology_twins(&t)) != 0)
		return e;
	if (t.odd)
		e = orient(d, &t);
	if (!e && (e = check_pieces(&t)) == MESH_EDISK)
		e = remedy_close(&t, d->m.xyz, remedy_components(&t, d->m.xyz, e));
	else if (!e && wanted == DISK_OR_CLOSED && topology_is_closed(&t))
		e = check_closed(d, &t);
	else if (!e && (e = topology_loop(&t, &d->loop, &d->nb)) == MESH_EDISK)
		e = remedy_close(&t, d->m.xyz, e);
	d->twin = t.twin;
	return e;
}

/* Splits the faces into triangles; if loose, only the faces that can be split. */
static int
split_faces(Disk *d, const Soup *s, int loose)
{
	char reason[MESH_ERRLEN];
	int out, e;

	if (!loose) {
		e = polygon_split(s, &d->m.tri, &d->m.nf, d->err);
		return e == MESH_EFACE ? remedy(d->err, e, "takes it out") : e;
	}
	if ((e = polygon_split_some(s, &d->m.tri, &d->m.nf, &out, reason)) != 0)
		return mesh_fail(d->err, e, "%s", reason);
	if (out)
		addnote(d, "%d %s left out: %s", out, out == 1 ? "face is" : "faces are", reason);
	return d->m.nf ? 0 : mesh_fail(d->err, MESH_EFACE, "no face has area");
}

static int
build(Disk *d, const Soup *s, Wanted wanted, int *scratch)
{
	Mesh *m = &d->m;
	int e, v, loose = wanted == LOOSE;

	if ((e = split_faces(d, s, loose)) != 0)
		return e;
	m->xyz = mesh_alloc(d->err, (size_t)s->nv, 3 * sizeof *m->xyz);
	d->file = mesh_alloc(d->err, (size_t)s->nv, sizeof *d->file);
	d->became = mesh_alloc(d->err, (size_t)s->nv, sizeof *d->became);
	if (!m->xyz || !d->file || !d->became)
		return MESH_ENOMEM;
	m->nv = d->nfile = s->nv;
	memcpy(m->xyz, s->xyz, 3 * (size_t)s->nv * sizeof *m->xyz);
	for (v = 0; v < s->nv; v++)
		d->file[v] = d->became[v] = v;
	dropunused(d, scratch);
	if (no_vertex_shared(s, scratch) && (e = weld(d, scratch)) != 0)
		return e;
	if (channels_gather(&d->channels, &s->channels, m->nv, d->file, 0))
		return mesh_fail(d->err, MESH_ENOMEM, "no memory for the channels of %d vertices", m->nv);
	if (loose || (e = checkdisk(d, wanted)) != 0)
		return loose ? 0 : e;
	if (d->nb == 0 && disk_turn_outwards(d))
		addnote(d, "the faces were turned: their normals pointed inwards");
	if ((v = d->nb ? remedy_coincident(d) : 0) < 0)
		return v;
	if (v > 0)
		addnote(d, "%d boundary %s at the place of others: a cut, or a seam, which mesh2disk welds", v,
		    v == 1 ? "vertex lies" : "vertices lie");
	return 0;
}

static int
from_soup(Disk *d, const Soup *s, Wanted wanted)
{
	int *scratch, e;

	memset(d, 0, sizeof *d);
	if ((e = checkcorners(s, d->err)) != 0 || (e = checkfinite(s, d->err)) != 0)
		return e;
	if (s->nf == 0)
		return mesh_fail(d->err, MESH_EDISK, "no faces");
	scratch = mesh_alloc(d->err, (size_t)s->nv, sizeof *scratch);
	e = scratch ? build(d, s, wanted, scratch) : MESH_ENOMEM;
	free(scratch);
	if (e)
		disk_free(d);
	return e;
}

int
disk_from_soup(Disk *d, const Soup *s)
{
	return from_soup(d, s, DISK);
}

int
disk_or_closed(Disk *d, const Soup *s)
{
	return from_soup(d, s, DISK_OR_CLOSED);
}

int
disk_loose(Disk *d, const Soup *s)
{
	return from_soup(d, s, LOOSE);
}
