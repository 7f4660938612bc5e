# The assertions of test_tool.cmake. A failure stops the test and prints the command and its output.

# Runs the tool in WORK; sets command, exit_code, stdout and stderr.
macro(run_tool)
  execute_process(COMMAND ${TOOL} ${ARGN} WORKING_DIRECTORY ${WORK} TIMEOUT 120
    RESULT_VARIABLE exit_code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
  set(command "canonical-pose ${ARGN}")
endmacro()

function(fail what)
  string(REPLACE ";" " " command "${command}")
  message(FATAL_ERROR "${what}\n  ${command}\n  exit code: ${exit_code}\n  stdout: ${stdout}\n  stderr: ${stderr}")
endfunction()

macro(expect_exit expected)
  run_tool(${ARGN})
  if(NOT exit_code STREQUAL "${expected}")
    fail("The exit code should be ${expected}.")
  endif()
  if(exit_code STREQUAL "0" AND NOT stderr STREQUAL "")
    fail("Nothing should be on stderr.")
  endif()
endmacro()

function(expect_match text pattern)
  if(NOT text MATCHES "${pattern}")
    fail("'${text}' does not match '${pattern}'.")
  endif()
endfunction()

# Exit code 1, one line on stderr that contains `message`, nothing on stdout, no file.
function(expect_refusal message)
  file(REMOVE_RECURSE ${WORK}/out)
  file(MAKE_DIRECTORY ${WORK}/out)
  expect_exit(1 ${ARGN})
  expect_match("<${stdout}>" "^<>$")
  expect_match("${stderr}" "^canonical-pose: [^\n]*\n$")
  string(FIND "${stderr}" "${message}" position)
  if(position EQUAL -1)
    fail("The line on stderr should contain '${message}'.")
  endif()
  file(GLOB files ${WORK}/out/* ${WORK}/*part*)
  if(files)
    fail("These files should not be there: ${files}")
  endif()
endfunction()

function(expect_same_bytes a b)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/${a} ${WORK}/${b} RESULT_VARIABLE differs)
  if(differs)
    fail("${a} and ${b} should be the same.")
  endif()
endfunction()

# Lines that contain only integers are faces, cells, and numbers of elements.
function(expect_same_faces a b)
  set(numbers "^ *[0-9]+( +[0-9]+)* *$")
  file(STRINGS ${WORK}/${a} of_a REGEX "${numbers}")
  file(STRINGS ${WORK}/${b} of_b REGEX "${numbers}")
  foreach(lines IN ITEMS of_a of_b)
    list(TRANSFORM ${lines} STRIP)
    list(TRANSFORM ${lines} REPLACE " +" " ")
  endforeach()
  if(NOT of_a STREQUAL "${of_b}" OR of_a STREQUAL "")
    fail("${a} and ${b} should have the same faces and cells.")
  endif()
endfunction()

# expect_json(file value path...)
function(expect_json file value)
  file(READ ${WORK}/${file} json)
  string(JSON found GET "${json}" ${ARGN})
  if(NOT found STREQUAL "${value}")
    fail("${file}: ${ARGN} is ${found}, but should be ${value}.")
  endif()
endfunction()

function(expect_rounds file expected)
  file(READ ${WORK}/${file} json)
  string(JSON number LENGTH "${json}" rounds)
  if(NOT number EQUAL expected)
    fail("${file} should have ${expected} rounds, not ${number}.")
  endif()
endfunction()

# All fields are present, and all numbers are numbers.
function(expect_complete_report file)
  file(READ ${WORK}/${file} json)
  foreach(field IN ITEMS
      input.vertices input.faces input.components input.boundary_edges input.non_manifold input.degenerate_faces
      input.self_intersections body.kind body.vertices body.tetrahedra target.kernel target.landmarks
      target.covering_radius target.stress target.eigenvalues target.max_geodesic target.reflected
      target.is_handedness_certain followers rounds
      registration.iterations registration.converged registration.energy registration.energy_match
      registration.energy_arap registration.inverted registration.flipped_faces registration.volume_ratio
      registration.median_edge_strain solver total_seconds peak_memory_bytes versions.cgal)
    string(REPLACE "." ";" path ${field})
    string(JSON value ERROR_VARIABLE error GET "${json}" ${path})
    if(error OR value STREQUAL "")
      fail("${file} should contain ${field}.")
    endif()
  endforeach()
  set(names read diagnosis geodesics target body factorization local_steps global_steps write)
  foreach(name IN LISTS names)
    list(FIND names ${name} index)
    expect_json(${file} ${name} stages ${index} name)
  endforeach()
endfunction()

# Converts a positive number of seconds (0.25, 1.5e-05) to integer microseconds.
function(microseconds result seconds)
  if(NOT seconds MATCHES "^([0-9]+)(\\.([0-9]+))?(e([+-])0*([0-9]+))?$")
    fail("'${seconds}' is not a time.")
  endif()
  set(digits "${CMAKE_MATCH_1}")
  set(fraction "${CMAKE_MATCH_3}000000000000000000")
  set(exponent "${CMAKE_MATCH_6}")
  if(CMAKE_MATCH_5 STREQUAL "-" AND exponent GREATER 0)
    string(REPEAT 0 ${exponent} zeros)
    set(fraction "${zeros}${digits}${fraction}") # one digit is before the point
    string(SUBSTRING "${fraction}" 1 -1 fraction)
    set(digits 0)
  endif()
  string(SUBSTRING "${fraction}" 0 6 fraction)
  string(REGEX MATCH "[1-9][0-9]*$" without_zeros "${digits}${fraction}")
  math(EXPR whole "0${without_zeros}")
  set(${result} ${whole} PARENT_SCOPE)
endfunction()

# The stages add up to at most the total, and to most of it: a stage that is missing, or that is counted twice, is
# noticed, a process that waits for others is not.
function(expect_accounted_time file)
  file(READ ${WORK}/${file} json)
  set(sum 0)
  foreach(index RANGE 8)
    string(JSON seconds GET "${json}" stages ${index} seconds)
    microseconds(stage ${seconds})
    math(EXPR sum "${sum} + ${stage}")
  endforeach()
  string(JSON seconds GET "${json}" total_seconds)
  microseconds(total ${seconds})
  math(EXPR percent "100 * ${sum} / ${total}")
  message(STATUS "${file}: the stages add up to ${percent} % of ${total} microseconds")
  if(percent LESS 60 OR percent GREATER 100)
    fail("${file}: the stages add up to ${percent} % of the total.")
  endif()
endfunction()
