# Unsupported code is refused at compile time with messages of the package, and no others: refused_complexes.cpp.

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(directories "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_INCLUDE_DIRECTORIES>")
  # -isystem /usr/include would break #include_next of the standard library.
  set(directories
    "$<REMOVE_DUPLICATES:$<FILTER:${directories},EXCLUDE,^(/usr/include|${own_headers})$>>")
  set(definitions "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_COMPILE_DEFINITIONS>")
  add_test(NAME refusals
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 -fsyntax-only -I${own_headers}
      "$<$<BOOL:${directories}>:-isystem$<JOIN:${directories},;-isystem>>"
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
      ${CMAKE_CURRENT_SOURCE_DIR}/refused_complexes.cpp
    COMMAND_EXPAND_LISTS)
  set(labels "The cells of this complex have no labels")
  set(triangulation "only if its cells have a subdomain index.*or copy the cells to Indexed_tetrahedra_3")
  set_tests_properties(refusals PROPERTIES
    LABELS header TIMEOUT 300
    PASS_REGULAR_EXPRESSION "${labels}.*${triangulation};${triangulation}.*${labels}"
    FAIL_REGULAR_EXPRESSION "no type named;use of deleted;incomplete type")
endif()
