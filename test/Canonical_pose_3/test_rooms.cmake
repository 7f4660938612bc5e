# Includes lead downward: a file of a folder of the engine includes only files of this folder and of those after it in the
# list, and public headers only of plain data types and of functions on points and indices. Nothing in include/ includes
# src/. Programs include public headers only.
# Called with -DROOT=<the folder of the package>.

cmake_minimum_required(VERSION 3.18...3.31)
set(rooms match pipeline stance segmentation descriptors registration injective energy target lattice body wavefront heat intrinsic surface linear_algebra
  support)
# Public headers that any folder may include.
set(data_types Face_list point_matrix Options Registration_options Registration_progress Registration_summary Unfolding Diagnosis_3
  Repaired_surface_3 Landmark_fields_3 Surface_component_3 Vertex_combination_3 surface_measures)
# Additional public headers per folder. The pipeline combines the public parts. The default solver is a public class.
set(also_in_match Body_deformer_3 Elastic_body_3 Prepared_surface_3 Surface_body_3 Tetrahedral_arap_registrar_3 pose_steps Coarse_surface_3
  canonical_frame repair_surface call_with_threads Match_options Matchable_surface_3 Surface_match_3 transfer_attributes)
set(also_in_stance Coarse_surface_3 Limb_direction_3 Skeleton_3)
set(also_in_target Intrinsic_symmetry_3)
set(also_in_body Embedded_body_3 Tetrahedral_complex_traits_3 Conforming_body_3)
set(also_in_segmentation Coarse_surface_3 Segmentation_options Segmentation_tree_3 repair_surface)
set(also_in_descriptors Coarse_surface_3 repair_surface)
set(also_in_linear_algebra Cholmod_factor_traits_d Default_factor_traits_d Eigen_factor_traits_d)

set(defects "")
set(gates ${ROOT}/include/CGAL/Canonical_pose_3/internal)
file(GLOB_RECURSE gate_headers RELATIVE ${gates} ${gates}/*.h)
file(GLOB_RECURSE engine_files RELATIVE ${ROOT}/src/engine ${ROOT}/src/engine/*.h ${ROOT}/src/engine/*.cpp)
list(REMOVE_ITEM engine_files all.cpp)
if(NOT gate_headers OR NOT engine_files)
  message(FATAL_ERROR "no headers in ${ROOT}")
endif()
# check_includes(directory file...)
function(check_includes directory)
  foreach(file IN LISTS ARGN)
    get_filename_component(room ${file} DIRECTORY)
    get_filename_component(owner ${file} NAME_WE) # X.cpp defines what X.h declares
    list(FIND rooms "${room}" floor)
    if(floor EQUAL -1)
      string(APPEND defects "${file} is in no folder of the list\n")
      continue()
    endif()
    file(STRINGS ${directory}/${file} lines REGEX "#include (<CGAL/(Canonical_pose_3/|canonical_pose_3)|\")")
    foreach(line IN LISTS lines)
      if(line MATCHES "(Canonical_pose_3/internal|\"\\.\\.)/([a-z_0-9]+)/")
        list(FIND rooms "${CMAKE_MATCH_2}" floor_below)
        if(floor_below LESS floor)
          string(APPEND defects "${file}: ${line}\n")
        endif()
      elseif(line MATCHES "anonical_pose_3/?([A-Za-z_0-9]*)\\.h" AND NOT room STREQUAL "pipeline")
        if(NOT CMAKE_MATCH_1 IN_LIST data_types AND NOT CMAKE_MATCH_1 STREQUAL owner
           AND NOT CMAKE_MATCH_1 IN_LIST also_in_${room})
          string(APPEND defects "${file}: ${line}\n")
        endif()
      endif()
    endforeach()
  endforeach()
  set(defects "${defects}" PARENT_SCOPE)
endfunction()
check_includes(${gates} ${gate_headers})
check_includes(${ROOT}/src/engine ${engine_files})
if(defects)
  message(FATAL_ERROR "these includes lead upwards:\n${defects}")
endif()

# strangers(message pattern glob...): no file may have a line that matches the pattern.
function(refuse_lines message pattern)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ARGN})
  list(FILTER files EXCLUDE REGEX "^src/engine/")
  if(NOT files)
    message(FATAL_ERROR "no file in ${ARGN}")
  endif()
  set(found "")
  foreach(file IN LISTS files)
    file(STRINGS ${ROOT}/${file} lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      string(APPEND found "${file}: ${line}\n")
    endforeach()
  endforeach()
  if(found)
    message(FATAL_ERROR "${message}:\n${found}")
  endif()
endfunction()
refuse_lines("these headers include sources" "#include (\"|<engine)" ${ROOT}/include/*.h)
refuse_lines("these formats use the commands" "#include \"(commands|collection)/" ${ROOT}/src/tool/formats/*)
refuse_lines("these programs use what is internal" "Canonical_pose_3/internal/|engine/|(^|[^a-z_])internal *(::|;)"
  ${ROOT}/src/*.h ${ROOT}/src/*.cpp ${ROOT}/examples/*.h ${ROOT}/examples/*.cpp ${ROOT}/benchmark/*.h ${ROOT}/benchmark/*.cpp)

# all.cpp includes every source that a program needs.
file(READ ${ROOT}/src/engine/all.cpp all)
foreach(file IN LISTS engine_files)
  if(file MATCHES "\\.cpp$" AND NOT file MATCHES "^body/(mesh_3|tetgen)_body" AND NOT all MATCHES "#include \"${file}\"")
    message(SEND_ERROR "src/engine/all.cpp lacks ${file}")
  endif()
endforeach()
