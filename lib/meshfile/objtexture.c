/* objtexture.c - the images at the corners of faces, collected and found again. */
#include <stdlib.h>

#include "../base/chart.h"
#include "../mesh/channel.h"
#include "objtexture.h"

static int
is_plain(Sheet s)
{
	return s.sign == 1 && s.shift == 0;
}

static int
by_vertex(const void *a, const void *b)
{
	const ObjImage *x = a, *y = b;
	int d = (x->vertex > y->vertex) - (x->vertex < y->vertex);

	d = d ? d : x->far - y->far;
	d = d ? d : x->sheet.sign - y->sheet.sign;
	return d ? d : x->sheet.shift - y->sheet.shift;
}

/* The sheets of the n corners v of a face.  Returns 1 if it is nearer to a fold at v = T than to that at v = 0: then the sheets are
 * those of (u,T-v). */
static int
sheets(const Soup *s, int n, const int *v, Sheet *at)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	double x[OBJTEXTURE_CORNERS], y[OBJTEXTURE_CORNERS], sum = 0;
	int k, far;

	for (k = 0; k < n; k++) {
		x[k] = uv[2*(size_t)v[k]], y[k] = uv[2*(size_t)v[k]+1];
		sum += y[k];
	}
	far = s->chart->folded > 1 && 2*sum > n*s->T;
	for (k = 0; k < n && far; k++)
		y[k] = s->T - y[k];
	sheet_polygon(n, x, y, at);
	return far;
}

static int
append(ObjTexture *x, int vertex, int far, Sheet s)
{
	ObjImage *p;

	if (x->n == x->cap) {
		x->cap = 2*x->cap + 64;
		if (!(p = realloc(x->image, x->cap*sizeof *p)))
			return MESH_ENOMEM;
		x->image = p;
	}
	x->image[x->n++] = (ObjImage){ vertex, far, s };
	return 0;
}

static int
collect(ObjTexture *x, const Soup *s)
{
	Sheet at[OBJTEXTURE_CORNERS];
	const int *v;
	int f, k, n, far;

	for (f = 0; f < s->nf; f++) {
		n = text_corners(s, f, &v);
		if (n > OBJTEXTURE_CORNERS)
			continue;
		far = sheets(s, n, v, at);
		for (k = 0; k < n; k++)
			if (!is_plain(at[k]) && append(x, v[k], far, at[k]))
				return MESH_ENOMEM;
	}
	return 0;
}

int
objtexture_init(ObjTexture *x, const Soup *s)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	size_t i, n = 0;

	*x = (ObjTexture){ 0 };
	if (!uv || !s->chart || !s->chart->folded || !(s->T > 0))       /* without T the chart is not written */
		return 0;
	if (collect(x, s)) {
		objtexture_free(x);
		return MESH_ENOMEM;
	}
	if (x->n)
		qsort(x->image, x->n, sizeof *x->image, by_vertex);
	for (i = 0; i < x->n; i++)
		if (n == 0 || by_vertex(&x->image[n-1], &x->image[i]))
			x->image[n++] = x->image[i];
	x->n = n;
	return 0;
}

void
objtexture_free(ObjTexture *x)
{
	free(x->image);
	*x = (ObjTexture){ 0 };
}

int
objtexture_lines(const ObjTexture *x, Text *t, const Soup *s)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	size_t i;

	for (i = 0; i < x->n; i++) {
		const ObjImage *m = &x->image[i];
		double u = uv[2*(size_t)m->vertex], v = uv[2*(size_t)m->vertex+1], T = s->T;
		double at[2] = { sheet_u(m->sheet, u), m->far ? T - sheet_v(m->sheet, T - v) : sheet_v(m->sheet, v) };

		if (text_lines(t, at, 1, 2, "vt "))
			return MESH_ENOMEM;
	}
	return 0;
}

void
objtexture_face(const ObjTexture *x, const Soup *s, int n, const int *v, int *vt)
{
	const ObjImage *found;
	Sheet at[OBJTEXTURE_CORNERS];
	int k, far;

	for (k = 0; k < n; k++)
		vt[k] = v[k];
	if (!x->n)
		return;
	far = sheets(s, n, v, at);
	for (k = 0; k < n; k++) {
		ObjImage key = { v[k], far, at[k] };

		if (is_plain(at[k]))
			continue;
		found = bsearch(&key, x->image, x->n, sizeof key, by_vertex);
		vt[k] = s->nv + (int)(found - x->image);
	}
}
