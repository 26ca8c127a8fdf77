/* delaunay.cc - CGAL's Delaunay triangulation, for plain arrays. */
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <new>
#include <utility>
#include <vector>

#include "delaunay.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Triangulation_vertex_base_with_info_2<int, Kernel> Vertex;
typedef CGAL::Triangulation_data_structure_2<Vertex> Structure;
typedef CGAL::Delaunay_triangulation_2<Kernel, Structure> Triangulation;

extern "C" int
delaunay(int n, const double *xy, int *tri, int *nf)
try {
	std::vector<std::pair<Kernel::Point_2, int>> points;
	Triangulation t;

	points.reserve(static_cast<std::size_t>(n));
	for (int i = 0; i < n; i++)
		points.emplace_back(Kernel::Point_2(xy[2*i], xy[2*i+1]), i);
	t.insert(points.begin(), points.end());
	if (t.number_of_vertices() != points.size() || t.dimension() != 2)
		return DELAUNAY_EPOINT;
	*nf = 0;
	for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f, ++*nf)
		for (int k = 0; k < 3; k++)
			tri[3 * *nf + k] = f->vertex(k)->info();
	return 0;
} catch (const std::bad_alloc &) {
	return DELAUNAY_ENOMEM;
} catch (...) {
	return DELAUNAY_ECGAL;
}
