#!/usr/bin/env bash
# Configures and builds the Release version in build/.
#
#   scripts/build.sh [CMake options]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

configure_log=$(mktemp)
trap 'rm -f "$configure_log"' EXIT
if ! cmake -S . -B build -G Ninja -D CMAKE_BUILD_TYPE=Release "$@" >"$configure_log" 2>&1; then
  cat "$configure_log" >&2
  exit 1
fi

[[ $(ninja -C build -n) != *"no work to do"* ]] || exit 0

# A compiler takes up to 2 GB.
jobs=$(nproc)
while read -r key kilobytes _; do
  [[ $key == MemAvailable: ]] || continue
  fitting=$((kilobytes / 2000000))
  ((fitting >= jobs)) || jobs=$((fitting > 0 ? fitting : 1))
done </proc/meminfo

echo "Building with $jobs compilers at a time; the first time takes some minutes."
progress=(--quiet)
[[ ! -t 1 ]] || progress=()
ninja -C build -j "$jobs" "${progress[@]}" </dev/null
