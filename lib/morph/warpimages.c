/* warpimages.c - unit normals of two surfaces as images, and their mismatch under a map. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../grid/resample.h"
#include "../grid/stencil.h"
#include "warpimages.h"

/* The normals n[3] and the area element of a grid. */
static void
normals(Chart g, const double *const phi[3], double *const n[3], double *area)
{
	int j;

#pragma omp parallel for schedule(static)
	for (j = 0; j < g.nv; j++) {
		int i, c;

		for (i = 0; i < g.nu; i++) {
			size_t p = (size_t)j*g.nu + i;
			double u[3], v[3], x[3], len;

			stencil_tangents(g, phi, i, j, u, v);
			cross3(u, v, x);
			len = norm3(x);
			area[p] = len;
			for (c = 0; c < 3; c++)
				n[c][p] = len > 0 ? x[c]/len : 0;
		}
	}
}

/* One field on the nodes `to`, into every third number of out. */
static int
convert(Chart from, const double *f, Chart to, int mean, double *field, double *out, int stride)
{
	static const double whole[2] = { 1, 1 };
	int n = to.nu*to.nv, p;

	if (mean && from.nu >= to.nu && from.nv >= to.nv ? resample_mean(from, f, to, field) :
	    resample_cubic(from, whole, f, to, field))
		return WARPIMAGES_ENOMEM;
	for (p = 0; p < n; p++)
		out[p*stride] = field[p];
	return 0;
}

static int
fill(WarpSurface *s, Chart g, const double *const phi[3], double *work, double *field)
{
	size_t n = (size_t)g.nu*g.nv;
	double *const f[3] = { work, work + n, work + 2*n }, sum = 0;
	Chart to = { s->nu, s->nv, g.T, g.kind };
	int c, p, m = s->nu*s->nv;

	normals(g, phi, f, work + 3*n);
	for (c = 0; c < 3; c++)
		if (convert(g, phi[c], to, 0, field, s->phi + c, 3) || convert(g, f[c], to, 1, field, s->normal + c, 3))
			return WARPIMAGES_ENOMEM;
	if (convert(g, work + 3*n, to, 1, field, s->area, 1))
		return WARPIMAGES_ENOMEM;
	for (p = 0; p < m; p++)
		sum += s->area[p] = fmax(s->area[p], 0);
	for (p = 0; p < m; p++)
		s->area[p] = sum > 0 ? s->area[p]*m/sum : 1;
	return 0;
}

int
warpsurface_init(WarpSurface *s, Chart g, const double *const phi[3], int nu, int nv)
{
	size_t n = (size_t)g.nu*g.nv, m = (size_t)nu*nv;
	double *work = malloc((4*n + m)*sizeof *work), *all = malloc(7*m*sizeof *all);
	int e = WARPIMAGES_ENOMEM;

	*s = (WarpSurface){ nu, nv, all, NULL, NULL };
	if (work && all) {
		s->normal = all + 3*m;
		s->area = all + 6*m;
		e = fill(s, g, phi, work, work + 4*n);
	}
	free(work);
	if (e)
		warpsurface_free(s);
	return e;
}

void
warpsurface_free(WarpSurface *s)
{
	free(s->phi);
	memset(s, 0, sizeof *s);
}

/* Index i mirrored into 0 .. n-1. */
static int
mirrored(int i, int n)
{
	int period = 2*(n - 1);

	i = ((i % period) + period) % period;
	return i < n ? i : period - i;
}

/* Smooths n triples, `stride` apart, by the 2 r + 1 weights w; line: workspace [n + 2r][3]. */
static void
smooth_line(int n, size_t stride, int r, const double *w, double *x, double *line)
{
	int i, k, c;

	for (i = -r; i < n + r; i++)
		for (c = 0; c < 3; c++)
			line[3*(i+r)+c] = x[stride*mirrored(i, n)*3+c];
	for (i = 0; i < n; i++) {
		double sum[3] = { 0, 0, 0 };

		for (k = 0; k <= 2*r; k++)
			for (c = 0; c < 3; c++)
				sum[c] += w[k]*line[3*(i+k)+c];
		for (c = 0; c < 3; c++)
			x[stride*i*3+c] = sum[c];
	}
}

/* Smooths all rows (axis 0) or columns of y. */
static int
smooth_axis(int nu, int nv, int axis, double share, double *y)
{
	int n = axis ? nv : nu, lines = axis ? nu : nv, r = (int)ceil(4*share*(n - 1)) + 1, k;
	double sigma = share*(n - 1), sum = 0, *w = malloc(((size_t)2*r + 1)*sizeof *w);
	int failed = 0;

	if (!w)
		return WARPIMAGES_ENOMEM;
	for (k = -r; k <= r; k++)
		sum += w[k+r] = exp(-k*k/(2*fmax(sigma*sigma, 1e-6)));
	for (k = 0; k <= 2*r; k++)
		w[k] /= sum;
#pragma omp parallel for schedule(static) reduction(|: failed)
	for (k = 0; k < lines; k++) {
		double *line = malloc(((size_t)n + 2*r)*3*sizeof *line);

		if (line)
			smooth_line(n, axis ? (size_t)nu : 1, r, w, y + (size_t)k*(axis ? 1 : nu)*3, line);
		failed |= !line;
		free(line);
	}
	free(w);
	return failed ? WARPIMAGES_ENOMEM : 0;
}

int
warpimages_smooth(int nu, int nv, double share, const double *x, double *y)
{
	if (x != y)
		memcpy(y, x, (size_t)nu*nv*3*sizeof *y);
	return smooth_axis(nu, nv, 0, share, y) || smooth_axis(nu, nv, 1, share, y) ? WARPIMAGES_ENOMEM : 0;
}

void
warpimages_at(int nu, int nv, const double *b, double u, double v, double x[3], double du[3], double dv[3])
{
	double s = fmin(fmax(u, 0), 1)*(nu - 1), t = fmin(fmax(v, 0), 1)*(nv - 1);
	int i = (int)s < nu - 2 ? (int)s : nu - 2, j = (int)t < nv - 2 ? (int)t : nv - 2, c;
	const double *p = b + 3*((size_t)j*nu + i), *q = p + 3*(size_t)nu;

	s -= i;
	t -= j;
	for (c = 0; c < 3; c++) {
		double low = p[c] + s*(p[c+3] - p[c]), high = q[c] + s*(q[c+3] - q[c]);

		x[c] = low + t*(high - low);
		if (du) {
			du[c] = ((1 - t)*(p[c+3] - p[c]) + t*(q[c+3] - q[c]))*(nu - 1);
			dv[c] = (high - low)*(nv - 1);
		}
	}
}

double
warpimages_mismatch(int nu, int nv, double T, const double *a, const double *b, const double *f, double *g,
	double *row)
{
	size_t n = (size_t)nu*nv;
	double sum = 0;
	int j;

#pragma omp parallel for schedule(static)
	for (j = 0; j < nv; j++) {
		double s = 0, x[3], du[3], dv[3], r;
		size_t p = (size_t)j*nu;
		int i, c;

		for (i = 0; i < nu; i++, p++) {
			warpimages_at(nu, nv, b, f[p], f[n+p]/T, x, du, dv);
			for (c = 0; c < 3; c++) {
				r = x[c] - a[3*p+c];
				s += r*r;
				g[p] += r*du[c]/n;
				g[n+p] += r*dv[c]/(n*T);
			}
		}
		row[j] = s;
	}
	for (j = 0; j < nv; j++)
		sum += row[j];
	return sum/(2*n);
}
