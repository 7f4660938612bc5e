# Each public header compiles alone, and when included twice, without warnings: one test per header with the
# compiler of the build, except for slow-compiling parts (each of which src/compiled/ includes first), and one test
# for all of them together, header-only, with the other one of g++ and clang++, if present.

set(own_headers ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE public_headers CONFIGURE_DEPENDS RELATIVE ${own_headers} "${own_headers}/CGAL/*.h")
list(FILTER public_headers EXCLUDE REGEX "/internal/")
if(NOT SPECTRA_INCLUDE_DIRECTORY)
  list(FILTER public_headers EXCLUDE REGEX "Biharmonic|Heat_kernel|Shape_dna")
endif()

# add_canonical_pose_header_test(name compiler header...)
function(add_canonical_pose_header_test name compiler)
  set(directories "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_INCLUDE_DIRECTORIES>")
  # -isystem /usr/include would break #include_next of the standard library.
  set(directories
    "$<REMOVE_DUPLICATES:$<FILTER:${directories},EXCLUDE,^(/usr/include|${own_headers})$>>")
  set(definitions "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_COMPILE_DEFINITIONS>")
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
      ${compiled} ${source}
    COMMAND_EXPAND_LISTS)
  set_tests_properties(header.${name} PROPERTIES LABELS header TIMEOUT 300)
endfunction()

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(compiled -DCGAL_CANONICAL_POSE_3_COMPILED)
  foreach(header IN LISTS public_headers)
    get_filename_component(name ${header} NAME)
    add_canonical_pose_header_test(${name} ${CMAKE_CXX_COMPILER} ${header})
  endforeach()
  set(compiled "")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(other clang++)
  else()
    set(other g++)
  endif()
  find_program(CANONICAL_POSE_3_OTHER_COMPILER ${other})
  mark_as_advanced(CANONICAL_POSE_3_OTHER_COMPILER)
  if(CANONICAL_POSE_3_OTHER_COMPILER)
    add_canonical_pose_header_test(all.${other} ${CANONICAL_POSE_3_OTHER_COMPILER} ${public_headers})
    set_tests_properties(header.all.${other} PROPERTIES TIMEOUT 900 COST 900) # one of the longest: early
  endif()
endif()
