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
# Any BLAS will do: BLAS=-lblas links the reference BLAS, or what the system has put in its
# place.  CHOLMOD calls the BLAS, not our code, so the linker must not drop it as unused.
BLAS     = -Wl,--no-as-needed -lopenblas -Wl,--as-needed
LDLIBS   = -lcholmod -lfftw3 -llapacke $(BLAS) -lgmp -lmpfr -lexpat -llbfgs -lpng -lz -lm
