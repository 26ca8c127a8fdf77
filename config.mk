# config.mk - what differs between machines.

PREFIX   = /usr/local
CC       = gcc
CXX      = g++
CFLAGS   = -O2 -g
CXXFLAGS = -O2 -g
LIBCFLAGS = -O3
OPENMP   = -fopenmp
CPPFLAGS =
WARN     = -Wall -Wextra -Wpedantic
LDFLAGS  = -Wl,--as-needed
# Any BLAS: BLAS=-lblas links the reference one, or what the system has put in its place.
# It is CHOLMOD that calls it, so the linker must not drop it as unused.
BLAS     = -Wl,--no-as-needed -lopenblas -Wl,--as-needed
LDLIBS   = -lcholmod -lfftw3 -llapacke $(BLAS) -lgmp -lmpfr -lz -lm
