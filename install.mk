# install.mk - included by Makefile: manual pages, the library of the format, installation, and the
# tarball of a release.

VERSION  := $(shell sed -n 's/^.define CMD_VERSION "\(.*\)"/\1/p' cmd/shared/private.h)
ROOT      = $(DESTDIR)$(PREFIX)
LIBDIR    = lib

# ---- manual pages: man1 from --help and man/NAME.mdoc, the others by hand ----

INSTALLED := $(CMD) lhbatch
MAN1     := $(INSTALLED:%=$(BUILD)/man/%.1)

man: $(MAN1)

$(CMD:%=$(BUILD)/man/%.1): $(BUILD)/man/%.1: $(BUILD)/bin/% man/%.mdoc man/lhgrid.7 scripts/manpage
	@mkdir -p $(@D)
	scripts/manpage cmd/$*.c $< man/$*.mdoc >$@.new
	mv $@.new $@

# lhbatch asks lhinfo for its version.
$(BUILD)/man/lhbatch.1: scripts/lhbatch $(BUILD)/bin/lhinfo man/lhbatch.mdoc man/lhgrid.7 scripts/manpage
	@mkdir -p $(@D)
	PATH="$(CURDIR)/$(BUILD)/bin:$$PATH" scripts/manpage $< $< man/lhbatch.mdoc >$@.new
	mv $@.new $@

# ---- liblhg: format/ alone, needs only zlib ----

LHGOBJ   := $(patsubst %.c,$(BUILD)/pic/%.o,$(wildcard format/*.c))
LHGSO    := liblhg.so.1

liblhg: $(BUILD)/liblhg.a $(BUILD)/$(LHGSO)

$(LHGOBJ): $(BUILD)/pic/%.o: %.c config.mk
	@mkdir -p $(@D)
	$(CC) $(ALL_CPPFLAGS) -std=c11 $(WARN) $(CFLAGS) -fPIC -c -o $@ $<

$(BUILD)/liblhg.a: $(LHGOBJ)
	rm -f $@
	$(AR) rcs $@ $^

$(BUILD)/$(LHGSO): $(LHGOBJ) format/lhg.map
	$(CC) -shared -Wl,-soname,$(LHGSO) -Wl,--version-script=format/lhg.map -Wl,-z,defs $(LDFLAGS) -o $@ $(LHGOBJ) -lz

-include $(LHGOBJ:.o=.d)

# ---- install ----

SHARE    := scripts/lhg.py scripts/lhread.m scripts/lhwrite.m scripts/lhread.R scripts/render.py scripts/raster.py \
            scripts/batch.mk scripts/lhone scripts/lhreport scripts/Snakefile
DOC      := README.md CHANGELOG.md LICENSE doc/tutorial.md doc/mathematics.md format/LHG.md
EXAMPLES := examples/smooth.sh examples/morph.sh examples/lhgends.c
BASHDIR  := share/bash-completion/completions

install: all man liblhg
	mkdir -p $(addprefix $(ROOT)/,bin include $(LIBDIR)/pkgconfig share/lhgrid share/doc/lhgrid/examples \
	    share/man/man1 share/man/man5 share/man/man7 $(BASHDIR) share/zsh/site-functions)
	install -m 755 $(BIN) scripts/lhbatch $(ROOT)/bin
	install -m 644 format/lhg.h $(ROOT)/include
	install -m 644 $(BUILD)/liblhg.a $(ROOT)/$(LIBDIR)
	install -m 755 $(BUILD)/$(LHGSO) $(ROOT)/$(LIBDIR)
	ln -sf $(LHGSO) $(ROOT)/$(LIBDIR)/liblhg.so
	sed 's|@PREFIX@|$(PREFIX)|; s|@LIBDIR@|$(LIBDIR)|; s|@VERSION@|$(VERSION)|' format/lhg.pc.in \
	    >$(ROOT)/$(LIBDIR)/pkgconfig/lhg.pc
	install -m 644 $(SHARE) $(ROOT)/share/lhgrid
	chmod 755 $(addprefix $(ROOT)/share/lhgrid/,render.py lhone lhreport)
	install -m 644 $(DOC) $(ROOT)/share/doc/lhgrid
	install -m 644 format/LICENSE $(ROOT)/share/doc/lhgrid/LICENSE.MIT
	install -m 644 $(EXAMPLES) $(ROOT)/share/doc/lhgrid/examples
	install -m 644 $(MAN1) $(ROOT)/share/man/man1
	sed 's/^\.Os lhgrid$$/& $(VERSION)/' man/lhg.5 >$(ROOT)/share/man/man5/lhg.5
	sed 's/^\.Os lhgrid$$/& $(VERSION)/' man/lhgrid.7 >$(ROOT)/share/man/man7/lhgrid.7
	sed 's/@COMMANDS@/$(INSTALLED)/' completion/lhgrid.bash >$(ROOT)/$(BASHDIR)/lhgrid
	for c in $(INSTALLED); do ln -sf lhgrid $(ROOT)/$(BASHDIR)/$$c; done
	sed 's/@COMMANDS@/$(INSTALLED)/' completion/_lhgrid >$(ROOT)/share/zsh/site-functions/_lhgrid

uninstall:
	rm -f $(addprefix $(ROOT)/,$(INSTALLED:%=bin/%) $(INSTALLED:%=share/man/man1/%.1) $(INSTALLED:%=$(BASHDIR)/%) \
	    $(BASHDIR)/lhgrid share/zsh/site-functions/_lhgrid share/man/man5/lhg.5 share/man/man7/lhgrid.7 \
	    include/lhg.h $(addprefix $(LIBDIR)/,liblhg.a liblhg.so $(LHGSO) pkgconfig/lhg.pc))
	rm -rf $(ROOT)/share/lhgrid $(ROOT)/share/doc/lhgrid

# Uses what is installed, in an empty folder.
installcheck:
	scripts/installcheck '$(DESTDIR)' '$(PREFIX)' '$(LIBDIR)' $(INSTALLED)

# The last commit as a tarball, which builds without git.  Equal commits give equal tarballs.
dist:
	@mkdir -p $(BUILD)
	git archive --prefix=lhgrid-$(VERSION)/ HEAD | gzip -9n >$(BUILD)/lhgrid-$(VERSION).tar.gz

.PHONY: man liblhg install uninstall installcheck dist
