/* cg.c - preconditioned conjugate gradients in a trust region. */
#include <math.h>

#include "cg.h"
#include "field.h"

/* The largest t with |d + t p| = radius in the norm of P.  dd, dp and pp are the inner products
 * <d, P d>, <d, P p> and <p, P p>. */
static double
to_radius(double dd, double dp, double pp, double radius)
{
	return (-dp + sqrt(dp*dp + pp*(radius*radius - dd)))/pp;
}

CgResult
cg(const CgSystem *s, const CgLimits *limits, double *x, double *r, double *z, double *p, double *q)
{
	double rz, stop, dd = 0, dp = 0, pp, decrease = 0, old, t;      /* d = x - start */
	int steps, out;

	s->precondition(s->ctx, r, z);
	field_scale(s->n, 1, z, p);
	pp = rz = field_dot(s->n, r, z);
	stop = limits->reduction*limits->reduction*rz;
	for (steps = 0; rz > stop && steps < limits->steps; steps++) {
		s->apply(s->ctx, p, q);
		t = rz/field_dot(s->n, p, q);
		out = !(dd + 2*t*dp + t*t*pp < limits->radius*limits->radius);
		if (out) {
			double whole = t;

			t = to_radius(dd, dp, pp, limits->radius);
			decrease += 2*t*rz - t*t*rz/whole;
		} else
			decrease += t*rz;
		field_add(s->n, t, p, x);
		dd += 2*t*dp + t*t*pp;
		if (out || t*rz < limits->worth*(limits->before + decrease))
			break;
		field_add(s->n, -t, q, r);
		s->precondition(s->ctx, r, z);
		old = rz;
		rz = field_dot(s->n, r, z);
		dp = rz/old*(dp + t*pp);
		pp = rz + rz/old*(rz/old)*pp;
		field_xpay(s->n, z, rz/old, p);
	}
	return (CgResult){ decrease, sqrt(dd), steps };
}
