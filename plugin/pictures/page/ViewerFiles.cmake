# SPDX-License-Identifier: LGPL-2.1-or-later
# Sets VIEWER_FILES to a source that holds what every page carries: three.js, our script, our style.
find_path(BLOSSOM_THREE_JS three.min.js PATHS /usr/share/javascript/three
          DOC "the folder of three.min.js and examples/js")
if(NOT BLOSSOM_THREE_JS)
  message(FATAL_ERROR "three.js, which draws pages, is not found. Install it (Debian's package is "
                      "libjs-three), or set BLOSSOM_THREE_JS to the folder of three.min.js.")
endif()
file(READ ${PROJECT_SOURCE_DIR}/LICENSES/MIT.txt text)
set(licence ${CMAKE_CURRENT_BINARY_DIR}/page/licence.js)
file(CONFIGURE OUTPUT ${licence} CONTENT "/* ${text}*/\n" @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/LICENSES/MIT.txt)
set(examples ${BLOSSOM_THREE_JS}/examples/js)
set(THREE_SCRIPT_parts
    ${licence} ${BLOSSOM_THREE_JS}/three.min.js ${examples}/controls/OrbitControls.js
    ${examples}/lines/LineSegmentsGeometry.js ${examples}/lines/LineMaterial.js
    ${examples}/lines/LineSegments2.js)
set(VIEWER_SCRIPT_parts ${CMAKE_CURRENT_LIST_DIR}/scene.js ${CMAKE_CURRENT_LIST_DIR}/viewer.js)
set(VIEWER_STYLE_parts ${CMAKE_CURRENT_LIST_DIR}/viewer.css)
set(VIEWER_FILES ${CMAKE_CURRENT_BINARY_DIR}/page/viewer_files.cpp)
foreach(text THREE_SCRIPT VIEWER_SCRIPT VIEWER_STYLE)
  set(${text} ${CMAKE_CURRENT_BINARY_DIR}/page/${text})
  execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${${text}_parts} OUTPUT_FILE ${${text}}.new
                  COMMAND_ERROR_IS_FATAL ANY)
  file(COPY_FILE ${${text}}.new ${${text}} ONLY_IF_DIFFERENT)
  file(SHA256 ${${text}} ${text}_SHA256)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${${text}_parts})
  set_property(SOURCE ${VIEWER_FILES} APPEND PROPERTY OBJECT_DEPENDS ${${text}})
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/viewer_files.cpp.in ${VIEWER_FILES} @ONLY)
set_property(SOURCE ${VIEWER_FILES} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
