# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the libraries for find_package(Blossom), each part with an export of its own, so that
# who wants core alone needs nothing else. What links CGAL's GPL parts is never among them.
include(CMakePackageConfigHelpers)

set(BLOSSOM_EXPORTED)
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
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/blossom/${folder}
          FILES_MATCHING PATTERN "*.h" PATTERN "gpl" EXCLUDE)
endforeach()

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
