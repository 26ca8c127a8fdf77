/* harmonicshare.c - makes a share of a surface harmonic: one solve by sine transforms. */
#include <string.h>

#include "../base/field.h"
#include "../grid/stencil.h"
#include "../poisson/plate.h"
#include "harmonicshare.h"

int
harmonic_share(Chart g, const double *share, const double *phi, double *to)
{
	size_t n = (size_t)g.nu*g.nv, p;
	const double *const x[3] = { phi, phi + n, phi + 2*n };
	double lap[3];
	Plate plate;
	int c;

	if (plate_init(&plate, g, 0))
		return HARMONICSHARE_ENOMEM;
	memset(to, 0, 3*n*sizeof *to);
	for (p = 0; p < n; p++) {
		if (!(share[p] > 0) || !stencil_is_inner(g, (int)(p%g.nu), (int)(p/g.nu)))
			continue;
		stencil_laplacian(g, x, (int)(p%g.nu), (int)(p/g.nu), lap);
		for (c = 0; c < 3; c++)
			to[c*n+p] = share[p]*lap[c];
	}
	plate_solve(&plate, 0, 1, 0, to);
	field_add(3*n, 1, phi, to);
	plate_free(&plate);
	return 0;
}
