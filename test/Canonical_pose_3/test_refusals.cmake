# Unsupported code is refused at compile time with a message of the package: refused_complexes.cpp, with a
# macro for each case.

# add_canonical_pose_refusal_test(macro sentence)
function(add_canonical_pose_refusal_test macro sentence)
  set(directories "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_INCLUDE_DIRECTORIES>")
  # -isystem /usr/include would break #include_next of the standard library.
  set(directories
    "$<REMOVE_DUPLICATES:$<FILTER:${directories},EXCLUDE,^(/usr/include|${own_headers})$>>")
  set(definitions "$<TARGET_PROPERTY:canonical_pose_3_program,INTERFACE_COMPILE_DEFINITIONS>")
  add_test(NAME refusal.${macro}
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 -fsyntax-only -I${own_headers}
      "$<$<BOOL:${directories}>:-isystem$<JOIN:${directories},;-isystem>>"
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>"
      -D${macro}
      ${CMAKE_CURRENT_SOURCE_DIR}/refused_complexes.cpp
    COMMAND_EXPAND_LISTS)
  set_tests_properties(refusal.${macro} PROPERTIES
    LABELS header TIMEOUT 300
    PASS_REGULAR_EXPRESSION "${sentence}"
    FAIL_REGULAR_EXPRESSION "no type named;use of deleted;incomplete type")
endfunction()

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_canonical_pose_refusal_test(REFUSED_TRIANGULATION
    "only if its cells have a subdomain index.*or copy the cells to Indexed_tetrahedra_3")
  add_canonical_pose_refusal_test(REFUSED_LABELS "The cells of this complex have no labels")
endif()
