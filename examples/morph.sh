#!/bin/sh
# morph.sh - turn one surface into another in ten frames.
set -eu
out=${1:-build/demo}
mkdir -p "$out"

# For each surface: make a mesh, map it to a grid, and compute (lambda, H).
for kind in face tooth; do
	mkmesh -n 4000 $kind | mesh2rect -n 96 | grid2lh -o "$out/$kind.lhg"
done

# Interpolate ten pairs (lambda, H) from the first to the second; solve for the surface of each.
lhinterp -n 10 "$out/face.lhg" "$out/tooth.lhg" | lh2grid | grid2mesh -o "$out/frame-%02d.off"

echo "wrote $out/frame-01.off to $out/frame-10.off"
