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
LDLIBS   = -lcholmod -lfftw3 -llapacke -lopenblas -lgmp -lmpfr -lz -lm
