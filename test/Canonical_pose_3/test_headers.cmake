# Public headers compile twice in one source, in the reverse of their order, without warnings and without anything but CGAL
# and Eigen, by the other one of g++ and clang++, if present: tests include them in their order by this one. With the label
# single_header: in their order, and each alone.

set(own_headers ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE public_headers CONFIGURE_DEPENDS RELATIVE ${own_headers} "${own_headers}/CGAL/*.h")
list(FILTER public_headers EXCLUDE REGEX "/internal/")

# add_canonical_pose_header_test(name compiler header...)
function(add_canonical_pose_header_test name compiler)
  set(directories "$<TARGET_PROPERTY:Canonical_pose_3,INTERFACE_INCLUDE_DIRECTORIES>;$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>;$<TARGET_PROPERTY:CGAL::CGAL,INTERFACE_INCLUDE_DIRECTORIES>")
  # -isystem /usr/include would break #include_next of the standard library.
  set(directories
    "$<REMOVE_DUPLICATES:$<FILTER:${directories},EXCLUDE,^(/usr/include|${own_headers})$>>")
  set(definitions "CGAL_EIGEN3_ENABLED;CGAL_CANONICAL_POSE_3_USE_TETGEN")
  set(lines "")
  foreach(header IN LISTS ARGN ARGN)
    string(APPEND lines "#include <${header}>\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "${lines}" @ONLY)
  add_test(NAME header.${name}
    COMMAND ${compiler} -std=c++17 -fsyntax-only -Wall -Wextra -Wshadow -Werror -I${own_headers}
      "$<$<BOOL:${directories}>:-isystem$<JOIN:${directories},;-isystem>>"
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
      ${source}
    COMMAND_EXPAND_LISTS)
  set_tests_properties(header.${name} PROPERTIES LABELS header TIMEOUT 300)
endfunction()

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  foreach(header IN LISTS public_headers)
    get_filename_component(name ${header} NAME)
    add_canonical_pose_header_test(${name} ${CMAKE_CXX_COMPILER} ${header})
    set_tests_properties(header.${name} PROPERTIES LABELS single_header)
  endforeach()
  add_canonical_pose_header_test(all ${CMAKE_CXX_COMPILER} ${public_headers})
  set_tests_properties(header.all PROPERTIES LABELS single_header)
  set(reversed_headers ${public_headers})
  list(REVERSE reversed_headers)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(other clang++)
  else()
    set(other g++)
  endif()
  find_program(CANONICAL_POSE_3_OTHER_COMPILER ${other})
  mark_as_advanced(CANONICAL_POSE_3_OTHER_COMPILER)
  if(CANONICAL_POSE_3_OTHER_COMPILER)
    add_canonical_pose_header_test(all_reversed.${other} ${CANONICAL_POSE_3_OTHER_COMPILER} ${reversed_headers})
    set_tests_properties(header.all_reversed.${other} PROPERTIES TIMEOUT 900 COST 900) # one of the longest: early
  else()
    add_canonical_pose_header_test(all_reversed ${CMAKE_CXX_COMPILER} ${reversed_headers})
  endif()
endif()
