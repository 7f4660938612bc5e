# Includes of internal headers lead downwards: a header of a room includes headers of this room and of those after it
# in the list, and of the public ones only plain data types and what works on points and indices.
# Called with -DINCLUDE=<the folder of this package's public headers>.

cmake_minimum_required(VERSION 3.18...3.31)
set(rooms pipeline registration injective energy target lattice body wavefront heat intrinsic soup linear_algebra
  support)
# What any room may use.
set(data_types point_matrix Options Registration_options Registration_progress Registration_summary Diagnosis_3
  Repaired_surface_3 Landmark_fields_3 surface_measures)
# What a room may use besides. The pipeline puts the public parts together. The default solver is a public class.
set(also_in_body Embedded_body_3 Tetrahedral_complex_traits_3)
set(also_in_linear_algebra Default_factor_traits_d Eigen_factor_traits_d)

set(defects "")
file(GLOB_RECURSE headers RELATIVE ${INCLUDE}/internal ${INCLUDE}/internal/*.h)
if(NOT headers)
  message(FATAL_ERROR "no header in ${INCLUDE}/internal")
endif()
foreach(header IN LISTS headers)
  get_filename_component(room ${header} DIRECTORY)
  get_filename_component(name ${header} NAME)
  string(REGEX REPLACE "(_impl)?\\.h$" "" owner ${name}) # X_impl.h defines what X.h declares
  list(FIND rooms "${room}" floor)
  if(floor EQUAL -1)
    string(APPEND defects "${header} is in no room of the list\n")
    continue()
  endif()
  file(STRINGS ${INCLUDE}/internal/${header} lines REGEX "#include <CGAL/(Canonical_pose_3/|canonical_pose_3)")
  foreach(line IN LISTS lines)
    if(line MATCHES "Canonical_pose_3/internal/([a-z_]+)/")
      list(FIND rooms "${CMAKE_MATCH_1}" floor_below)
      if(floor_below LESS floor)
        string(APPEND defects "${header}: ${line}\n")
      endif()
    elseif(line MATCHES "anonical_pose_3/?([A-Za-z_0-9]*)\\.h" AND NOT room STREQUAL "pipeline")
      if(NOT CMAKE_MATCH_1 IN_LIST data_types AND NOT CMAKE_MATCH_1 STREQUAL owner AND NOT CMAKE_MATCH_1 IN_LIST also_in_${room})
        string(APPEND defects "${header}: ${line}\n")
      endif()
    endif()
  endforeach()
endforeach()
if(defects)
  message(FATAL_ERROR "these includes lead upwards:\n${defects}")
endif()
