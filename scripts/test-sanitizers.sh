#!/usr/bin/env bash
# Builds everything with the address and undefined-behaviour sanitizers in build-sanitizers/ and runs
# the tests, under mpirun too, but not the whole runs against references. An hour or two on two cores.
# What is overlooked in other people's libraries stands in tests/sanitizers/.
#
#   scripts/test-sanitizers.sh [ctest options]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install-dependencies.sh --tests
cmake --preset sanitizers
cmake --build --preset sanitizers
exec ctest --preset sanitizers "$@" </dev/null
