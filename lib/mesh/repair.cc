/* repair.cc - welding vertices of equal position, by CGAL. */
#include <cstddef>
#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include "repair.h"

namespace PMP = CGAL::Polygon_mesh_processing;

using Point = CGAL::Simple_cartesian<double>::Point_3;

/* CGAL is given one face with all vertices as its corners; merging replaces them by the new
 * numbers. */
extern "C" int
repair_weld(int nv, const double *xyz, int *to, int *nnew)
try {
	std::vector<Point> points;
	std::vector<std::vector<std::size_t>> faces(1);

	points.reserve(nv);
	for (int v = 0; v < nv; v++, xyz += 3) {
		points.emplace_back(xyz[0], xyz[1], xyz[2]);
		faces[0].push_back(v);
	}
	PMP::merge_duplicate_points_in_polygon_soup(points, faces);
	for (int v = 0; v < nv; v++)
		to[v] = static_cast<int>(faces[0][v]);
	*nnew = static_cast<int>(points.size());
	return 0;
} catch (...) {
	return REPAIR_ENOMEM;           /* nothing else can fail on finite numbers */
}
