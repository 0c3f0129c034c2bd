# SPDX-License-Identifier: LGPL-2.1-or-later
# The arrows of the architecture: which include lines a folder may have.
cmake_minimum_required(VERSION 3.25)
set(checked_files 0)

# Every file of these endings below a folder includes only what matches `allowed`.
function(check folder endings allowed)
  list(TRANSFORM endings PREPEND "${ROOT}/${folder}/*" OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE files ${patterns})
  foreach(file ${files})
    file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include")
    list(FILTER includes EXCLUDE REGEX "include[ \t]*(${allowed})")
    foreach(include ${includes})
      message(SEND_ERROR "${file} may not have: ${include}")
    endforeach()
  endforeach()
  list(LENGTH files count)
  math(EXPR count "${checked_files} + ${count}")
  set(checked_files ${count} PARENT_SCOPE)
endfunction()

set(standard_library "<[a-z_0-9]+>")
set(core_sources "<(Eigen|tbb|oneapi/tbb|boost/multiprecision)/|<immintrin.h>")

# Each room of core may use those before it.
set(rooms base math forms blossom subdivision bounds intersection queries tracing trimming
          blending)
foreach(room ${rooms})
  list(APPEND so_far ${room})
  string(JOIN "|" below ${so_far})
  check(core/${room} ".h" "\"core/(${below})/|${standard_library}")
  check(core/${room} ".cpp" "\"core/(${below})/|${standard_library}|${core_sources}")
endforeach()
# What users call joins the rooms, and is in no room.
check(core ".h" "\"core/|${standard_library}")
check(core ".cpp" "\"core/|${standard_library}|${core_sources}")
file(GLOB found_rooms LIST_DIRECTORIES true RELATIVE "${ROOT}/core" "${ROOT}/core/*")
foreach(room ${found_rooms})
  if(IS_DIRECTORY "${ROOT}/core/${room}" AND NOT room IN_LIST rooms)
    message(SEND_ERROR "core/${room} is no room of core: name it in this test")
  endif()
endforeach()

foreach(library occt cgal openmesh)
  check(adapters/${library} ".h;.cpp" "\"core/|\"adapters/${library}/|<")
endforeach()
foreach(door cli draw python freecad)
  check(plugin/${door} ".h;.cpp" "\"core/|\"adapters/|\"plugin/${door}/|<")
endforeach()

# A wrong ROOT would find nothing and pass.
if(checked_files LESS 20)
  message(SEND_ERROR "only ${checked_files} files found below ${ROOT}")
endif()
