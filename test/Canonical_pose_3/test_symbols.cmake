# Definitions in headers are inline; otherwise, two sources of a program that include them could not be linked: no
# object file of the BUILD but those of the library has a strong symbol of the package. NM lists the symbols.

file(GLOB_RECURSE objects ${BUILD}/*.o)
list(FILTER objects EXCLUDE REGEX "src/engine/") # the library
set(number 0)
foreach(object IN LISTS objects)
  execute_process(COMMAND ${NM} --defined-only --extern-only ${object}
    RESULT_VARIABLE result OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(NOT result EQUAL 0)
    continue()
  endif()
  string(REGEX MATCHALL " [TDBRSG] _ZNK?4CGAL[^\n]*" found "${symbols}")
  if(found)
    list(JOIN found "\n" found)
    message(SEND_ERROR "${object} defines what is not inline:\n${found}")
  endif()
  math(EXPR number "${number} + 1")

  # References of the package to functions that may not exist do not make those of the program weak: a missing
  # function would be called instead of reported by the linker.
  if(object MATCHES "strong_references")
    execute_process(COMMAND ${NM} --undefined-only ${object} OUTPUT_VARIABLE symbols)
    foreach(function IN ITEMS openblas_get_num_threads openblas_set_num_threads omp_get_max_active_levels
        omp_set_max_active_levels)
      if(NOT symbols MATCHES " U _?${function}")
        message(SEND_ERROR "${object}: the reference to ${function} is not strong:\n${symbols}")
      endif()
    endforeach()
  endif()
endforeach()
message(STATUS "${number} object files")
if(number EQUAL 0)
  message(FATAL_ERROR "there are no object files in ${BUILD}")
endif()
