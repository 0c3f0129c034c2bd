#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs below the build folder, as for two prefixes, and uses what is there with an empty
# environment: each part has to be where its user looks.
#
# usage: staged_test.sh BUILD FOLDER SOURCE
set -euo pipefail
build=$1 folder=$2 source=$3
source "$source/tests/support/claims.sh"

python=$(sed -n 's/^BLOSSOM_PYTHON_EXECUTABLE:.*=//p' "$build/CMakeCache.txt")
bare() { env -i PATH=/usr/bin:/bin "$@"; }

rm -rf "$folder"
for prefix in /usr /usr/local /opt/somewhere; do
  DESTDIR=$folder cmake --install "$build" --prefix "$prefix" >/dev/null
done

names_no_folder_of_the_build() { ! grep -rlF -e "$build" -e "$source" "$folder"; }
claim "nothing installed names a folder of the build" names_no_folder_of_the_build

says_its_version() { bare "$1/bin/blossom" --version | grep '^blossom [0-9]' >/dev/null; }
# What reads and writes STEP is loaded for it. The model is damaged, so writing is not all well.
model=$source/tests/data/inputs/nan-pole-in-face-2.brep
writes_and_reads_step() {
  bare "$1/bin/blossom" convert "$model" -o "$folder/model.step" >/dev/null 2>&1 || test $? -eq 3
  bare "$1/bin/blossom" info "$folder/model.step" | grep "1 face" >/dev/null
}
for prefix in /usr /usr/local /opt/somewhere; do
  claim "the program runs below $prefix" says_its_version "$folder$prefix"
  claim "and writes and reads STEP" writes_and_reads_step "$folder$prefix"
done

# The folder of the package, without the staging folder in front.
package_of() { (cd "$folder" && find ".$1/lib" -name '_core.*.so' -printf '%h\n' | sed 's|^\.||'); }
is_searched() {
  local package
  package=$(package_of "$1")
  bare "$python" -I -c "import site, sys; sys.exit(sys.argv[1] not in site.getsitepackages())" \
    "${package%/blossom}"
}
claim "Python looks where the package is below /usr" is_searched /usr
claim "Python looks where the package is below /usr/local" is_searched /usr/local

# Without it FreeCAD's shapes come as copies, and nothing says so.
bridges() {
  bare PYTHONPATH="$1" "$python" -B -c "
import blossom
if blossom._core.has_swig_bridge:
    import blossom.swig_shapes"
}
imports() { bare PYTHONPATH="$1" "$python" -B -c "import blossom; print(blossom.intersect)" >/dev/null; }
for prefix in /usr /usr/local /opt/somewhere; do
  package=$(package_of "$prefix")
  claim "the package below $prefix can be imported" imports "$folder${package%/blossom}"
  claim "and takes FreeCAD's shapes as they are" bridges "$folder${package%/blossom}"
  addon=$folder$prefix/share/freecad/Mod/Blossom
  claim "the add-on below $prefix has it" test "$addon/blossom" -ef "$folder$package"
  claim "and says what it is" grep -q '<name>Blossom</name>' "$addon/package.xml"
  claim "the workbench is in it" test -s "$addon/freecad/blossom/init_gui.py"
  claim "with its icons" test -s "$addon/freecad/blossom/resources/icons/Blossom.svg"
  claim "and what it was built with" grep -q 'OCCT = "7' "$addon/blossom/_built_with.py"
done

# Headers: what users include and all that these include, but no other.
include=$folder/opt/somewhere/include/blossom
has_what_headers_include() {
  local header
  grep -rhoE '^#include "[^"]+' "$include" | sed 's/.*"//' | sort -u | while read -r header; do
    test -s "$include/$header" || { echo "missing: $header"; return 1; }
  done
}
claim "headers that users call are installed" test -s "$include/core/surface_intersection.h"
claim "with all that they include" has_what_headers_include
claim "and no others" test ! -e "$include/core/cells" -a ! -e "$include/core/tracing"

# A program in C++ without CMake.
builds_by_pkg_config() {
  local flags
  flags=$(PKG_CONFIG_PATH=$1/lib/pkgconfig pkg-config --cflags --libs blossom) &&
    c++ -std=c++20 -Werror -o "$folder/lid_on_a_bowl" "$source/samples/installed_package/lid_on_a_bowl.cpp" \
      $flags && bare "$folder/lid_on_a_bowl" >/dev/null
}
if command -v pkg-config >/dev/null; then
  claim "pkg-config has all that a program needs, which compiles without a warning" builds_by_pkg_config "$folder/opt/somewhere"
fi

# DRAW always exits with 0, so what it prints decides.
loads_in_draw() {
  bare CSF_BlossomPluginDefaults="$1/share/opencascade/resources/DrawResources" \
    LD_LIBRARY_PATH="$1/lib" "$draw" -b -f "$source/tests/plugin/draw/blintersect_test.tcl" 2>&1 |
    grep 'ALL CLAIMS HOLD' >/dev/null
}
if draw=$(command -v occt-draw-7.6 || command -v occt-draw); then
  claim "DRAW loads the plugin below /opt/somewhere" loads_in_draw "$folder/opt/somewhere"
fi
