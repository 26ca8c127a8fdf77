# arrows.bats - scripts/arrows finds forbidden uses; scripts/untracked finds stray files.

load helper

# A tree of two wings, a and b; b may use a.  It is compiled once.  Each test gets a copy with the
# same time stamps, so that build() compiles only what the test adds or changes.
setup_file() (
	cd "$BATS_FILE_TMPDIR"
	mkdir -p lib/a lib/b format cmd/shared cmd/p build/lib/a build/lib/b
	echo 'May use: nothing.' >lib/a/README.md
	echo 'May use: a.' >lib/b/README.md
	echo 'int one(void); int one(void) { return 1; }' >lib/a/one.c
	echo 'int one(void), two(void); int two(void) { return 2*one(); }' >lib/b/two.c
	gcc -c -o build/lib/a/one.o lib/a/one.c
	gcc -c -o build/lib/b/two.o lib/b/two.c
)

setup() {
	arrows=$PWD/scripts/arrows untracked=$PWD/scripts/untracked
	cp -a "$BATS_FILE_TMPDIR/." "$BATS_TEST_TMPDIR"
	cd "$BATS_TEST_TMPDIR"
}

build() {
	local f o
	for f in lib/*/*.c cmd/*.c cmd/*/*.c; do
		o=build/${f%.c}.o
		[ ! -e "$f" ] || [ "$o" -nt "$f" ] || { mkdir -p "${o%/*}" && gcc -c -o "$o" "$f"; } || return 1
	done
	"$arrows" build
}

@test "arrows that the plan allows pass" {
	run -0 build
	[ -z "$output" ]
}

@test "a forbidden call, a forbidden include and a circle are found" {
	echo 'int two(void), back(void); int back(void) { return two(); }' >lib/a/back.c
	run -1 build
	[[ $output = *"lib/a/back.c uses lib/b/two.c"* ]]
	rm lib/a/back.c build/lib/a/back.o
	echo '#include "../b/b.h"' >lib/a/inc.c
	touch lib/b/b.h
	run -1 build
	[[ $output = *"lib/a/inc.c uses lib/b/b.h"* ]]
	rm lib/a/inc.c
	echo 'int one(void), other(void); int other(void) { return one(); }' >lib/a/other.c
	echo 'int other(void), one(void); int one(void) { return other(); }' >lib/a/one.c
	run -1 build
	[[ $output = *"a circle: lib/a/one.c lib/a/other.c"* ]]
}

@test "a program may not use the folder of another" {
	echo 'int part(void); int part(void) { return 0; }' >cmd/p/part.c
	echo 'int part(void); int main(void) { return part(); }' >cmd/q.c
	run -1 build
	[[ $output = *"cmd/q.c uses cmd/p/part.c"* ]]
}

@test "a file left by a test, and a tracked file with an odd name, are found" {
	git init -q .
	printf 'all:\n' >Makefile
	git add Makefile lib
	git -c user.name=t -c user.email=t@example.org commit -qm t
	rm -rf format cmd build
	run -0 "$untracked"
	touch left
	run -1 "$untracked"
	[[ $output = *left* ]]
	mv left 6.39315458e-06
	git add 6.39315458e-06
	git -c user.name=t -c user.email=t@example.org commit -qm stray
	run -1 "$untracked"
	[[ $output = *6.39315458e-06* ]]
}
