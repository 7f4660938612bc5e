# Runs the program of the README on a mesh, which must converge without inverted cells. For the programs of two parts,
# the output is checked.

function(run program)
  execute_process(COMMAND ./${program} tube.off OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message(STATUS "${program}: ${output}")
  foreach(expected IN LISTS ARGN)
    if(NOT output MATCHES "${expected}")
      message(SEND_ERROR "${program} did not print '${expected}'")
    endif()
  endforeach()
endfunction()

execute_process(COMMAND ${CMAKE_COMMAND} -DFILE=tube.off -P ${CMAKE_CURRENT_LIST_DIR}/write_tube.cmake)
run(alone "^converged after [0-9]+ iterations, .* 0 of [0-9]+ cells inverted")
foreach(program IN ITEMS with_first without_first)
  if(EXISTS ${program})
    run(${program} "(^|\n)with TetGen: tetgen\n"
      "(^|\n)without TetGen: the program was built without TetGen\n")
  endif()
endforeach()
