# install.bats - what make install puts where, and that it works from there; make dist.

load helper

# A library with sanitizers serves only programs that have them too.
setup() { ! sanitized || skip "what is installed has no sanitizers"; }

setup_file() {
	load helper
	! sanitized || return 0
	unset MAKEFLAGS MFLAGS MAKELEVEL
	make -s BUILD="$BUILD" DESTDIR="$tmp/root" PREFIX=/opt/lhgrid install
}

# The options of COMMAND that its source, its --help and its page have; one per line.
in_source() { grep -oE '^	\{ "[a-zA-Z-]+",' "cmd/$1.c" | tr -d '\t{", '; printf '%s\n' output no-history threads progress quiet verbose help version; }
in_help()   { "$1" --help | grep -E '^ {2,6}-' | grep -oE '(^ *|, )(-[a-zA-Z], )?--[a-zA-Z][a-zA-Z-]*' | grep -oE '[a-zA-Z-]+$' | sed 's/^--//'; }
in_page()   { grep '^\.It Fl' "$tmp/root/opt/lhgrid/share/man/man1/$1.1" | grep -oE 'Fl \\&-[a-zA-Z-]+' | sed 's/^Fl ..-//'; }

@test "installcheck: programs, pages, examples, reader and library work from an empty folder" {
	run -0 make -s DESTDIR="$tmp/root" PREFIX=/opt/lhgrid installcheck
	[[ $output == *'/opt/lhgrid is complete' ]]
	rm "$tmp/root/opt/lhgrid/share/man/man1/lhfft.1"
	run -2 make -s DESTDIR="$tmp/root" PREFIX=/opt/lhgrid installcheck
	make -s BUILD="$BUILD" DESTDIR="$tmp/root" PREFIX=/opt/lhgrid install
}

@test "source, --help and page of every program have the same options" {
	for c in $commands; do
		in_source $c | sort -u >"$tmp/source"
		in_help $c | sort -u >"$tmp/help"
		in_page $c | sort -u >"$tmp/page"
		[ "$(wc -l <"$tmp/help")" -ge 6 ]
		# the opposite of a default may be named in the text alone, as --log-lambda and --bending
		"$c" --help | grep -oE -- '--[a-zA-Z][a-zA-Z-]*' | sed 's/^--//' | sort -u >"$tmp/words"
		comm -23 "$tmp/source" "$tmp/words" | { ! grep .; } || { echo "$c: not in --help"; false; }
		comm -13 "$tmp/source" "$tmp/help"  | { ! grep .; } || { echo "$c: --help has more"; false; }
		diff "$tmp/help" "$tmp/page" || { echo "$c: the page differs from --help"; false; }
	done
}

@test "pages: no warning of mandoc; every page that is cited is there" {
	local man=$tmp/root/opt/lhgrid/share/man x
	[ "$(ls "$man"/man?/*.? | wc -l)" = $(($(wc -w <<<"$commands") + 3)) ]
	cat "$man"/man?/* | sed -n 's/^\.Xr \([a-z0-9]*\) \([0-9]\).*/\1.\2/p' | sort -u | grep -vx make.1 >"$tmp/cited"
	while read -r x; do
		[ -s "$man/man${x#*.}/$x" ] || { echo "no page $x"; false; }
	done <"$tmp/cited"
	command -v mandoc >/dev/null || skip "no mandoc"
	run mandoc -Tlint -W warning "$man"/man?/*.?
	[ -z "$output" ]
}

@test "one version: programs, pages, lhg.pc, CHANGELOG, CITATION, debian and the tarball" {
	local man=$tmp/root/opt/lhgrid/share/man version page
	version=$(sed -n 's/^#define CMD_VERSION "\(.*\)"/\1/p' cmd/shared/private.h)
	grep -Eqx '[0-9]+\.[0-9]+\.[0-9]+' <<<"$version"
	for c in $commands; do
		[ "$("$tmp/root/opt/lhgrid/bin/$c" --version)" = "$c (lhgrid) $version" ]
	done
	[ "$(PATH=$tmp/root/opt/lhgrid/bin:$PATH lhbatch --version)" = "lhbatch (lhgrid) $version" ]
	for page in "$man"/man?/*; do
		grep -qx "\.Os lhgrid $version" "$page" || { echo "$page"; false; }
	done
	grep -qx "Version: $version" "$tmp/root/opt/lhgrid/lib/pkgconfig/lhg.pc"
	grep -qx "version: \"$version\"" CITATION.cff
	[[ $(head -1 debian/changelog) == "lhgrid ($version) "* ]]
	# between two versions the changes of the next stand before it
	[ "$(sed -n 's/^## //p' CHANGELOG.md | grep -vx Unreleased | head -1 | cut -d' ' -f1)" = "$version" ]
	[ "$(make -s -n dist | grep -o 'lhgrid-[0-9.]*\.tar' | head -1)" = "lhgrid-$version.tar" ]
}

@test "liblhg exports the functions of lhg.h and no others; lhg.h is C++ too" {
	grep -oE '^[A-Za-z].*\blhg_[a-z0-9_]+\(' format/lhg.h | grep -oE 'lhg_[a-z0-9_]+' | sort >"$tmp/declared"
	nm -D --defined-only "$tmp/root/opt/lhgrid/lib/liblhg.so" | sed -n 's/.* T \(lhg_[a-z0-9_]*\).*/\1/p' | sort | diff "$tmp/declared" -
	[ "$(wc -l <"$tmp/declared")" -ge 15 ]
	echo '#include <lhg.h>
	int main() { Lhg g; lhg_init(&g, 2, 2, 1); lhg_free(&g); }' >"$tmp/plus.cc"
	g++ -I "$tmp/root/opt/lhgrid/include" -o "$tmp/plus" "$tmp/plus.cc" -L"$tmp/root/opt/lhgrid/lib" -llhg
	LD_LIBRARY_PATH="$tmp/root/opt/lhgrid/lib" "$tmp/plus"
}

