#!/usr/bin/env bash
# Installs the Debian 12 packages that vibroimpact needs and that are not there yet. Says nothing
# when all of them are.
#
#   scripts/install-dependencies.sh            what building and running needs
#   scripts/install-dependencies.sh --tests    and what the tests need besides
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config file
  libdeal.ii-dev petsc-dev slepc-dev libmumps-dev libfftw3-dev libnlopt-dev
  zlib1g-dev
  libhdf5-openmpi-dev libopenmpi-dev openmpi-bin
  libeigen3-dev libboost-dev libboost-program-options-dev
  libopenblas0-serial
  python3 python3-h5py python3-matplotlib python3-xarray
)
test_packages=(libgtest-dev python3-netcdf4 python3-pip python3-pytest)

case "${1-}" in
"") ;;
--tests) packages+=("${test_packages[@]}") ;;
*)
  echo "usage: ${0##*/} [--tests]" >&2
  exit 1
  ;;
esac

fail() {
  printf 'install-dependencies: %s\n' "$@" >&2
  exit 1
}

# The second letter of dpkg's state is "i" when a package is installed, be it on hold or not.
missing_packages() {
  local state package installed=" "
  while read -r state package; do
    [[ $state == ?i* ]] && installed+="$package "
  done < <(dpkg-query --show --showformat '${db:Status-Abbrev} ${Package}\n' "${packages[@]}" \
    2>/dev/null || true)
  for package in "${packages[@]}"; do
    [[ $installed == *" $package "* ]] || printf '%s ' "$package"
  done
}

command -v apt-get >/dev/null ||
  fail "this needs Debian 12 or a relative of it, with apt." \
    "Elsewhere, install what cmake/dependencies.cmake looks for and build with CMake."

read -r -a missing <<<"$(missing_packages)"
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || fail "packages are missing, and there is neither root nor sudo." \
    "Ask an administrator for:" "  apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo)
  # Nobody can type a password where there is no terminal.
  [[ -t 0 ]] || as_root+=(--non-interactive)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
run() {
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "$@" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    fail "this command failed: $*"
  fi
}

echo "Installing ${#missing[@]} packages: ${missing[*]}"
((EUID == 0)) || "${as_root[@]}" true || fail "sudo was refused; as root, run:" \
  "  apt-get install --no-install-recommends ${missing[*]}"
run apt-get -q update
# On a machine just started, the system's own updates may still hold the lock.
run apt-get -q --yes --no-install-recommends -o DPkg::Lock::Timeout=300 install "${missing[@]}"
