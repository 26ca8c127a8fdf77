/* holefill.cc - triangles across holes, by CGAL. */
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "holefill.h"

namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;

/* Returns false if a face does not fit. */
static bool
build(const Mesh *m, Surface &surface)
{
	surface.reserve(m->nv, 3*(m->nv + std::size_t(m->nf))/2, m->nf);
	for (int v = 0; v < m->nv; v++) {
		const double *x = m->xyz + 3*std::size_t(v);

		surface.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
	}
	for (int f = 0; f < m->nf; f++) {
		const int *t = m->tri + 3*std::size_t(f);

		if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Surface::null_face())
			return false;
	}
	return true;
}

/* Returns whether the hole was filled. */
static bool
fill(Surface &surface, const int at[2])
{
	const Halfedge border = surface.opposite(surface.halfedge(Vertex(at[0]), Vertex(at[1])));
	const auto faces = surface.number_of_faces();
	std::vector<Surface::Face_index> patch;
	std::vector<Vertex> added;
	std::size_t n = 0;

	for (Halfedge h = border; n == 0 || h != border; h = surface.next(h))
		n++;
	PMP::triangulate_and_refine_hole(surface, border, std::back_inserter(patch), std::back_inserter(added),
	    CGAL::parameters::do_not_use_cubic_algorithm(n > HOLEFILL_CUBIC));
	return surface.number_of_faces() > faces;
}

static int
extract(const Surface &surface, const Mesh *m, Mesh *out)
{
	out->nv = int(surface.num_vertices()) - m->nv;
	out->nf = int(surface.num_faces()) - m->nf;
	out->xyz = static_cast<double *>(std::malloc((out->nv + std::size_t(1))*3*sizeof(double)));
	out->tri = static_cast<int *>(std::malloc((out->nf + std::size_t(1))*3*sizeof(int)));
	if (!out->xyz || !out->tri)
		return HOLEFILL_ENOMEM;
	for (int v = 0; v < out->nv; v++)
		for (int c = 0; c < 3; c++)
			out->xyz[3*std::size_t(v) + c] = surface.point(Vertex(m->nv + v))[c];
	for (int f = 0; f < out->nf; f++) {
		Halfedge h = surface.halfedge(Surface::Face_index(m->nf + f));

		for (int k = 0; k < 3; k++, h = surface.next(h))
			out->tri[3*std::size_t(f) + k] = int(surface.source(h));
	}
	return 0;
}

extern "C" void
holefill_free(HolePatch *p)
{
	std::free(p->m.xyz);
	std::free(p->m.tri);
	std::free(p->done);
	*p = HolePatch();
}

extern "C" int
holefill(const Mesh *m, int n, const int (*at)[2], HolePatch *p)
try {
	*p = HolePatch();               /* first: the handlers free it */
	Surface surface;
	int e = HOLEFILL_ENOMEM;

	p->done = static_cast<unsigned char *>(std::malloc(n + std::size_t(1)));
	if (p->done && !build(m, surface))
		e = HOLEFILL_ECGAL;
	else if (p->done) {
		for (int i = 0; i < n; i++)
			p->done[i] = fill(surface, at[i]);
		e = extract(surface, m, &p->m);
	}
	if (e)
		holefill_free(p);
	return e;
} catch (const std::bad_alloc &) {
	holefill_free(p);
	return HOLEFILL_ENOMEM;
} catch (...) {
	holefill_free(p);
	return HOLEFILL_ECGAL;
}
