# Run by ctest, with name, program, label and cost from CMakeLists.txt: a test for each suite of a program of GoogleTest.
# Tests of a suite share what takes long to make, such as the mesh of a figure or its pose.

if(NOT EXISTS "${program}")
  add_test("${name}_NOT_BUILT" "${program}")
  return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE result)
string(REGEX MATCHALL "(^|\n)[A-Za-z_][^ \n]*\\." suites "${listed}")
if(result OR NOT suites)
  message(FATAL_ERROR "${program} lists no tests: ${result}")
endif()
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "[\n.]" "" suite "${suite}")
  set(test "${name}.${suite}")
  add_test("${test}" "${program}" "--gtest_filter=${suite}.*")
  set_tests_properties("${test}" PROPERTIES LABELS ${label} TIMEOUT 600 COST ${cost})
endforeach()
