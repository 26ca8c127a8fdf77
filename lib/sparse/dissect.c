/* dissect.c - nested dissection of a rectangle. */
#include "dissect.h"

enum { LEAF = 8 };      /* a rectangle of at most this many nodes is not divided */

typedef struct Dissection {
	int  nu, fields;
	int *next;
} Dissection;

static void
append(Dissection *d, int i0, int i1, int j0, int j1)
{
	int i, j, f;

	for (j = j0; j < j1; j++)
		for (i = i0; i < i1; i++)
			for (f = 0; f < d->fields; f++)
				*d->next++ = (j*d->nu + i)*d->fields + f;
}

/* Appends the nodes i0 <= i < i1, j0 <= j < j1 to the order. */
static void
order_rectangle(Dissection *d, int i0, int i1, int j0, int j1)
{
	int mid;

	if ((i1 - i0)*(j1 - j0) <= LEAF || i1 - i0 < 3 || j1 - j0 < 3)
		append(d, i0, i1, j0, j1);
	else if (i1 - i0 >= j1 - j0) {
		mid = i0 + (i1 - i0)/2;
		order_rectangle(d, i0, mid, j0, j1);
		order_rectangle(d, mid + 1, i1, j0, j1);
		append(d, mid, mid + 1, j0, j1);
	} else {
		mid = j0 + (j1 - j0)/2;
		order_rectangle(d, i0, i1, j0, mid);
		order_rectangle(d, i0, i1, mid + 1, j1);
		append(d, i0, i1, mid, mid + 1);
	}
}

void
dissect(int nu, int nv, int fields, int *order)
{
	Dissection d = { nu, fields, order };

	order_rectangle(&d, 0, nu, 0, nv);
}
