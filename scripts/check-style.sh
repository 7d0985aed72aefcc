#!/usr/bin/env bash
# Checks the format of all C++ sources, and with --tidy also runs clang-tidy over what is compiled
# in a build folder. Needs clang-format 14, and clang-tidy 14 for --tidy (Debian 12 has both).
#
#   scripts/check-style.sh [--tidy [BUILD FOLDER]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t sources < <(find src tests postprocess benchmarks -name '*.cc' -o -name '*.h' | sort)
clang-format --dry-run -Werror "${sources[@]}"

if [[ ${1-} == --tidy ]]; then
  folder=${2-build}
  [[ -e $folder/compile_commands.json ]] || {
    echo "check-style: $folder/compile_commands.json is not there; build first" >&2
    exit 1
  }
  find src -name '*.cc' -print0 | sort -z |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$folder" --quiet
fi
