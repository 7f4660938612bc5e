# Configures SOURCE in the empty directory WORK, for GENERATOR, without pybind11: everything else is there.

file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK} -DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON
  -DWITH_tests=OFF -DWITH_examples=OFF -DWITH_benchmark=OFF -DWITH_page=OFF
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0 OR NOT output MATCHES "The Python module is not built: [^\n]*pybind11")
  message(FATAL_ERROR "${output}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK} --target help OUTPUT_VARIABLE targets)
if(NOT targets MATCHES "canonical-pose" OR targets MATCHES "canonical_pose_python")
  message(FATAL_ERROR "targets:\n${targets}")
endif()
