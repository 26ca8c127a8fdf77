/* synthdisk.h - makes disks of synthetic surfaces, for tests. */
#ifndef SYNTHDISK_H
#define SYNTHDISK_H

#include "../lib/mesh/disk.h"
#include "../lib/synth/synth.h"

/* Makes a disk of this kind (synth.h) with its default parameters and about n vertices, of which 0 1 2
 * 3 are the corners.  If xy is not NULL, *xy gets the parameters of the vertices, [nv][2], to be freed
 * by the caller. */
static inline void
synth_disk(const char *kind, int n, Synth *s, SynthDomain *dom, Disk *d, double **xy)
{
	Mesh m;
	Soup soup = { 0 };
	int i;

	assert_int_equal(synth_init(s, kind), 0);
	assert_int_equal(synth_domain(s, dom), 0);
	assert_int_equal(synth_mesh(s, n, 1, &m, xy), 0);
	soup.nv = m.nv, soup.nf = m.nf, soup.xyz = m.xyz, soup.idx = m.tri;
	soup.first = malloc((m.nf + 1)*sizeof *soup.first);
	assert_non_null(soup.first);
	for (i = 0; i <= m.nf; i++)
		soup.first[i] = 3*i;
	assert_int_equal(disk_from_soup(d, &soup), 0);
	assert_string_equal(d->note, "");
	free(soup.first);
	mesh_free(&m);
}

#endif
