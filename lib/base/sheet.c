/* sheet.c - the images of the corners of a polygon. */
#include "sheet.h"

/* The sum of the lengths of the sides, if all images but that of corner `at` are those nearest to it. */
static double
perimeter(int n, const double *u, const double *v, int at)
{
	double sum = 0;
	int k;

	for (k = 0; k < n; k++) {
		int l = (k + 1)%n;
		Sheet a = sheet_nearest(u[k], v[k], u[at], v[at]), b = sheet_nearest(u[l], v[l], u[at], v[at]);

		sum += hypot(sheet_u(a, u[k]) - sheet_u(b, u[l]), sheet_v(a, v[k]) - sheet_v(b, v[l]));
	}
	return sum;
}

void
sheet_polygon(int n, const double *u, const double *v, Sheet *s)
{
	double least = HUGE_VAL, sum;
	int k, best = 0;

	for (k = 0; k < n; k++) {
		sum = perimeter(n, u, v, k);
		if (sum < least) {
			least = sum;
			best = k;
		}
	}
	for (k = 0; k < n; k++)
		s[k] = sheet_nearest(u[k], v[k], u[best], v[best]);
}
