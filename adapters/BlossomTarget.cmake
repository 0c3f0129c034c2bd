# SPDX-License-Identifier: LGPL-2.1-or-later
# What all of Blossom's targets have in common.

if(BLOSSOM_SANITIZE STREQUAL ON)
  set(BLOSSOM_SANITIZERS -fsanitize=address,undefined)
elseif(BLOSSOM_SANITIZE)
  set(BLOSSOM_SANITIZERS -fsanitize=${BLOSSOM_SANITIZE})
endif()

# Warnings and sanitizers of our own build; never exported.
function(blossom_own target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow)
  # GCC 12 sees overlaps and overflows in "text" + std::string() where there are none (its bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow
                           -Wno-stringop-overread -Wno-array-bounds)
  endif()
  if(BLOSSOM_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(BLOSSOM_SANITIZE)
    target_compile_options(${target} PRIVATE ${BLOSSOM_SANITIZERS} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC ${BLOSSOM_SANITIZERS})
  endif()
endfunction()

# Doors and tests spend little time in code of their own: it is compiled quickly, and the optimiser's
# time is kept for the libraries below. Never for objects of these: of templates that they instantiate,
# the linker takes the first it finds, for all.
function(blossom_light target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Sources of one folder are compiled together, some at a time: what they include is read, and what they
# use of it compiled, once. Names in their anonymous namespaces are different therefore. Sources with
# compile options of their own stay alone, and those with SKIP_UNITY_BUILD_INCLUSION.
set(BLOSSOM_TOGETHER 16)
function(blossom_unity target)
  if(NOT BLOSSOM_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The compiler takes a source that is included for a header, whose classes many sources would see; and
    # the more it sees at once, the more often GCC 12 takes an optional that is set for one that is not.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-maybe-uninitialized)
    # It looks for memory that it may use again, a fifteenth of its work, only beyond this many kB.
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=1048576)
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REPLACE "/" "_" room ${folder})
    math(EXPR count_${room} "0${count_${room}} + 1")
    math(EXPR part "(${count_${room}} - 1) / ${BLOSSOM_TOGETHER}")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${part})
  endforeach()
endfunction()

# A library of this folder's sources, included from the root: #include "core/forms/patch.h". Folders
# with a CMakeLists.txt are targets of their own.
function(blossom_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp
       ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  file(GLOB_RECURSE others CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt)
  list(REMOVE_ITEM others ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt)
  foreach(other ${others})
    cmake_path(GET other PARENT_PATH folder)
    list(FILTER sources EXCLUDE REGEX "^${folder}/")
  endforeach()
  add_library(blossom_${name} ${sources})
  add_library(Blossom::${name} ALIAS blossom_${name})
  set_target_properties(blossom_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(blossom_${name} PUBLIC cxx_std_20)
  target_include_directories(blossom_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/blossom>)
  blossom_own(blossom_${name})
  blossom_unity(blossom_${name})
endfunction()

# Headers that most sources of a target read are read once. Every source still names what it needs:
# with BLOSSOM_PRECOMPILE off nothing is missing.
function(blossom_precompile target)
  if(BLOSSOM_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# The same headers as another target's, which are read for both of them once.
function(blossom_precompiled_by target other)
  if(BLOSSOM_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

set(BLOSSOM_STANDARD_HEADERS <algorithm> <array> <cmath> <functional> <limits> <map> <memory>
    <numbers> <optional> <span> <string> <utility> <vector>)
set(BLOSSOM_OCCT_HEADERS <BRep_Builder.hxx> <BRep_Tool.hxx> <BRepAdaptor_Surface.hxx>
    <Geom2d_Curve.hxx> <Geom_BSplineSurface.hxx> <Geom_Plane.hxx> <TopExp.hxx> <TopExp_Explorer.hxx>
    <TopTools_IndexedMapOfShape.hxx> <TopTools_MapOfShape.hxx> <TopoDS.hxx>)
