#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests but for the slow verification cases; for
# those too: ctest --test-dir build
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install-dependencies.sh --tests
scripts/build.sh -D VIBROIMPACT_BUILD_TESTS=ON
exec ctest --test-dir build --label-exclude '^verification-slow$' --no-tests=error \
  --output-on-failure --parallel "$(nproc)" </dev/null
