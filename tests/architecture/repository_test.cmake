# SPDX-License-Identifier: LGPL-2.1-or-later
# Every source has its licence line, and no text names a path of somebody's machine.
cmake_minimum_required(VERSION 3.25)

set(folders core adapters plugin tests samples .ci)
set(endings h cpp hpp py sh cmake tcl in)
foreach(folder ${folders})
  foreach(ending ${endings})
    list(APPEND patterns "${ROOT}/${folder}/*.${ending}")
  endforeach()
  list(APPEND patterns "${ROOT}/${folder}/CMakeLists.txt")
  list(APPEND text_patterns "${ROOT}/${folder}/*.md" "${ROOT}/${folder}/*.txt"
       "${ROOT}/${folder}/*.json" "${ROOT}/${folder}/*.xml")
endforeach()
file(GLOB_RECURSE sources ${patterns} "${ROOT}/.ci/run")
list(APPEND sources "${ROOT}/CMakeLists.txt")
file(GLOB_RECURSE texts ${text_patterns})
file(GLOB top "${ROOT}/*.md" "${ROOT}/*.json")

foreach(source ${sources})
  file(STRINGS "${source}" first LIMIT_COUNT 3 REGEX "SPDX-License-Identifier: [A-Z]")
  if(NOT first)
    message(SEND_ERROR "${source} has no SPDX-License-Identifier in its first lines")
  endif()
endforeach()

foreach(text ${sources} ${texts} ${top})
  file(STRINGS "${text}" lines REGEX "/(root|work|farm|tmp|home)/|deb[.]debian|registry[.]npmjs")
  foreach(line ${lines})
    message(SEND_ERROR "${text} names a machine: ${line}")
  endforeach()
endforeach()

list(LENGTH sources count)
if(count LESS 20)
  message(SEND_ERROR "only ${count} sources found below ${ROOT}")
endif()
