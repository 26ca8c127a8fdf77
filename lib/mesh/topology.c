/* topology.c - connectivity of a triangle mesh: orientation, components, fans, the boundary
 * loop. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "topology.h"

static int
prev(int side)
{
	return side % 3 == 0 ? side + 2 : side - 1;
}

/* Decides whether the neighbours of face f are turned, and appends those not decided before to
 * queue.  A neighbour is turned like f if the common edge runs in opposite directions in the two
 * faces. */
static int
orient_neighbours(const Topology *t, int f, signed char *turn, int *queue, int *end)
{
	int i, g, turned, a, b;

	for (i = 3*f; i < 3*f + 3; i++) {
		if (t->twin[i] < 0)
			continue;
		g = t->twin[i] / 3;
		turned = turn[f] ^ (topology_from(t, i) == topology_from(t, t->twin[i]));
		if (turn[g] < 0) {
			turn[g] = (signed char)turned;
			queue[(*end)++] = g;
		} else if (turn[g] != turned) {
			a = topology_name(t, topology_from(t, i));
			b = topology_name(t, topology_to(t, i));
			return mesh_fail(t->err, MESH_EORIENT,
			    "surface is one-sided: no orientation agrees across edge %d-%d",
			    a < b ? a : b, a < b ? b : a);
		}
	}
	return 0;
}

int
topology_orient(const Topology *t, signed char *turn)
{
	int *queue = mesh_alloc(t->err, (size_t)t->nf, sizeof *queue);
	int f, head = 0, end = 0, e = queue ? 0 : MESH_ENOMEM;

	memset(turn, -1, (size_t)t->nf);
	for (f = 0; !e && f < t->nf; f++) {
		if (turn[f] >= 0)
			continue;
		turn[f] = 0;
		queue[end++] = f;
		while (!e && head < end)
			e = orient_neighbours(t, queue[head++], turn, queue, &end);
	}
	free(queue);
	return e;
}

static int
root(int *up, int v)
{
	while (up[v] != v)
		v = up[v] = up[up[v]];
	return v;
}

int
topology_connected(const Topology *t)
{
	int *up, i, a, b, v, parts = t->nv;

	up = mesh_alloc(t->err, (size_t)t->nv, sizeof *up);
	if (!up)
		return MESH_ENOMEM;
	for (v = 0; v < t->nv; v++)
		up[v] = v;
	for (i = 0; i < 3 * t->nf; i++) {
		if (t->twin[i] > i)
			continue;       /* visit each edge once */
		a = root(up, topology_from(t, i));
		b = root(up, topology_to(t, i));
		parts -= a != b;
		up[a > b ? a : b] = a > b ? b : a;
	}
	free(up);
	return parts == 1 ? 0 : mesh_fail(t->err, MESH_EDISK, "%d components, a disk is one", parts);
}

/* Marks the sides that start at the same vertex as `side`, in the fan of triangles round it:
 * turning first one way, then the other. */
static void
mark_fan(const Topology *t, int side, char *seen)
{
	int s;

	for (s = side; s >= 0 && !seen[s]; s = t->twin[prev(s)])
		seen[s] = 1;
	for (s = t->twin[side]; s >= 0 && !seen[topology_next(s)]; s = t->twin[topology_next(s)])
		seen[topology_next(s)] = 1;
}

int
topology_fans(const Topology *t)
{
	const size_t n = 3 * (size_t)t->nf;
	char *seen = mesh_alloc(t->err, n, 1);
	int *fans = mesh_alloc(t->err, (size_t)t->nv, sizeof *fans);
	int v, e = seen && fans ? 0 : MESH_ENOMEM;
	size_t i;

	if (!e) {
		memset(seen, 0, n);
		memset(fans, 0, (size_t)t->nv * sizeof *fans);
	}
	for (i = 0; !e && i < n; i++)
		if (!seen[i]) {
			mark_fan(t, (int)i, seen);
			fans[topology_from(t, (int)i)]++;
		}
	for (v = 0; !e && v < t->nv; v++)
		if (fans[v] != 1)
			e = mesh_fail(t->err, MESH_EMANIFOLD,
			    "vertex %d is pinched: %d fans of faces meet there; mesh2disk parts them",
			    topology_name(t, v), fans[v]);
	free(seen);
	free(fans);
	return e;
}

