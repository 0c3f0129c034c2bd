# SPDX-License-Identifier: LGPL-2.1-or-later
# What tests/run.sh and samples/run.sh have in common: packages, configuring, building, and a
# loud end when a step fails. Sourced by bash; sets root and build.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/release

build_packages=(
  build-essential cmake ninja-build
  libtbb-dev libboost-dev libeigen3-dev zlib1g-dev
  libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
  libocct-visualization-dev libocct-ocaf-dev libocct-data-exchange-dev libocct-draw-dev
  libcgal-dev lib3mf-dev libopenmesh-dev libcli11-dev nlohmann-json3-dev libjs-three
  pybind11-dev python3-dev swig
  libgtest-dev libbenchmark-dev
)
# Heavy ones, of which CMake leaves out the tests where they are missing: freecad and chromium.
test_packages=(
  freecad freecad-python3 occt-draw python3-distributed python3-numpy python3-mypy python3-scipy
  pkg-config xvfb xauth chromium
)

current_step=start
step() {
  current_step=$1
  printf '\n== %s\n' "$1"
}
report_end() {
  local code=$?
  [ "$code" -eq 0 ] || printf '\nFAILED in step: %s (exit code %s)\n' "$current_step" "$code" >&2
}
trap report_end EXIT

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

# install_packages PACKAGE...: those that are missing, nothing else.
install_packages() {
  local package missing=()
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed ||
      missing+=("$package")
  done
  if [ "${#missing[@]}" -eq 0 ]; then
    echo "all ${#} packages are there"
    return
  fi
  echo "installing: ${missing[*]}"
  as_root apt-get update -q
  as_root apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# Compilers of heavy templates want about 1.5 GB each.
build_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  if [ "$memory" -lt 1 ]; then memory=1; fi
  echo $((cores < memory ? cores : memory))
}

# configure PRESET
#
# What is built from nothing is built by rooms, which takes less work; a folder that is there keeps
# its way: by single sources, one that is touched is quicker.
configure() {
  local options=()
  if [ ! -f "$root/build/$1/CMakeCache.txt" ]; then options+=(-DBLOSSOM_UNITY=ON); fi
  # Precompiled headers are kept in its cache only when it is told that they do not look at the time.
  if command -v ccache >/dev/null; then
    options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache")
  fi
  (cd "$root" && cmake --preset "$1" "${options[@]}")
}
