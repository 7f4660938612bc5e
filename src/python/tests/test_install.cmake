# Installs the Python module into the empty directory WORK and imports it from there. WAY: `cmake` installs what was built
# in BUILD, `pip` builds and installs SOURCE into a virtual environment, without network.

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
unset(ENV{PYTHONPATH})

# run(command...): a failure ends the test.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

if(WAY STREQUAL "pip")
  run(${PYTHON} -m venv --system-site-packages ${WORK}/environment)
  set(PYTHON ${WORK}/environment/bin/python)
  set(ENV{BUILD_DIRECTORY} ${WORK}/build)
  set(ENV{CMAKE_ARGS} "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
  run(${PYTHON} -m pip install --no-build-isolation --no-index ${SOURCE})
else()
  foreach(component IN ITEMS development python) # the library may be a shared one
    run(${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK})
  endforeach()
  file(GLOB_RECURSE modules ${WORK}/__init__.py)
  list(LENGTH modules number)
  if(NOT number EQUAL 1)
    message(FATAL_ERROR "installed: ${modules}")
  endif()
  get_filename_component(directory "${modules}/../.." ABSOLUTE)
  set(ENV{PYTHONPATH} ${directory})
endif()
file(WRITE ${WORK}/import.py
"import canonical_pose
report = canonical_pose.check([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
print(canonical_pose.__file__, canonical_pose.__version__, report['input'])
")
run(${PYTHON} -B import.py)
string(FIND "${output}" "${WORK}/" position)
if(NOT position EQUAL 0 OR NOT output MATCHES " ${VERSION} .*'faces': 1")
  message(FATAL_ERROR "imported: ${output}")
endif()
