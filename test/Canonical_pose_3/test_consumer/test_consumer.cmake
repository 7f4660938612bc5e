# Builds and runs a small external project that uses the package in three ways:
# find_package() on an installation, FetchContent, and add_subdirectory(), which is only configured. FetchContent does the
# same, and builds the library again, which takes long: it has the label package.

set(installation ${CMAKE_CURRENT_BINARY_DIR}/test_consumer/installation)
add_test(NAME consumer.install
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --config $<CONFIG>
    --component development --prefix ${installation})
set_tests_properties(consumer.install PROPERTIES FIXTURES_SETUP installation LABELS consumer)

# add_canonical_pose_consumer_test(name way [option...])
function(add_canonical_pose_consumer_test name way)
  add_test(NAME consumer.${name}
    COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test
      ${CMAKE_CURRENT_SOURCE_DIR}/test_consumer
      ${CMAKE_CURRENT_BINARY_DIR}/test_consumer/${name}
      --build-generator ${CMAKE_GENERATOR} --build-target consumer
      --build-options -DWAY=${way} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
        -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} -DCGAL_DIR=${CGAL_DIR} ${ARGN}
      --test-command consumer)
  set_tests_properties(consumer.${name} PROPERTIES LABELS consumer TIMEOUT 1200 COST 200)
endfunction()

set(tetgen -DEXPECT_TETGEN=$<TARGET_EXISTS:Canonical_pose_3::tetgen>)
add_canonical_pose_consumer_test(find_package find_package
  -DCMAKE_PREFIX_PATH=${installation} ${tetgen})
set_tests_properties(consumer.find_package PROPERTIES FIXTURES_REQUIRED installation)
add_test(NAME consumer.add_subdirectory COMMAND ${CMAKE_COMMAND} -G ${CMAKE_GENERATOR}
  -S ${CMAKE_CURRENT_SOURCE_DIR}/test_consumer -B ${CMAKE_CURRENT_BINARY_DIR}/test_consumer/add_subdirectory
  -DWAY=add_subdirectory -DPACKAGE_DIRECTORY=${PROJECT_SOURCE_DIR} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
  -DCGAL_DIR=${CGAL_DIR} -DWITH_CHOLMOD=${WITH_CHOLMOD} -DWITH_TBB=${WITH_TBB} -DWITH_TETGEN=${WITH_TETGEN} ${tetgen})
set_tests_properties(consumer.add_subdirectory PROPERTIES LABELS consumer TIMEOUT 1200)
# Nothing but CGAL and Eigen.
add_canonical_pose_consumer_test(FetchContent FetchContent -DPACKAGE_DIRECTORY=${PROJECT_SOURCE_DIR}
  -DWITH_CHOLMOD=OFF -DWITH_TBB=OFF -DWITH_TETGEN=OFF)
set_tests_properties(consumer.FetchContent PROPERTIES LABELS package)

# The program in the installed README.
add_test(NAME consumer.readme
  COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test
    ${CMAKE_CURRENT_SOURCE_DIR}/test_consumer/readme
    ${CMAKE_CURRENT_BINARY_DIR}/test_consumer/readme
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_PREFIX_PATH=${installation} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} -DCGAL_DIR=${CGAL_DIR}
      -DREADME=${installation}/${CMAKE_INSTALL_DOCDIR}/README.md
    --test-command ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_SOURCE_DIR}/test_consumer/readme/run.cmake)
set_tests_properties(consumer.readme PROPERTIES LABELS consumer TIMEOUT 1200 COST 200 FIXTURES_REQUIRED installation)

# A build without CMake: all sources of the library in one, with CGAL and Eigen only. With the label package: to the end. (With
# ONE_SOURCE, the library itself is compiled so.)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(directories "$<TARGET_PROPERTY:Canonical_pose_3,INTERFACE_INCLUDE_DIRECTORIES>;$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>")
  set(directories "$<REMOVE_DUPLICATES:$<FILTER:${directories},EXCLUDE,^/usr/include$>>")
  set(all_sources ${PROJECT_SOURCE_DIR}/src/engine/all.cpp)
  if(NOT ONE_SOURCE)
    add_test(NAME consumer.all_sources_compile
      COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 "-I$<JOIN:${directories},;-I>" -fsyntax-only ${all_sources}
      COMMAND_EXPAND_LISTS)
    set_tests_properties(consumer.all_sources_compile PROPERTIES LABELS consumer TIMEOUT 1200 COST 100)
  endif()
  add_test(NAME consumer.all_sources
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++17 "-I$<JOIN:${directories},;-I>" -o consumer_of_all_sources
      ${CMAKE_CURRENT_SOURCE_DIR}/test_consumer/consumer.cpp ${all_sources} -lgmp -lmpfr
    COMMAND_EXPAND_LISTS)
  set_tests_properties(consumer.all_sources PROPERTIES LABELS package TIMEOUT 1200)
endif()
