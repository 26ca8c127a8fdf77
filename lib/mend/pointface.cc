/* pointface.cc - faces on points, by CGAL's advancing front. */
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <new>
#include <vector>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "pointface.h"

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Facet = std::array<std::size_t, 3>;

extern "C" int
pointface(int n, const double *xyz, int **tri, int *nf)
try {
	std::vector<Point> points;
	std::vector<int> number;
	std::vector<Facet> facets;

	for (int v = 0; v < n; v++) {
		const double *x = xyz + 3*std::size_t(v);

		if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2])) {
			points.emplace_back(x[0], x[1], x[2]);
			number.push_back(v);
		}
	}
	if (points.size() > 2)
		CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(), std::back_inserter(facets));
	*nf = int(facets.size());
	*tri = static_cast<int *>(std::malloc((facets.size() + 1)*3*sizeof(int)));
	if (!*tri)
		return POINTFACE_ENOMEM;
	for (std::size_t f = 0; f < facets.size(); f++)
		for (std::size_t k = 0; k < 3; k++)
			(*tri)[3*f + k] = number[facets[f][k]];
	return 0;
} catch (const std::bad_alloc &) {
	return POINTFACE_ENOMEM;
} catch (...) {
	return POINTFACE_ECGAL;
}
