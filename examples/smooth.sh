#!/bin/sh
# smooth.sh - smooths a mesh, MESH or a synthetic face, at a chosen scale: smooth.sh [OUT [MESH]].
set -eu
out=${1:-build/demo}
mkdir -p "$out"

# Without MESH: a synthetic face of about 6000 vertices.
mesh=${2:-$out/face.off}
[ $# = 2 ] || mkmesh -n 6000 face -o "$mesh"

# Map it onto a rectangle, and compute lambda and H.  Drop the waves that are shorter than 6 % of the
# square root of the area, solve for the surface, and move the vertices of the mesh onto it.
mesh2rect --uv="$out/uv.ply" "$mesh" | grid2lh | lhfft --scale=6% | lh2grid |
	grid2mesh --on="$out/uv.ply" -o "$out/smooth.ply"

echo "wrote $out/smooth.ply, the smooth $mesh"
