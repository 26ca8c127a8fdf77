/* matching.c - correspondence of two borders by landmarks and arc length. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matching.h"
#include "../base/vec3.h"

/* The nodes and landmarks of a border, in counterclockwise order.  A point has the key i + f if it
 * lies between landmarks i and i + 1, at the fraction f of the arc length between them.  r is its
 * place, x its position. */
typedef struct Keyed {
	int     n;
	double *key, *r, *x;
} Keyed;

/* The distance counterclockwise from one place to another, 0 .. 4. */
static double
ahead(double from, double to)
{
	return to >= from ? to - from : to - from + 4;
}

int
matching_order(int n, const double *place)
{
	int i;

	for (i = 1; i < n; i++)
		if (!(ahead(place[0], place[i]) > ahead(place[0], place[i-1])))
			return i;
	return n;
}

static double
arc(const Border *b, double r)
{
	return r < 4 ? border_arc(b, r) : border_arc(b, r - 4) + b->s[b->n];
}

static void
append(Keyed *l, double key, double r, const double x[3])
{
	l->key[l->n] = key;
	l->r[l->n] = r;
	memcpy(l->x + 3*l->n, x, 3*sizeof *x);
	l->n++;
}

/* Appends landmark i and the nodes between landmarks i and i + 1.  The search for nodes starts at
 * node *k; on return *k is the first node at or after landmark i + 1.  *k goes on counting after a
 * full turn: b->n is node 0 again. */
static int
append_part(Keyed *l, const Border *b, int n, const double *p, int i, int *k)
{
	double from = p[0] + ahead(p[0], p[i]), to = i + 1 < n ? p[0] + ahead(p[0], p[i+1]) : p[0] + 4;
	double s = arc(b, from), length = arc(b, to) - s, x[3], r;

	if (!(length > 1e-12*b->s[b->n]))
		return MATCHING_ELENGTH;
	border_at(b, p[i], x);
	append(l, i, from, x);                                          /* (33) */
	for (;; ++*k) {
		r = border_place(b, *k%b->n) + (*k >= b->n ? 4 : 0);
		if (r >= to)
			break;
		if (r > from)
			append(l, i + fmin((arc(b, r) - s)/length, 1), r,
			    b->x + 3*(*k%b->n));                                /* (34) */
	}
	return 0;
}

static void
keyed_free(Keyed *l)
{
	free(l->key);
	free(l->r);
	free(l->x);
}

static int
keyed_init(Keyed *l, const Border *b, int n, const double *p, int *at)
{
	size_t most = (size_t)b->n + n + 1;
	int i, k = 0, e = 0;

	*l = (Keyed){ 0, malloc(most*sizeof(double)), malloc(most*sizeof(double)),
	    malloc(3*most*sizeof(double)) };
	if (!l->key || !l->r || !l->x)
		e = MATCHING_ENOMEM;
	while (!e && border_place(b, k) <= p[0] && k < b->n)
		k++;
	for (i = 0; i < n && !e; i++)
		if ((e = append_part(l, b, n, p, i, &k)))
			*at = i;
	if (!e)
		append(l, n, p[0] + 4, l->x);
	else
		keyed_free(l);
	return e;
}

/* Sets entry m->n of curve k of m to the point of l with the given key, which is entry i or lies
 * between entries i - 1 and i. */
static void
put_key(Matching *m, int k, const Keyed *l, int i, double key)
{
	double w = l->key[i] > key ? (key - l->key[i-1])/(l->key[i] - l->key[i-1]) : 1;
	const double *p, *q = l->x + 3*i;
	int c;

	m->r[k][m->n] = l->r[i];
	memcpy(m->x[k] + 3*m->n, q, 3*sizeof *q);
	if (w == 1)
		return;
	p = l->x + 3*(i - 1);
	m->r[k][m->n] = (1 - w)*l->r[i-1] + w*l->r[i];
	for (c = 0; c < 3; c++)
		m->x[k][3*m->n + c] = (1 - w)*p[c] + w*q[c];
}