/* Sets out[v] to the boundary side that starts at v, or -1.  With one fan at each vertex there is
 * at most one such side.  Returns the number of boundary sides. */
static int
boundary_sides(const Topology *t, int *out)
{
	int i, n = 0;

	memset(out, -1, (size_t)t->nv * sizeof *out);
	for (i = 0; i < 3 * t->nf; i++)
		if (t->twin[i] < 0)
			out[topology_from(t, i)] = i, n++;
	return n;
}

/* Follows the loop from vertex v and removes its sides from out.  Stores its vertices in `loop`,
 * unless that is NULL.  Returns how many vertices it has. */
static int
follow_loop(const Topology *t, int *out, int v, int *loop)
{
	int n, side;

	for (n = 0; (side = out[v]) >= 0; n++) {
		if (loop)
			loop[n] = v;
		out[v] = -1;
		v = topology_to(t, side);
	}
	return n;
}

/* Fails if out still has loops beside the first, which began at vertex v and was removed.  The
 * message names a vertex of each loop, at most four. */
static int
check_one_loop(const Topology *t, int *out, int v)
{
	char where[80];
	int n = 1, len;

	len = snprintf(where, sizeof where, "%d", topology_name(t, v));
	for (v = 0; v < t->nv; v++)
		if (out[v] >= 0) {
			follow_loop(t, out, v, NULL);
			if (++n <= 4)
				len += snprintf(where + len, sizeof where - (size_t)len, ", %d",
				    topology_name(t, v));
		}
	if (n == 1)
		return 0;
	return mesh_fail(t->err, MESH_EDISK, "%d boundary loops, a disk has one: at vertices %s%s; mesh2disk "
	    "fills all but the longest",
	    n, where, n > 4 ? ", .." : "");
}

/* Checks that the genus is 0, by Euler's formula V - E + F = 2 - 2 genus - loops.  There is one
 * loop, so the sum is 1 for a disk. */
static int
check_genus(const Topology *t)
{
	const int chi = t->nv - t->nedge + t->nf;

	return chi == 1 ? 0 : mesh_fail(t->err, MESH_EDISK, "genus %d: a disk has no handles; mesh2disk "
	    "--handles=cut cuts them",
	    (1 - chi) / 2);
}

int
topology_loop(const Topology *t, int **loop, int *nb)
{
	int *out, v, n, e;

	out = mesh_alloc(t->err, (size_t)t->nv, sizeof *out);
	if (!out)
		return MESH_ENOMEM;
	n = boundary_sides(t, out);
	*loop = n > 0 ? mesh_alloc(t->err, (size_t)n, sizeof **loop) : NULL;
	if (n == 0) {
		e = mesh_fail(t->err, MESH_EDISK, "closed surface: no boundary; mesh2disk --open=auto cuts it open");
	} else if (!*loop) {
		e = MESH_ENOMEM;
	} else {
		for (v = 0; out[v] < 0; v++)
			continue;
		*nb = follow_loop(t, out, v, *loop);
		if ((e = check_one_loop(t, out, v)) == 0)
			e = check_genus(t);
	}
	free(out);
	if (e) {
		free(*loop);
		*loop = NULL;
		*nb = 0;
	}
	return e;
}

int
topology_is_closed(const Topology *t)
{
	return 2*(size_t)t->nedge == 3*(size_t)t->nf;
}

/* Euler's formula: V - E + F = 2 - 2 genus. */
int
topology_genus(const Topology *t)
{
	return (2 - (t->nv - t->nedge + t->nf))/2;
}
