#!/bin/sh
# smooth.sh - smooth a surface through its conformal factor and mean curvature.
set -eu
out=${1:-build/demo}
mkdir -p "$out"

# A synthetic face of about 6000 vertices.
mkmesh -n 6000 face -o "$out/face.off"

# Map it onto a rectangle and compute (lambda, H).  Drop the Fourier coefficients below 2 percent
# of the field's root mean square, and solve for the surface that fits the rest.
mesh2rect "$out/face.off" | grid2lh | lhfft -K 2 | lh2grid | grid2mesh -o "$out/smooth.off"

echo "wrote $out/face.off (before) and $out/smooth.off (after)"
