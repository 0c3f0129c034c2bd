# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the libraries for find_package(Blossom), each part with an export of its own, so that
# who wants core alone needs nothing else. What links CGAL's GPL parts is never among them.
include(CMakePackageConfigHelpers)

include(BlossomPublicHeaders)

set(BLOSSOM_EXPORTED)
set(folders)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Blossom)
foreach(part core occt cgal openmesh)
  if(NOT TARGET blossom_${part})
    continue()
  endif()
  list(APPEND BLOSSOM_EXPORTED ${part})
  install(TARGETS blossom_${part} EXPORT Blossom-${part} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT Blossom-${part} NAMESPACE Blossom:: DESTINATION ${package_folder})
  get_target_property(folder blossom_${part} SOURCE_DIR)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  list(APPEND folders ${folder})
endforeach()

# Which they are is found when they are installed: headers change more often than these files.
install(CODE "
  include(\"${CMAKE_CURRENT_LIST_DIR}/BlossomPublicHeaders.cmake\")
  blossom_public_headers(\"${PROJECT_SOURCE_DIR}\" \"${folders}\" headers)
  foreach(header \${headers})
    cmake_path(GET header PARENT_PATH folder)
    file(INSTALL \"${PROJECT_SOURCE_DIR}/\${header}\"
         DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/blossom/\${folder}\")
  endforeach()")

# Pages of them, where Doxygen is installed: cmake --build build/release --target api makes
# build/release/api/html/index.html
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  blossom_public_headers(${PROJECT_SOURCE_DIR} "${folders}" headers)
  set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/api)
  set(DOXYGEN_PROJECT_BRIEF "${PROJECT_DESCRIPTION}")
  set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
  set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/core/README.md)
  set(DOXYGEN_EXTRACT_ALL YES)
  set(DOXYGEN_HAVE_DOT NO)
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
  file(GLOB pages RELATIVE ${PROJECT_SOURCE_DIR} core/*.md core/*/README.md)
  doxygen_add_docs(api ${headers} ${pages} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endif()

get_target_property(core_libraries blossom_core LINK_LIBRARIES)
set(BLOSSOM_CORE_NEEDS_TBB FALSE)
if(core_libraries MATCHES "TBB::tbb")
  set(BLOSSOM_CORE_NEEDS_TBB TRUE)
endif()
configure_package_config_file(adapters/BlossomConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/BlossomConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/BlossomConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/BlossomConfig.cmake
              ${PROJECT_BINARY_DIR}/BlossomConfigVersion.cmake DESTINATION ${package_folder})

# For who builds without CMake: pkg-config --cflags --libs blossom
if(TARGET blossom_occt)
  get_target_property(occt_libraries blossom_occt LINK_LIBRARIES)
  list(FILTER occt_libraries INCLUDE REGEX "^TK")
  list(TRANSFORM occt_libraries PREPEND "-l")
  list(JOIN occt_libraries " " BLOSSOM_PC_OCCT)
  file(RELATIVE_PATH BLOSSOM_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(adapters/blossom.pc.in ${PROJECT_BINARY_DIR}/blossom.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/blossom.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/LICENSES/
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/blossom/LICENSES)

# All that is installed; it takes less time to build than the tests beside it.
add_custom_target(installable)
foreach(target blossom_core blossom_occt blossom_cgal blossom_openmesh blossom blossom_step
               blossom_documents blossom_written_docs
        TKBlossomDraw blossom_python)
  if(TARGET ${target})
    add_dependencies(installable ${target})
  endif()
endforeach()
