# Makefile - "make demo" installs the packages that the build needs, builds, and smooths a scan, or a
# synthetic face; "make check" installs also those of the tests, builds, and runs every test.
# Everything built lies in $(BUILD).
#
#   make                      build the commands into build/bin
#   make quick                unit tests and the fast command tests; installs nothing (seconds)
#   make test T=misfit        one unit test; T=pipes.bats one file of command tests
#   make SANITIZE=address,undefined check      every test under sanitizers, in
#                             build/address,undefined
#   make install PREFIX=/usr/local DESTDIR=   programs, pages, library, readers (install.mk);
#                             make installcheck then tries them, make uninstall removes them
#   make dist                 the last commit as a tarball, build/lhgrid-VERSION.tar.gz
#   make bench                measures the numbers that README.md promises (minutes)
#   make compile_commands.json    for editors
#   make check-untracked      fails if a test left a file, or if a stray file is tracked
#   make coverage             measures the lines that the tests run, by file (minutes)
#   make soak                 runs in full the tests that make check only samples (minutes)
#   make fuzz FUZZ_SECONDS=60 runs each fuzz target for this long (clang)
#   make paper                makes the paper's tables and figures, build/paper/report.md (minutes)

include config.mk

CMD = mesh2disk mesh2rect grid2lh lhfft lhwarp lhinterp lh2grid grid2mesh lhinfo lhdiff lh2png grid2html mkmesh

BUILD    := build$(if $(SANITIZE),/$(SANITIZE))
export BUILD
# Unit tests get the same spin count as the commands (cmd/shared/threads.c).
export GOMP_SPINCOUNT := 3000

ALL_CPPFLAGS := -D_XOPEN_SOURCE=700 -MMD -MP $(CPPFLAGS)
ALL_CFLAGS   := -std=c11 -fno-math-errno $(WARN) $(OPENMP) $(CFLAGS)
ALL_CXXFLAGS := -std=c++17 $(WARN) $(OPENMP) $(CXXFLAGS)
ifdef SANITIZE
ALL_CFLAGS   += -fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer
ALL_CXXFLAGS += -fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer
LDFLAGS      += -fsanitize=$(SANITIZE)
LIBCFLAGS    :=                         # gcc gives false warnings with -O3 and sanitizers
endif