# completed WORD...: what bash completion offers for the last of the words.
completed() {
	PATH="$tmp/root/opt/lhgrid/bin:$PATH" bash -c 'shift 0; compopt() { :; }
		. "$0"
		COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
		_lhgrid
		echo "${COMPREPLY[*]}"' "$tmp/root/opt/lhgrid/share/bash-completion/completions/$1" "$@"
}

@test "bash completion: options, their words, and files" {
	[ "$(completed lh2png --ra)" = --range= ]
	[ "$(completed lh2png --map = vi)" = viridis ]
	[ "$(completed lh2png --map =)" = 'viridis diverging' ]
	[ "$(completed lhinfo --j)" = --json ]
	[ "$(completed lhfft --K)" = '--K-H= --K-lambda=' ]
	[ "$(completed mkmesh Make)" = Makefile ]
	[ "$(completed lhbatch --s)" = --slurm ]
	[ "$(completed lhbatch --t)" = --tasks= ]
	for c in $commands lhbatch; do
		[ "$(completed $c --vers)" = --version ]
	done
}

@test "zsh completion: the function is found, and names every program" {
	local file=$tmp/root/opt/lhgrid/share/zsh/site-functions/_lhgrid
	[ "$(head -1 "$file")" = "#compdef $commands lhbatch" ]
	command -v zsh >/dev/null || skip "no zsh"
	zsh -f -c 'fpath=($1 $fpath); autoload -U compinit; compinit -D; [[ $_comps[lh2png] == _lhgrid ]]' - "${file%/*}"
}

@test "uninstall leaves no file" {
	make -s BUILD="$BUILD" DESTDIR="$tmp/other" PREFIX=/usr install
	make -s BUILD="$BUILD" DESTDIR="$tmp/other" PREFIX=/usr uninstall
	[ -z "$(find "$tmp/other" -not -type d)" ]
}

@test "dist: the files of the last commit, equal bytes each time, and they build without git" {
	git rev-parse --git-dir >/dev/null 2>&1 || skip "no git repository"
	make -s BUILD="$tmp/a" dist
	make -s BUILD="$tmp/b" dist
	cmp "$tmp"/a/lhgrid-*.tar.gz "$tmp"/b/lhgrid-*.tar.gz
	tar xzf "$tmp"/a/lhgrid-*.tar.gz -C "$tmp/a"
	(cd "$tmp"/a/lhgrid-*/ && find . -type f -o -type l | sed 's|^\./||' | LC_ALL=C sort) >"$tmp/there"
	git ls-tree -r --name-only -z HEAD | tr '\0' '\n' | LC_ALL=C sort | diff - "$tmp/there"
	mkdir "$tmp/bin"
	printf '#!/bin/sh\necho git was called >&2\nexit 1\n' >"$tmp/bin/git"
	chmod +x "$tmp/bin/git"
	(cd "$tmp"/a/lhgrid-*/ && PATH="$tmp/bin:$PATH" make BUILD=build liblhg build/bin/lhinfo) >"$tmp/out" 2>&1
	run ! grep 'git was called' "$tmp/out"
}
