#!/usr/bin/env bash
# Makes the pages into a site with search: scripts/build-site.sh [FOLDER], by default build/site.
# Needs python3-sphinx python3-myst-parser furo libjs-katex of Debian 12, and says so where they are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(python3-sphinx python3-myst-parser furo libjs-katex)
if ! dpkg-query --show "${packages[@]}" >/dev/null 2>&1; then
  echo "build-site: install what it needs: apt-get install ${packages[*]}" >&2
  exit 1
fi
folder=${1-build/site}
/usr/bin/python3 -m sphinx -q -j auto -c docs/site -d "$folder/.doctrees" . "$folder"
echo "Open $folder/README.html"
