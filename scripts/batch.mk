# batch.mk - smooths every mesh of a list; included by a Makefile, by three lines:
#
#   MESHES = $(wildcard scans/*.ply)
#   LHFFT = --scale=2%
#   include $(shell lhbatch --mk)
#
#   make -k -j2          OUT/NAME.ply of each mesh; an interrupted or failed run is resumed (after a
#                        change of options: make -B)
#   make -j2 report      the same, and then report.tsv, a row for each mesh, and failed.tsv
#   make table           the reports alone, of what there is
#   make pending         prints the results that are missing or older than their mesh
#   make tidy            removes what killed runs have left
#
# Variables, beside MESHES: OUT, the folder of the results [smooth]; EXT, their format [ply]; options
# of the commands: MESH2DISK (- : mesh2disk without options; empty: not run), MESH2RECT, GRID2LH, LHFFT,
# LH2GRID, GRID2MESH; KEEP_LHG=yes also keeps OUT/NAME.lhg, lambda and H.  Each mesh has one thread,
# unless OMP_NUM_THREADS says otherwise: a mesh for each core is faster than several cores for one.

OUT   ?= smooth
EXT   ?= ply
LHFFT ?= --scale=2%
OMP_NUM_THREADS ?= 1
export OUT EXT MESH2DISK MESH2RECT GRID2LH LHFFT LH2GRID GRID2MESH KEEP_LHG OMP_NUM_THREADS

lhgrid-share := $(dir $(lastword $(MAKEFILE_LIST)))
lhgrid-result = $(OUT)/$(basename $(notdir $1)).$(EXT)
lhgrid-all   := $(foreach m,$(MESHES),$(call lhgrid-result,$m))

ifneq ($(words $(lhgrid-all)),$(words $(sort $(lhgrid-all))))
$(error batch.mk: two meshes have the same name: their results would be one file)
endif

smooth-all: $(lhgrid-all)

define lhgrid-rule
$(call lhgrid-result,$1): $1
	@$(lhgrid-share)lhone $$< $$@
endef
$(foreach m,$(MESHES),$(eval $(call lhgrid-rule,$m)))

report:
	@$(MAKE) -k --no-print-directory smooth-all || :
	@$(MAKE) --no-print-directory table

# The list of meshes goes through a file, since it may be too long for a command line.
table: list := .table.list
table:
	@: $(file >$(list),$(MESHES))
	@tr ' ' '\n' <$(list) | $(lhgrid-share)lhreport; e=$$?; rm -f $(list); exit $$e

pending: list := .pending.list
pending:
	@: $(file >$(list),$(MESHES))
	@tr ' ' '\n' <$(list) | $(lhgrid-share)lhreport --pending; e=$$?; rm -f $(list); exit $$e

tidy:
	rm -rf $(OUT)/.*.lhone-??????

.PHONY: smooth-all report table pending tidy
.DEFAULT_GOAL := smooth-all
