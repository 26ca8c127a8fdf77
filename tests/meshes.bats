# meshes.bats - real meshes are refused with the reason, repaired with a note, or accepted.

load helper

setup() {
	[ -d "$meshes" ] || skip "no folder $meshes"
}

@test "bad meshes are refused with the true reason" {
	b=$meshes/bad
	try 1 'closed surface: no boundary'              /dev/null mesh2rect --chart=sock "$b/closed_bunny.off"
	try 1 'vertex 976 is pinched'                    /dev/null mesh2rect "$b/pinched_vertex_face.off"
	try 1 'edge [0-9]+-[0-9]+ belongs to 3 faces'    /dev/null mesh2rect "$b/nonmanifold_edges.obj"
	try 1 '2 boundary loops'                         /dev/null mesh2rect "$b/two_loops_face.obj"
	try 1 '6 components'                             /dev/null mesh2rect "$b/components_face_scan.obj"
	try 1 'closed surface: no boundary'              /dev/null mesh2rect -q --chart=rectangle "$b/binary_bird_skull.stl"
	try 1 'vertex 100 .*not finite'                  /dev/null mesh2rect "$b/nan_coordinates.off"
	try 1 'ends in face [0-9]+ of 3132'              /dev/null mesh2rect "$b/truncated.ply"
	try 1 'genus 2'                                  /dev/null mesh2rect "$b/genus2_one_loop.off"
	try 1 'one-sided'                                /dev/null mesh2rect "$b/moebius_quads.obj"
	try 1 'face 3131 refers to vertex [0-9]+, there are 1656' /dev/null mesh2rect "$b/zero_area_bad_index.off"
}

@test "meshes that can be repaired are repaired, with a note" {
	b=$meshes/bad
	try 0 ''                                         /dev/null mesh2rect -n 16 "$b/quads_wrapped_lines.off"
	try 0 '3542 unreferenced vertices dropped'       /dev/null mesh2rect -n 16 "$b/unreferenced_vertices.ply"
	try 0 'soup welded to 1656'                      /dev/null mesh2rect -n 16 "$b/soup_duplicated_vertices.off"
	try 0 '1566 of 3132 faces were turned'           /dev/null mesh2rect -n 16 "$b/orientation_half_flipped.obj"
	try 0 ''                                         /dev/null mesh2rect -q -n 16 "$b/orientation_half_flipped.obj"
}

# turned FILE: the number of triangles of an OBJ file that are clockwise in (u,v).
turned() {
	awk '$1 == "vt" { u[++n] = $2; v[n] = $3 }
		$1 == "f" { a = $2 + 0; b = $3 + 0; c = $4 + 0; k += (u[b]-u[a])*(v[c]-v[a]) < (u[c]-u[a])*(v[b]-v[a]) }
		END { print k + 0 }' "$1"
}

@test "triangles that straight edges turn over: facets are sampled there, and --uv has none" {
	f=$meshes/wild/flat_star_refused.off
	try 0 '' /dev/null mesh2rect -n 8 --uv="$tmp/star.obj" "$f"
	[ "$(turned "$tmp/star.obj")" = 0 ]
	grep -aq '^meta turned 0$' "$tmp/out"
	mesh2rect -v -n 8 --uv="$tmp/star.obj" "$f" 2>&1 >/dev/null | grep -Eq 'star.obj: [1-9] of 45 vertices are up to 0.00'
	mesh2rect -v -n 8 "$f" 2>"$tmp/err" | grep -a '^meta overlaid' | cut -d' ' -f3 >"$tmp/n"
	[ "$(cat "$tmp/n")" -gt 0 ]
	grep -q ": $(cat "$tmp/n") of 52 triangles .* near them the facets are sampled" "$tmp/err"
	# With --surface=facets only facets are sampled anyway, so this is not noted.
	mesh2rect -v -n 8 --surface=facets "$f" 2>&1 >/dev/null | run ! grep 'are sampled'
}

@test "every good mesh goes through the first pipeline" {
	local f
	for f in "$meshes"/good/*; do
		mesh2rect -q --max-loss=1 -n 32 "$f" | grid2lh | lhfft -K 2 | lh2grid | grid2mesh >"$tmp/smooth.off" ||
			{ echo "$f"; return 1; }
		[ "$(sed -n 2p "$tmp/smooth.off")" = "1089 2048 0" ]
	done
}

@test "K = 0 gives two faces back: max 3 %, mean 0.8 % of sqrt(area) at 129 x 129" {
	case $BUILD in */*) skip "a minute under sanitizers; the numbers are the same" ;; esac
	local f
	for f in face_man_scan_6k face_nefertiti_4.6k; do
		mesh2rect -n 128 "$meshes/good/$f.off" -o "$tmp/phi"
		grid2lh "$tmp/phi" | lhfft -K 0 | lh2grid -o "$tmp/psi"
		below "$(error_of "$tmp/phi" "$tmp/psi" max_rel)" 0.03
		below "$(error_of "$tmp/phi" "$tmp/psi" mean_rel)" 0.008
	done
}
