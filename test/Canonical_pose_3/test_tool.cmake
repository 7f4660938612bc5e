# Checks the command-line contract of canonical-pose from outside:
#
#   cmake -DTOOL=path -DMAKE_FIGURE=path -DWORK=directory [-DHAS_MPI=ON] -DPARTS=part;... -P test_tool.cmake
#
# The parts are the files test_tool_PART.cmake that CMakeLists.txt lists; none needs another. WORK is emptied first.
# MAKE_FIGURE writes the sample; if it is empty, tests that require it are skipped.
# test_tool_inputs.cmake and test_tool_bad_files.cmake write the input files, one for each requirement that an input
# can violate; test_tool_checks.cmake contains the assertions about runs and reports.

cmake_minimum_required(VERSION 3.19)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/out)
include(${CMAKE_CURRENT_LIST_DIR}/test_tool_inputs.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/test_tool_bad_files.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/test_tool_checks.cmake)
foreach(part IN LISTS PARTS)
  include(${CMAKE_CURRENT_LIST_DIR}/test_tool_${part}.cmake)
endforeach()
