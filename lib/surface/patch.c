/* patch.c - the choice of the unresolved nodes, and the pattern of their matrix. */
#include <stdlib.h>
#include <string.h>

#include "../grid/stencil.h"
#include "patchnode.h"

static const double RESOLVED = 0.3;     /* weight o from which the plate preconditions well enough */
static const double SHARE = 0.01;       /* largest fraction of nodes chosen, without neighbours */
static const double FIRM = 4;           /* factor of the first two lines up to which it does: less time than
                                         * with 2 and with 1.3 */
static const double FIRM_PLACED = 1.5;  /* the same with a place: with 4 a ring of wrong H is left at the edge of S
                                         * by the few CG steps from there */
enum { BORDER = 4 };            /* nodes chosen are so many steps from a free border: its equations, which
                                 * p->row does not list, reach three rings, and S one node beyond them */

static int
by_size(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* The value of the weight o below which nodes are chosen. */
static double
threshold(const Misfit *m, double *o)
{
	Range columns = stencil_inner(m->g, 0), rows = stencil_inner(m->g, 1);
	size_t count = 0, most = SHARE*m->g.nu*m->g.nv, p;
	int i, j;

	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			p = (size_t)j*m->g.nu + i;
			if (m->o[p] < RESOLVED)
				o[count++] = m->o[p];
		}
	if (count <= most)
		return RESOLVED;
	qsort(o, count, sizeof *o, by_size);
	return o[most];
}

/* Neighbour k of node (i,j): 0 is the node itself, then east, west, north, south. */
static int
beside(Chart g, int i, int j, int k)
{
	static const int di[BESIDE] = { 0, 1, -1, 0, 0 }, dj[BESIDE] = { 0, 0, 0, 1, -1 };
	int sign = 1;

	return (int)stencil_node(g, i + di[k], j + dj[k], &sign);
}

/* Numbers the nodes of S from 0 on; number is -1 at all others.  Returns 0 or PATCH_ENOMEM. */
static int
choose(Patch *p)
{
	Chart g = p->m->g;
	int rings = p->m->free ? BORDER : 1;
	Range columns = stencil_apart(g, 0, rings), rows = stencil_apart(g, 1, rings);
	double *o = malloc((size_t)g.nu*g.nv*sizeof *o), below, firm = p->m->place ? FIRM_PLACED : FIRM;
	int i, j, a, b, q, sign = 1;

	if (!o)
		return PATCH_ENOMEM;
	below = p->m->free ? 0 : threshold(p->m, o);
	free(o);
	for (q = 0; q < g.nu*g.nv; q++)
		p->number[q] = -1;
	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			q = j*g.nu + i;
			if (!(p->m->o[q] < below || (p->m->firm && p->m->firm[q] > firm)))
				continue;
			for (b = j - 1; b <= j + 1; b++)
				for (a = i - 1; a <= i + 1; a++) {
					q = (int)stencil_node(g, a, b, &sign);
					if (stencil_is_inner(g, q%g.nu, q/g.nu))
						p->number[q] = 0;
				}
		}
	for (q = 0; q < g.nu*g.nv; q++)
		if (p->number[q] == 0)
			p->number[q] = p->nodes++;
	return 0;
}

/* How many of the five nodes of `beside` are in S. */
static int
touching(const Patch *p, int i, int j)
{
	int k, count = 0;

	for (k = 0; k < BESIDE; k++)
		count += p->number[beside(p->m->g, i, j, k)] >= 0;
	return count;
}

/* Lists the rows: in pass 0 those that depend on nodes outside S too, in pass 1 the others.  Only counts
 * them if p->row is NULL. */
static void
list_rows(Patch *p)
{
	Range columns = stencil_inner(p->m->g, 0), rows = stencil_inner(p->m->g, 1);
	int pass, i, j, k, count;

	for (p->rows = 0, pass = 0; pass < 2; pass++) {
		for (j = rows.from; j < rows.to; j++)
			for (i = columns.from; i < columns.to; i++) {
				count = touching(p, i, j);
				if (!count || (count == BESIDE) != pass)
					continue;
				for (k = 0; p->row && k < BESIDE; k++)
					p->beside[BESIDE*p->rows+k] = beside(p->m->g, i, j, k);
				if (p->row)
					p->row[p->rows] = j*p->m->g.nu + i;
				p->rows++;
			}
		if (pass == 0)
			p->edge = p->rows;
	}
}

