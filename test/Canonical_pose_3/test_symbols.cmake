# Definitions in headers are inline; otherwise, two sources of a program that include them could not be linked: no
# object file of the BUILD has a strong symbol of the package. NM lists the symbols.

file(GLOB_RECURSE objects ${BUILD}/*.o)
set(number 0)
foreach(object IN LISTS objects)
  execute_process(COMMAND ${NM} --defined-only --extern-only ${object}
    RESULT_VARIABLE result OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(NOT result EQUAL 0)
    continue()
  endif()
  string(REGEX MATCHALL " [TDBRSG] _ZNK?4CGAL[^\n]*" found "${symbols}")
  if(object MATCHES "src/compiled/") # Canonical_pose_3::compiled
    list(FILTER found EXCLUDE REGEX "(14all_eigenpairs|15examine_surface|18geodesic_distances|15prepare_surface|15landmark_fields|14coarse_surface|14refined_target|19extrapolated_fields|23Smacof_target_builder_3C[12]|23Smacof_target_builder_35build|10mds_target|15unfolded_target|12cut_contacts|15body_of_surface|15registered_pose|13joined_result|15pose_of_surface|15pose_of_complex|22make_arap_registration|16make_heat_solver|19make_default_factor|24make_default_lane_factor|25default_rotation_routines|18leading_eigenpairs|25largest_of_all_eigenpairs|28mesh_3_body_of_clean_surface|8diagnose|12align_target|17target_handedness|14repair_surface|14Lattice_body_3C[12]|27consensus_segmentation_tree|23sweep_segmentation_tree|13k_means_parts)E")
  endif()
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
