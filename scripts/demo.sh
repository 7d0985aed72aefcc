#!/usr/bin/env bash
# From a bare Debian 12 to figures: installs what is missing, builds, computes two beams that hit
# each other on two ranks, and draws the results.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install-dependencies.sh
tests=()
[[ -e build/CMakeCache.txt ]] || tests=(-D VIBROIMPACT_BUILD_TESTS=OFF)
scripts/build.sh "${tests[@]}"

source scripts/mpi-environment.sh
mpirun -np 2 build/vibroimpact params/impacting-beams.prm --overwrite </dev/null
build/vibroimpact-plot output/impacting-beams

cat <<'TEXT'

Open next:
  output/impacting-beams/figures/     contact force of the release, response curves
  output/impacting-beams/summary.txt  the results in numbers
  output/impacting-beams/release.pvd  in ParaView: Apply, Filters / Warp By Vector, Apply, Play
TEXT