/* The pattern of A_SS, in 3 x 3 blocks: column b has blocks in the rows list[b][0], list[b][1], .. */
enum { MOST = 32 };             /* room for the blocks of a column: one for each node that shares a
                                 * five-point stencil with its node; at most 13 on the rectangle */

static int
find(const int *list, int count, int a)
{
	int k = 0;

	while (k < count && list[k] < a)
		k++;
	return k;
}

static void
insert(int *list, int *count, int a)
{
	int k = find(list, *count, a);

	if (k < *count && list[k] == a)
		return;
	memmove(list + k + 1, list + k, (*count - k)*sizeof *list);
	list[k] = a;
	++*count;
}

/* Sets a and b to the numbers of the two nodes of pair k of row r, 0 <= k < 25.  Returns whether both
 * are in S and block (a,b) is in the lower triangle. */
static int
pair(const Patch *p, int r, int k, int *a, int *b)
{
	*a = p->number[p->beside[BESIDE*r + k/BESIDE]];
	*b = p->number[p->beside[BESIDE*r + k%BESIDE]];
	return *b >= 0 && *a >= *b;
}

static int
lay_out(Patch *p)
{
	int *list = malloc((size_t)p->nodes*MOST*sizeof *list), *count = calloc(p->nodes, sizeof *count);
	int r, k, a, b, c, i, at = 0, blocks = 0, e = list && count ? 0 : PATCH_ENOMEM;

	for (r = 0; !e && r < p->rows; r++)
		for (k = 0; k < BESIDE*BESIDE; k++)
			if (pair(p, r, k, &a, &b))
				insert(list + (size_t)MOST*b, &count[b], a);
	for (b = 0; !e && b < p->nodes; b++)
		blocks += count[b];
	p->below = malloc((size_t)(9*blocks + 1)*sizeof *p->below);
	p->value = malloc((size_t)(9*blocks + 1)*sizeof *p->value);
	e = e || !p->below || !p->value ? PATCH_ENOMEM : 0;
	for (b = 0; !e && b < p->nodes; b++)
		for (c = 0; c < 3; c++) {
			p->column[3*b+c] = at;
			for (i = c; i < 3*count[b]; i++)
				p->below[at++] = 3*list[(size_t)MOST*b + i/3] + i%3;
		}
	p->column[3*p->nodes] = at;
	for (r = 0; !e && r < p->rows; r++)
		for (k = 0; k < BESIDE*BESIDE; k++)
			p->place[BESIDE*BESIDE*r+k] = pair(p, r, k, &a, &b)
			    ? find(list + (size_t)MOST*b, count[b], a) : -1;
	free(list);
	free(count);
	return e;
}

static int
allocate(Patch *p)
{
	size_t rows = p->rows;

	p->node = malloc(p->nodes*sizeof *p->node);
	p->row = malloc(rows*sizeof *p->row);
	p->beside = malloc(rows*BESIDE*sizeof *p->beside);
	p->place = malloc(rows*BESIDE*BESIDE*sizeof *p->place);
	p->J = malloc(rows*JACOBIAN*sizeof *p->J);
	p->s = malloc((size_t)(p->edge + 1)*NUMBERS*sizeof *p->s);
	p->b = malloc(3*(size_t)p->nodes*sizeof *p->b);
	p->column = malloc((3*(size_t)p->nodes + 1)*sizeof *p->column);
	return p->node && p->row && p->beside && p->place && p->J && p->s && p->b && p->column ? 0 : PATCH_ENOMEM;
}

int
patch_init(Patch *p, const Misfit *m)
{
	int n = m->g.nu*m->g.nv, q, e = 0;

	*p = (Patch){ .m = m, .number = malloc(n*sizeof *p->number) };
	if (!p->number || choose(p)) {
		patch_free(p);
		return PATCH_ENOMEM;
	}
	if (!p->nodes)
		return 0;
	list_rows(p);
	e = allocate(p);
	if (!e) {
		list_rows(p);
		for (q = 0; q < n; q++)
			if (p->number[q] >= 0)
				p->node[p->number[q]] = q;
		e = lay_out(p);
	}
	if (!e)
		p->factor = spd_factor_new(3*p->nodes, p->column, p->below);
	if (e || !p->factor) {
		patch_free(p);
		return PATCH_ENOMEM;
	}
	return 0;
}

void
patch_free(Patch *p)
{
	spd_factor_free(p->factor);
	free(p->number);
	free(p->node);
	free(p->row);
	free(p->beside);
	free(p->place);
	free(p->J);
	free(p->s);
	free(p->b);
	free(p->column);
	free(p->below);
	free(p->value);
	memset(p, 0, sizeof *p);
}
