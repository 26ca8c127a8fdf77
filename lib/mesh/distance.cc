/* distance.cc - distances of two surfaces and self-intersections, by CGAL. */

/* CGAL's search for the Hausdorff distance asserts that a box inside another is not the nearer of
 * the two, and throws where rounding violates this.  The search is correct without the
 * assertion. */
#define CGAL_NO_PRECONDITIONS

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

#include "distance.h"

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Vertex_index Vertex;

static Point
point(const Mesh *m, int p)
{
	const double *x = m->xyz + 3*static_cast<std::size_t>(p);

	return Point(x[0], x[1], x[2]);
}

static bool
has_area(const Mesh *m, const int *t)
{
	return !CGAL::collinear(point(m, t[0]), point(m, t[1]), point(m, t[2]));
}

/* Gives every face three vertices of its own.  Distances need no connectivity, so this accepts any
 * mesh. */
static void
separate_faces(const Mesh *m, Surface &s)
{
	for (int f = 0; f < m->nf; f++) {
		const int *t = m->tri + 3*static_cast<std::size_t>(f);

		if (has_area(m, t))
			s.add_face(s.add_vertex(point(m, t[0])), s.add_vertex(point(m, t[1])),
				s.add_vertex(point(m, t[2])));
	}
}

static bool
joined_faces(const Mesh *m, Surface &s)
{
	for (int p = 0; p < m->nv; p++)
		s.add_vertex(point(m, p));
	for (int f = 0; f < m->nf; f++) {
		const int *t = m->tri + 3*static_cast<std::size_t>(f);

		if (has_area(m, t) && s.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]))
		    == Surface::null_face())
			return false;
	}
	return true;
}

extern "C" void
distance_vertices(const Mesh *a, const Mesh *b, double *max, double *mean)
{
	double sum = 0, far = 0;

	for (std::size_t p = 0; p < static_cast<std::size_t>(a->nv); p++) {
		const double *x = a->xyz + 3*p, *y = b->xyz + 3*p;
		double d = std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);

		sum += d;
		far = d > far ? d : far;
	}
	*max = far;
	*mean = sum/a->nv;
}

extern "C" int
distance_hausdorff(const Mesh *a, const Mesh *b, double error, double *d)
try {
	Surface sa, sb;

	separate_faces(a, sa);
	separate_faces(b, sb);
	if (sa.number_of_faces() == 0 || sb.number_of_faces() == 0)
		return DISTANCE_EAREA;
	*d = PMP::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(sa, sb, error);
	return 0;
} catch (const std::bad_alloc &) {
	return DISTANCE_ENOMEM;
} catch (...) {
	return DISTANCE_ECGAL;
}

extern "C" int
distance_crossings(const Mesh *m, long *pairs)
try {
	typedef std::pair<Surface::Face_index, Surface::Face_index> Pair;
	std::vector<Pair> found;
	Surface s;

	if (!joined_faces(m, s))
		return DISTANCE_EEDGE;
	PMP::self_intersections<CGAL::Sequential_tag>(faces(s), s, std::back_inserter(found));
	*pairs = static_cast<long>(found.size());
	return 0;
} catch (const std::bad_alloc &) {
	return DISTANCE_ENOMEM;
} catch (...) {
	return DISTANCE_ECGAL;
}