/* Merges both lists by their keys.  The last keys of the lists are equal, so both end together. */
static void
merge(Matching *m, const Keyed *a, const Keyed *b)
{
	double key;
	int i = 0, j = 0;

	while (i < a->n && j < b->n) {
		key = fmin(a->key[i], b->key[j]);
		put_key(m, 0, a, i, key);
		put_key(m, 1, b, j, key);
		m->n++;
		if (a->key[i] == b->key[j]) {
			i++;
			j++;
		} else if (a->key[i] == key)
			i++;
		else
			j++;
	}
}

static int
matching_alloc(Matching *m, size_t n)
{
	int k;

	m->n = 0;
	for (k = 0; k < 2; k++) {
		m->r[k] = malloc(n*sizeof(double));
		m->x[k] = malloc(3*n*sizeof(double));
	}
	if (m->r[0] && m->r[1] && m->x[0] && m->x[1])
		return 0;
	matching_free(m);
	return MATCHING_ENOMEM;
}

/* Adds a multiple of 4, that is, full turns, to the places on b, so that on average the pairs move
 * the shorter way round. */
static void
add_turns(Matching *m)
{
	double sum = 0, turn;
	int i;

	for (i = 0; i < m->n; i++)
		sum += m->r[0][i] - m->r[1][i];
	turn = 4*round(sum/m->n/4);
	for (i = 0; i < m->n; i++)
		m->r[1][i] += turn;
}

int
matching_init(Matching *m, const Border *a, const Border *b, int n, const double *p, const double *q,
	int *at)
{
	Keyed la, lb;
	int e;

	if ((e = keyed_init(&la, a, n, p, at)))
		return e;
	if ((e = keyed_init(&lb, b, n, q, at))) {
		keyed_free(&la);
		return e;
	}
	if (!(e = matching_alloc(m, (size_t)la.n + lb.n))) {
		merge(m, &la, &lb);
		add_turns(m);
	}
	keyed_free(&la);
	keyed_free(&lb);
	return e;
}

int
matching_conformal(Matching *m, const Border *a, const Border *b)
{
	int i;

	if (matching_alloc(m, (size_t)a->n + 1))
		return MATCHING_ENOMEM;
	m->n = a->n + 1;
	for (i = 0; i < m->n; i++) {
		m->r[0][i] = m->r[1][i] = border_place(a, i);
		memcpy(m->x[0] + 3*i, a->x + 3*(i%a->n), 3*sizeof(double));
		memcpy(m->x[1] + 3*i, b->x + 3*(i%b->n), 3*sizeof(double));
	}
	return 0;
}

void
matching_free(Matching *m)
{
	int k;

	for (k = 0; k < 2; k++) {
		free(m->r[k]);
		free(m->x[k]);
	}
	memset(m, 0, sizeof *m);
}

void
matching_weights(const Matching *m, double *w)
{
	double length, e[3];
	int i, k, pass;

	for (i = 0; i < m->n; i++)
		w[i] = 0;
	for (k = 0; k < 2; k++)
		for (length = 0, pass = 0; pass < 2; pass++)
			for (i = 0; i + 1 < m->n; i++) {
				sub3(m->x[k] + 3*(i + 1), m->x[k] + 3*i, e);
				if (pass) {
					w[i] += norm3(e)/length/2;
					w[i+1] += norm3(e)/length/2;
				} else
					length += norm3(e);
			}
}

void
matching_at(const Matching *m, double t, double r, double x[3])
{
	double first = (1 - t)*m->r[0][0] + t*m->r[1][0], lo_r, hi_r, w, xa, xb;
	int lo = 0, hi = m->n - 1, mid, c;

	r += 4*ceil((first - r)/4);
	while (hi - lo > 1) {
		mid = (lo + hi)/2;
		if ((1 - t)*m->r[0][mid] + t*m->r[1][mid] <= r)
			lo = mid;
		else
			hi = mid;
	}
	lo_r = (1 - t)*m->r[0][lo] + t*m->r[1][lo];
	hi_r = (1 - t)*m->r[0][hi] + t*m->r[1][hi];
	w = hi_r > lo_r ? fmax(0, fmin((r - lo_r)/(hi_r - lo_r), 1)) : 0;
	for (c = 0; c < 3; c++) {
		xa = (1 - w)*m->x[0][3*lo+c] + w*m->x[0][3*hi+c];
		xb = (1 - w)*m->x[1][3*lo+c] + w*m->x[1][3*hi+c];
		x[c] = (1 - t)*xa + t*xb;                               /* (20) */
	}
}
