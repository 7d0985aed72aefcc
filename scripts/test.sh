#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests.
#
#   scripts/test.sh          those that notice most for their time, some minutes
#   scripts/test.sh --all    and those with the label "slow", some hours
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

left_out=(--label-exclude '^slow$')
case "${1-}" in
"") ;;
--all) left_out=() ;;
*)
  echo "usage: ${0##*/} [--all]" >&2
  exit 1
  ;;
esac

scripts/install-dependencies.sh --tests
scripts/build.sh -D VIBROIMPACT_BUILD_TESTS=ON
exec ctest --test-dir build "${left_out[@]}" --no-tests=error \
  --output-on-failure --parallel "$(nproc)" </dev/null
