# Khronos' validator finds neither errors nor warnings in the glTF files of the tool.
# Called with -DTOOL=path -DMAKE_FIGURE=path -DNPM=path -DNODE=path -DWORK=directory; WORK is emptied first.

cmake_minimum_required(VERSION 3.19...3.31)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/package.json "{\"private\": true}")
execute_process(COMMAND ${NPM} install --no-audit --no-fund gltf-validator@2.0.0-dev.3.10 WORKING_DIRECTORY ${WORK}
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET TIMEOUT 120)
if(result)
  message("gltf-validator cannot be installed")
  return()
endif()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/validate_gltf.js DESTINATION ${WORK})
include(${CMAKE_CURRENT_LIST_DIR}/test_tool_inputs.cmake)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

foreach(input IN LISTS dirty_inputs ITEMS ball.off ball.mesh)
  string(REPLACE "." "_" name ${input})
  set(pose ${name}.glb)
  if(input STREQUAL ball.mesh)
    set(pose ${name}.vtu)
  endif()
  run(${TOOL} pose ${input} --components each --rounds 0 -o ${pose} --scene ${name}_scene.glb)
endforeach()
run(${TOOL} segment ball.off --parts 4 --method sweep -o parts.glb)
run(${TOOL} geodesics two_balls.off --source 0 --source 23 -o distances.glb)
run(${MAKE_FIGURE} --vertices 70000 figure.off) # indices of four bytes
run(${TOOL} pose figure.off --rounds 0 -o figure.glb --scene figure_scene.glb)
run(${MAKE_FIGURE} --vertices 260000 large.off) # quantized
run(${TOOL} pose large.off --rounds 0 -o large.glb --scene large_scene.glb)
file(GLOB files ${WORK}/*.glb)
execute_process(COMMAND ${NODE} validate_gltf.js ${files} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE report)
list(LENGTH files number)
message(STATUS "${number} files:\n${report}")
if(result)
  message(FATAL_ERROR "The validator finds errors or warnings.")
endif()
