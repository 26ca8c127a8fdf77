/* test_traversal.c - traversal.h: the numbering of the result depends on the connectivity and on where
 * it begins, not on the numbering of the given disk. */
#include "cmock.h"

#include "../lib/mesh/traversal.h"
#include "disks.h"

/* Checks that the disk of t is the given one, renumbered. */
static void
check_same_disk(const Traversal *t, const Disk *given, int start)
{
	int i, k;

	assert_true(disks_is_disk(&t->d));
	assert_int_equal(t->d.m.nf, given->m.nf);
	assert_int_equal(t->d.loop[0], 0);
	for (i = 0; i < given->nb; i++)
		assert_int_equal(t->d.loop[i], t->number[given->loop[(start + i)%given->nb]]);
	for (i = 0; i < given->m.nv; i++)
		for (k = 0; k < 3; k++)
			assert_true(t->d.m.xyz[3*t->number[i] + k] == given->m.xyz[3*i + k]);
}

static void
check_equal(const Disk *a, const Disk *b)
{
	assert_int_equal(a->m.nv, b->m.nv);
	assert_memory_equal(a->m.xyz, b->m.xyz, 3*a->m.nv*sizeof *a->m.xyz);
	assert_memory_equal(a->m.tri, b->m.tri, 3*a->m.nf*sizeof *a->m.tri);
	assert_memory_equal(a->twin, b->twin, 3*a->m.nf*sizeof *a->twin);
	assert_memory_equal(a->loop, b->loop, a->nb*sizeof *a->loop);
}

static int
place_in_loop(const Disk *d, int vertex)
{
	int i = 0;

	while (d->loop[i] != vertex)
		i++;
	return i;
}

static void
numbering_is_forgotten(void **state)
{
	uint64_t seed;
	int done = 0;

	(void)state;
	for (seed = 0; done < 20; seed++) {
		char tag[DISKS_TAG];
		Disk d, other, both;
		Traversal a, b;
		int *number, start;

		if (disks_random(seed, DISKS_ANY, &d, tag))
			continue;
		start = (int)seed%d.nb;
		number = malloc(d.m.nv*sizeof *number);
		assert_int_equal(disks_renumbered(&d, seed, &other, number), 0);
		assert_int_equal(disks_reordered(&other, seed, &both), 0);
		assert_int_equal(traversal_init(&a, &d, start), 0);
		assert_int_equal(traversal_init(&b, &both, place_in_loop(&both, number[d.loop[start]])), 0);
		check_same_disk(&a, &d, start);
		check_equal(&a.d, &b.d);
		traversal_free(&a);
		traversal_free(&b);
		disk_free(&d);
		disk_free(&other);
		disk_free(&both);
		free(number);
		done++;
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbering_is_forgotten),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
