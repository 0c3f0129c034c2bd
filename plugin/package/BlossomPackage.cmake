# SPDX-License-Identifier: LGPL-2.1-or-later
# Debian's package: cpack --config build/release/CPackConfig.cmake
# One package, for the parts are small beside what they stand on. FreeCAD, DRAW and the development
# files of Open CASCADE are large, and who wants the program alone wants none of them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME blossom)
set(CPACK_PACKAGE_CONTACT "${BLOSSOM_MAINTAINER} <${BLOSSOM_MAINTAINER_ADDRESS}>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Finds all intersections of free-form surfaces of CAD models and says how
far the answer is proven; cuts faces and solids along them and blends
between them: the command line program, the Python package (FreeCAD
imports it), a plugin for Open CASCADE's DRAW, and C++ libraries.")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
# The prefix is /usr for what looks at it while it is installed, too: Python's folder follows it.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(TARGET blossom_python)
  # The compiled module is of one version of Python.
  math(EXPR next "${BLOSSOM_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= 3.${BLOSSOM_PYTHON_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/postinst
                                         ${CMAKE_CURRENT_LIST_DIR}/prerm)
endif()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "freecad, occt-draw, python3-distributed, libocct-draw-dev, libtbb-dev, libocct-data-exchange-dev")

install(FILES plugin/package/copyright CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/blossom)
install(DIRECTORY plugin/cli/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/blossom)

# The sources as they are, without what is built: cpack --config build/release/CPackSourceConfig.cmake
set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME blossom-${PROJECT_VERSION})
string(REGEX REPLACE "([.+*?()|$])" "[\\1]" source_pattern "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${source_pattern}/(build[^/]*|results|[.]git)/" "/__pycache__/"
                              "/CMakeUserPresets[.]json$")
include(CPack)
