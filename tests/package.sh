#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Packs Blossom, installs the package in a bare Debian below FOLDER, and uses every door from an
# empty environment. What has to be built is built; root and a mirror of Debian are needed.
#
#   tests/package.sh [FOLDER]      FOLDER: build/package
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/support/setup.sh"
source "$root/tests/support/claims.sh"
folder=$(realpath -m "${1-$root/build/package}")
bare=$folder/debian

# The release of this system, from where its own packages come.
make_bare_system() {
  local release mirror
  release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
  mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
    awk -v release="$release" '$2 == release {print $1; exit}')
  as_root rm -rf "$bare"
  as_root debootstrap --variant=minbase "$release" "$bare" "$mirror" >"$folder/debootstrap.log"
}

# inside COMMAND...: in the bare system, with an environment that is as bare. Its /proc goes away
# with the namespace.
inside() {
  as_root unshare --mount sh -c 'mount -t proc proc "$0/proc" && cd / && exec env -i \
    PATH=/usr/bin:/bin:/usr/sbin:/sbin DEBIAN_FRONTEND=noninteractive chroot "$0" "$@"' "$bare" "$@" </dev/null
}
install_inside() {
  inside apt-get install -y -q --no-install-recommends "$@" >>"$folder/apt.log" 2>&1
}
as_user() { inside env -i PATH=/usr/bin:/bin "$@"; }

step "packages"
install_packages debootstrap dpkg-dev file

step "pack"
mkdir -p "$folder"
cmake --build "$build" -j "$(build_jobs)" --target installable
rm -f "$build"/blossom_*.deb
cpack --config "$build/CPackConfig.cmake"

step "bare system"
make_bare_system
as_root cp "$build"/blossom_*.deb "$bare/srv/"
as_root mkdir "$bare/srv/tests"
as_root cp -r "$root/tests/plugin/freecad" "$root/tests/plugin/draw" "$bare/srv/tests/"
as_root cp "$root/plugin/freecad/README.md" "$bare/srv/tests/freecad/"
other=/srv/tests/libTKernel.so.9.9  # what the workbench takes for another Open CASCADE
as_root "${CXX:-c++}" -shared -fPIC "$root/tests/plugin/python/other_kernel.cpp" -o "$bare$other"
: >"$folder/apt.log"
inside apt-get update -q >>"$folder/apt.log"

step "install"
claim "apt installs the package" install_inside "./srv/$(cd "$build" && echo blossom_*.deb)"

step "program and Python"
# prints TEXT COMMAND...: the command prints a line that begins so; its output is shown.
prints() {
  local output
  output=$("${@:2}" 2>&1) || true
  printf '%s\n' "$output"
  grep -q "^$1" <<<"$output"
}
claim "blossom runs" prints "blossom [0-9]" as_user blossom --version
python_answers() {
  as_user /usr/bin/python3 -c '
import blossom, numpy
saddle = numpy.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], float)
plane = numpy.array([[(0, 0, 0.25), (0, 1, 0.25)], [(1, 0, 0.25), (1, 1, 0.25)]], float)
found = blossom.intersect(saddle, plane)
assert found.status == "complete" and len(found.curves) == 1, found'
}
claim "Python imports blossom, and it answers" python_answers
# Two patches as files of models, and a list with the job to intersect them.
job=$bare/srv/job
as_root mkdir "$job"
net() {
  printf '{"schema": "blossom.net/1", "nets": [{"kind": "patch", "degree": [1, 1], "points": %s}]}' "$1" |
    as_root tee "$job/$2.json" >/dev/null
  as_user blossom convert "/srv/job/$2.json" -o "/srv/job/$2.step" -q
}
intersects_by_list() {
  net '[[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]' saddle
  net '[[[0, 0, 0.25], [0, 1, 0.25]], [[1, 0, 0.25], [1, 1, 0.25]]]' plane
  echo '{"id": "both", "arguments": ["intersect", "saddle.step", "plane.step", "--json", "-"]}' |
    as_root tee "$job/jobs.jsonl" >/dev/null
  as_user blossom batch /srv/job/jobs.jsonl -o /srv/job/results.jsonl -q &&
    grep -q '"status":"done".*"schema":"blossom.intersection/1".*"status":"complete"' "$job/results.jsonl"
}
claim "blossom intersects STEP files by a list of jobs" intersects_by_list
claim "there is a manual page" inside test -s /usr/share/man/man1/blossom-intersect.1.gz

step "FreeCAD and DRAW"
claim "apt installs them beside it" install_inside freecad freecad-python3 occt-draw xvfb xauth
example=/usr/share/doc/blossom/examples/intersect_two_faces.py
claim "freecadcmd runs the example" prints "ALL CLAIMS HOLD" \
  as_user BLOSSOM_EXAMPLE=$example freecadcmd /srv/tests/freecad/intersect_test.py
claim "FreeCAD's window runs the README's lines and the example" prints "ALL CLAIMS HOLD" \
  inside bash /srv/tests/freecad/run_window.sh window_test.py /srv/window - /srv/tests/freecad/README.md $example
as_root cp "$bare/srv/window/window.png" "$folder/"
for objects in objects documents; do
  claim "freecadcmd makes the workbench's $objects" prints "ALL CLAIMS HOLD" \
    as_user BLOSSOM_PROGRAM=/usr/bin/blossom BLOSSOM_OTHER_KERNEL=$other \
    freecadcmd "/srv/tests/freecad/${objects}_test.py"
done
claim "the tour of the workbench runs" prints "ALL CLAIMS HOLD" \
  inside bash /srv/tests/freecad/run_window.sh tour.py /srv/tour - /dev/null $example
printf 'pload -BlossomPlugin BLOSSOM\nhelp blintersect\n' | as_root tee "$bare/srv/load.tcl" >/dev/null
claim "DRAW loads the plugin by its name alone" prints "blintersect " \
  as_user occt-draw-7.6 -b -f /srv/load.tcl
# Debian's DRAW finds its own modelling commands by a link of this package.
claim "apt installs DRAW's links" install_inside libocct-draw-dev
claim "DRAW intersects" prints "ALL CLAIMS HOLD" \
  as_user occt-draw-7.6 -b -f /srv/tests/draw/blintersect_test.tcl

step "remove"
remove() { inside apt-get purge -y -q blossom >>"$folder/apt.log" 2>&1; }
claim "apt removes the package" remove
nothing_left() { ! inside find /usr /etc /var/lib/dpkg/info -iname '*blossom*' | grep .; }
claim "and nothing of it is left" nothing_left

printf '\nThe package works: %s\nThe window: %s\n' "$build"/blossom_*.deb "$folder/window.png"
