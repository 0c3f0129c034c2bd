# SPDX-License-Identifier: LGPL-2.1-or-later
# The test of this sample: install, configure, build, run; everything below BUILD.
set(folder ${BUILD}/samples/installed_package)
file(REMOVE_RECURSE ${folder})
foreach(
  step
  "--install;${BUILD};--prefix;${folder}/prefix"
  "-S;${SOURCE};-B;${folder}/build;-G;${GENERATOR};-DCMAKE_PREFIX_PATH=${folder}/prefix;-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS};-DCMAKE_BUILD_TYPE=Release"
  "--build;${folder}/build")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${folder}/build/lid_on_a_bowl COMMAND_ERROR_IS_FATAL ANY)
