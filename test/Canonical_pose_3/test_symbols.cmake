# What headers define is inline, else two sources of one program that include them could not be linked: no
# object file of the BUILD has a symbol of the package that no other may have. NM lists them.

file(GLOB_RECURSE objects ${BUILD}/*.o)
set(number 0)
foreach(object IN LISTS objects)
  execute_process(COMMAND ${NM} --defined-only --extern-only ${object}
    RESULT_VARIABLE result OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(NOT result EQUAL 0)
    continue()
  endif()
  string(REGEX MATCHALL " [TDBRSG] _ZNK?4CGAL[^\n]*" found "${symbols}")
  if(object MATCHES "compiled\\.cpp\\.o$") # Canonical_pose_3::compiled
    list(FILTER found EXCLUDE REGEX "15pose_of_(surface|complex)E|22make_arap_registrationE|16make_heat_solverE|19make_default_factorE|24make_default_lane_factorE|25default_rotation_routinesE")
  endif()
  if(found)
    list(JOIN found "\n" found)
    message(SEND_ERROR "${object} defines what is not inline:\n${found}")
  endif()
  math(EXPR number "${number} + 1")
endforeach()
message(STATUS "${number} object files")
if(number EQUAL 0)
  message(FATAL_ERROR "there are no object files in ${BUILD}")
endif()
