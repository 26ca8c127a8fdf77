/* coons.c - Coons interpolation of border values. */
#include "border.h"
#include "coons.h"

static void
on_sock(Chart g, const double *d, int i, int j, double f[3])
{
	double share = (j + 0.5)/(g.nv - 0.5), mean;
	int c, k;

	for (c = 0; c < 3; c++) {
		for (mean = 0, k = 0; k < g.nu; k++)
			mean += d[3*k+c]/g.nu;
		f[c] = d[3*border_number(g, i, g.nv - 1)+c];
		if (j < g.nv - 1)
			f[c] = mean + share*share*(f[c] - mean);
	}
}

static void
on_rectangle(int nu, int nv, const double *d, int i, int j, double f[3])
{
	double u = (double)i/(nu - 1), v = (double)j/(nv - 1);
	int a = nu - 1, b = nv - 1, c;
	const double *left = d + 3*border_index(nu, nv, 0, j), *right = d + 3*border_index(nu, nv, a, j);
	const double *bottom = d + 3*border_index(nu, nv, i, 0), *top = d + 3*border_index(nu, nv, i, b);
	const double *d00 = d, *d10 = d + 3*a, *d11 = d + 3*(a + b), *d01 = d + 3*(2*a + b);

	for (c = 0; c < 3; c++) {
		if (j == 0 || j == b)
			f[c] = j ? top[c] : bottom[c];
		else if (i == 0 || i == a)
			f[c] = i ? right[c] : left[c];
		else
			f[c] = (1 - u)*left[c] + u*right[c] + (1 - v)*bottom[c] + v*top[c]
			    - (1 - u)*(1 - v)*d00[c] - u*(1 - v)*d10[c] - (1 - u)*v*d01[c] - u*v*d11[c];
	}
}

void
coons(Chart g, const double *d, int i, int j, double f[3])
{
	if (g.kind->folded)
		on_sock(g, d, i, j, f);
	else
		on_rectangle(g.nu, g.nv, d, i, j, f);
}