LIBOBJ   := $(patsubst %,$(BUILD)/%.o,$(basename $(wildcard format/*.c lib/*/*.c lib/*/*.cc)))
SHARED   := $(patsubst %.c,$(BUILD)/%.o,$(wildcard cmd/*/*.c))
BIN      := $(CMD:%=$(BUILD)/bin/%)
TESTSRC  := $(filter-out tests/fault.c tests/disks.c,$(wildcard tests/*.c))
TESTBIN  := $(TESTSRC:%.c=$(BUILD)/%)
UNIT     := $(filter $(BUILD)/tests/test_%,$(TESTBIN))
# The fuzz targets: the files of tests/fuzz/, except those that all targets share.
FUZZ     := $(filter-out memory mesh replay,$(basename $(notdir $(wildcard tests/fuzz/*.c))))
FUZZBIN  := $(FUZZ:%=$(BUILD)/tests/fuzz/%)
FUZZMAIN := $(BUILD)/tests/fuzz/replay.o
FUZZOBJ  := $(BUILD)/tests/fuzz/memory.o $(BUILD)/tests/fuzz/mesh.o
OBJ      := $(LIBOBJ) $(SHARED) $(CMD:%=$(BUILD)/cmd/%.o) $(TESTBIN:%=%.o) \
            $(FUZZBIN:%=%.o) $(FUZZMAIN) $(FUZZOBJ) $(BUILD)/tests/fault.o $(BUILD)/tests/disks.o
LIB      := $(BUILD)/liblhgrid.a
CMDLIB   := $(BUILD)/libcmd.a

# The commands once more, linked so that chosen calls fail on demand (tests/fault.c).
FAULTY   := $(CMD:%=$(BUILD)/faulty/%)
FAULT    := $(BUILD)/tests/fault.o
WRAPPED  := malloc calloc realloc free aligned_alloc strdup fftw_alloc_real fftw_free _Znwm _Znam \
	fopencookie fmemopen read write close fsync rename mkstemp fchmod

all: $(BIN)

# The tests of an installation find man and liblhg made: several install at once.
tests: $(TESTBIN) $(FUZZBIN) $(FAULTY) man liblhg

# Links the objects $1 with the members of the archives $2 that they need, and the libraries $3.
# With -t -t the linker lists the objects that went into the program; PROGRAM.used makes the
# program depend on these only.  There is no such file if the archives are not thin, since their
# members are then listed without a path; the program then depends on all objects.
define link
@mkdir -p $(@D)
$(CXX) $(OPENMP) $(LDFLAGS) $(WRAP) -Wl,-t,-t -o $@ $1 $2 $(LDLIBS) $3 >$@.list
@grep -q '^($(BUILD)' $@.list || sed -n 's|^$(BUILD)/.*\.o$$|$@: &\n&:|p' $@.list >$@.used
@rm $@.list
endef
LINKED   := $(BIN) $(FAULTY) $(TESTBIN) $(FUZZBIN)
$(foreach p,$(LINKED),$(if $(wildcard $p.used),,$(eval $p: $(LIBOBJ) $(SHARED))))
-include $(LINKED:=.used)

# cmd/shared/pages.c replaces these functions.
$(BIN): WRAP = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc
$(BIN): $(BUILD)/bin/%: $(BUILD)/cmd/%.o | $(CMDLIB) $(LIB)
	$(call link,$<,$(CMDLIB) $(LIB))

$(FAULTY): WRAP = $(WRAPPED:%=-Wl,--wrap=%)
$(FAULTY): $(BUILD)/faulty/%: $(BUILD)/cmd/%.o $(FAULT) | $(CMDLIB) $(LIB)
	$(call link,$< $(FAULT),$(CMDLIB) $(LIB),-lsuitesparseconfig)

$(BUILD)/tests/test_memory: $(FAULT)
$(BUILD)/tests/test_memory: WITH = $(FAULT)
$(BUILD)/tests/test_memory: WRAP = $(WRAPPED:%=-Wl,--wrap=%)

# Unit tests that use the random disks of tests/disks.c.
DISKS    := $(BUILD)/tests/disks.o
ONDISKS  := $(patsubst %,$(BUILD)/tests/test_%,subdivision intrinsic overlay intrinsicmap sampler vertexkey untangle \
              traversal conformal)
$(ONDISKS): $(DISKS)
$(ONDISKS): WITH = $(DISKS)

$(TESTBIN): %: %.o | $(LIB)
	$(call link,$< $(WITH),$(LIB),-lcmocka -lsuitesparseconfig)

$(BUILD)/tests/test_lhgfault $(FUZZBIN): WRAP = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free

$(FUZZBIN): OPENMP =
$(FUZZBIN): %: %.o $(FUZZMAIN) $(FUZZOBJ) | $(LIB)
	$(call link,$< $(FUZZMAIN) $(FUZZOBJ),$(LIB))

$(LIBOBJ): ALL_CFLAGS += $(LIBCFLAGS) $(COVER)

$(LIB): $(LIBOBJ)
$(CMDLIB): $(SHARED)
# Thin archives hold the paths of the objects, not copies of them.
$(LIB) $(CMDLIB):
	rm -f $@
	$(AR) rcT $@ $^

$(BUILD)/%.o: %.c config.mk
	@mkdir -p $(@D)
	$(CC) $(ALL_CPPFLAGS) $(ALL_CFLAGS) -c -o $@ $<

$(BUILD)/%.o: %.cc config.mk
	@mkdir -p $(@D)
	$(CXX) $(ALL_CPPFLAGS) $(ALL_CXXFLAGS) -c -o $@ $<

# A product and a sum become one instruction (fused multiply-add) if the processor has it.
$(BUILD)/lib/sparse/product.o: ALL_CFLAGS += -ffp-contract=fast

# -O3, whatever CFLAGS say, because it vectorizes the inner loops of the surface method.
$(addprefix $(BUILD)/lib/,surface/misfit.o surface/misfitapply.o poisson/transform.o): ALL_CFLAGS += -O3

# The mesh of the demo: MESH=scan.ply, or a scan of a face if it is there.
MESH := $(wildcard $(or $(LHGRID_MESHES),../shared/meshes)/good/face_man_scan_6k.off)

demo:
	scripts/deps
	$(MAKE) all
	PATH="$(CURDIR)/$(BUILD)/bin:$$PATH" sh examples/smooth.sh $(BUILD)/demo $(MESH)

check:
	scripts/deps --tests
	$(MAKE) all tests
	scripts/arrows $(BUILD)
	$(MAKE) -O $(CHECKS)

# Each program of tests and each file of command tests is a target of its own: make -j2 check
# runs two at a time.  Threads that wait sleep, as in the commands: if they spin while the cores
# are busy with another test, test_surface takes ten times as long.
UNITRUN := $(UNIT:%=run-%)
FUZZRUN := $(FUZZ:%=run-fuzz-%)
BATSRUN := $(patsubst %,run-%,$(wildcard tests/*.bats))
CHECKS  := $(BATSRUN) $(UNITRUN) $(FUZZRUN)

$(UNITRUN): export OMP_WAIT_POLICY = passive

$(UNITRUN): run-%: %
	$<

$(FUZZRUN): run-fuzz-%: $(BUILD)/tests/fuzz/%
	$< tests/fuzz/corpus/$* tests/lhg/good tests/lhg/bad

$(BATSRUN): run-%: all tests
	bats $*

# The unit tests that take more than five seconds, and the command tests that take less.
SLOW = %_adapt %_conformal %_intrinsicmap %_motions %_order %_surface %_synth
FAST = arrows doc lhg lhgpy lhdiff

quick: all $(UNIT)
	scripts/arrows $(BUILD)
	$(MAKE) -O $(filter-out $(SLOW),$(UNITRUN)) $(FAST:%=run-tests/%.bats)

# One test, as make check runs it.
test: all tests
	$(if $(T),,$(error say which: make test T=misfit, or T=pipes.bats))
	$(if $(filter %.bats,$(T)),bats tests/$(T),$(BUILD)/tests/test_$(T))

check-untracked:
	scripts/untracked

compile_commands.json:
	$(MAKE) -nB --no-print-directory all tests | scripts/compile-commands >$@

soak: all tests
	LHG_CHANGES=1000000 $(BUILD)/tests/test_lhgdamage
	SOAK=1 $(BUILD)/tests/test_memory
	SOAK=1 $(BUILD)/tests/test_intrinsicmap
	SOAK=1 bats $(patsubst %,tests/%.bats,kill memory output same)

# The fuzz targets are linked with libFuzzer and only the library sources that they need.
FUZZ_SECONDS = 60
FUZZLIB := $(patsubst %.c,build/fuzz/%.o,$(wildcard format/*.c) $(wildcard lib/meshfile/*.c) \
           lib/mesh/fail.c lib/mesh/mesh.c lib/mesh/channel.c lib/base/base64.c lib/base/chart.c lib/base/sheet.c \
           lib/base/sockplane.c lib/base/pillowplane.c)

fuzz:
	scripts/deps --fuzz
	$(MAKE) BUILD=build/fuzz CC=clang-$$(scripts/deps --clang) CXX=clang++-$$(scripts/deps --clang) OPENMP= LIBOBJ='$(FUZZLIB)' FUZZMAIN= \
	    CFLAGS='-O2 -g -fno-sanitize-recover=all -fsanitize=address,undefined' COVER=-fsanitize=fuzzer-no-link \
	    LDFLAGS='-Wl,--as-needed -fsanitize=fuzzer,address,undefined' fuzztargets
	scripts/fuzz $(FUZZ_SECONDS) $(FUZZ)

fuzztargets: $(FUZZBIN)

# Runs the tests in a build with gcov and prints the share of lines run, by file and folder.
coverage:
	rm -rf build/coverage
	$(MAKE) BUILD=build/coverage LIBCFLAGS= CFLAGS='-O1 -g --coverage' CXXFLAGS='-O1 -g --coverage' \
	    LDFLAGS='$(LDFLAGS) --coverage' check
	scripts/coverage build/coverage

bench: all tests
	PATH="$(CURDIR)/$(BUILD)/bin:$$PATH" sh scripts/bench

paper: all
	scripts/deps --paper
	PATH="$(CURDIR)/$(BUILD)/bin:$$PATH" scripts/paper $(BUILD)/paper

include install.mk

clean:
	rm -rf build

compile_commands.json: FORCE

.PHONY: FORCE $(CHECKS) all tests demo check quick test check-untracked soak fuzz fuzztargets coverage bench paper clean
.SECONDARY: $(OBJ)

-include $(OBJ:.o=.d)
