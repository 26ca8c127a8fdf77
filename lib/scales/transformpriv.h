/* transformpriv.h - the transforms behind spectrum.h, one for each basis and chart.  Private to it. */
#ifndef TRANSFORMPRIV_H
#define TRANSFORMPRIV_H

#include <complex.h>
#include <stdlib.h>

#include "../base/chart.h"

/* The functions of spectrum.h for one basis on one kind of chart. */
typedef struct Waveform {
	int    (*columns)(Chart g);
	int    (*rows)(Chart g);
	int    (*weight)(Chart g, int m);
	void   (*numbers)(Chart g, size_t q, int *m, int *n);
	double (*wave)(Chart g, int m, int n);
	int    (*forward)(Chart g, const double *f, double complex *C);
	int    (*inverse)(Chart g, const double complex *C, double *f);
} Waveform;

extern const Waveform waveform_fold;    /* the dct of the sock: spectrumfold.c */
extern const Waveform waveform_pillow;  /* the dct of the pillow: spectrumpillow.c */

/* Memory with a fixed alignment.  FFTW's plan depends on the alignment, so it is the same in all
 * runs. */
static inline void *
waveform_aligned(size_t bytes)
{
	return aligned_alloc(64, (bytes + 63)/64*64);
}

#endif
