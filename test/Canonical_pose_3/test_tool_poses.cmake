# The commands pose, compare and geodesics, see test_tool.cmake.

# ---- pose: every format in, every format out ---------------------------------------------------------------

foreach(from IN ITEMS off obj ply stl)
  foreach(to IN ITEMS off obj ply stl)
    expect_exit(0 pose ball.${from} --rounds 0 --detail-length 0.3 -o out/${from}.${to} --target out/target.${to} --report out/report.json)
    expect_complete_report(out/report.json)
    expect_json(out/report.json 12 input vertices)
    expect_exit(0 check out/${from}.${to} --report out/check.json)
    expect_json(out/check.json 12 input vertices)
    expect_json(out/check.json 20 input faces)
    expect_exit(0 check out/target.${to})
  endforeach()
endforeach()
expect_same_bytes(out/obj.off out/ply.off) # if the format is another one; otherwise, the file is rewritten
expect_same_bytes(out/off.obj out/ply.obj)
expect_same_bytes(out/off.ply out/obj.ply)
expect_exit(0 pose notations.off --rounds 0 --detail-length 0.3 -o out/notations.obj)
expect_same_bytes(out/off.obj out/notations.obj)
foreach(format IN ITEMS off obj ply)
  expect_same_faces(ball.off out/${format}.off)
endforeach()

foreach(input IN LISTS dirty_inputs)
  expect_exit(0 pose ${input} -o out/a.off --report out/report.json --components largest --detail-length 0.3)
  expect_complete_report(out/report.json)
  expect_same_faces(${input} out/a.off)
endforeach()
foreach(components IN ITEMS largest each)
  expect_exit(0 pose two_balls.off -o out/a.off --components ${components} --spacing 0.05 --detail-length 0.3)
  expect_same_faces(two_balls.off out/a.off)
endforeach()

# What is small follows, and the report says so.
foreach(components IN ITEMS auto largest each)
  expect_exit(0 pose crumb.off -o out/a.off --report out/report.json --components ${components} --rounds 0 --detail-length 0.3)
  expect_complete_report(out/report.json)
  expect_json(out/report.json 1 followers 0 component)
  expect_json(out/report.json 12 followers 0 vertex)
  expect_json(out/report.json 0 followers 0 leader)
  expect_json(out/report.json ON followers 0 rigid)
endforeach()
expect_exit(0 pose crumb.off -o out/b.off --rounds 0 --detail-length 0.3)
expect_same_bytes(out/a.off out/b.off)
expect_refusal("2 connected components" pose crumb.off -o out/a.off --components refuse)

# What is in the middle of a large shape does not belong to it.
file(WRITE ${WORK}/nested.off "OFF\n8 8 0\n9 9 9\n9 -9 -9\n-9 9 -9\n-9 -9 9\n2.2 2.2 2.2\n2.2 -2.2 -2.2\n-2.2 2.2 -2.2\n-2.2 -2.2 2.2
3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n3 4 5 6\n3 4 7 5\n3 4 6 7\n3 5 7 6\n")
expect_refusal("2 connected components" pose nested.off -o out/a.off)
expect_exit(0 pose nested.off -o out/a.off --report out/report.json --components largest --rounds 0)
expect_json(out/report.json 1 followers 0 component)

expect_exit(0 pose ball.mesh -o out/pose.mesh --target out/target.off --report out/report.json)
expect_complete_report(out/report.json)
expect_json(out/report.json complex body kind)
expect_json(out/report.json 20 body tetrahedra)
expect_same_faces(ball.mesh out/pose.mesh)
expect_exit(0 check out/target.off)

expect_exit(0 pose ball.off -o out/a.off --quiet)
expect_match("<${stdout}${stderr}>" "^<>$")
expect_exit(0 pose ball.off -o out/a.off --kernel gaussian --landmarks 6 --detail-length 0.2 --tikhonov 1
  --iterations 5 --rounds 0 --geodesics exact --solver eigen --seed 3 --threads 1 --spring 0,3,0.5 --spring 1,2,0.5,10
  --direction 0,3,0.5,0,0 --direction 1,2,0.5,0,-1e-1,10 --handle 0,0,0,1 --handle 5,0,0,-1,10 --symmetric 0,3
  --symmetric 4,4,10)
expect_exit(0 pose ball.off -o out/a.off --paper-weights 100,10 --kernel gaussian-uncentred)
string(REPEAT "1\n" 11 numbers)
file(WRITE ${WORK}/factors.txt "2\n${numbers}")
expect_exit(0 pose ball.off -o out/a.off --matching-weights factors.txt --stiffness factors.txt)

# Progress is only shown on a terminal, after two seconds, in one line that is blank in the end: in all other successful
# runs, nothing is printed to stderr. Here the input comes late.
find_program(SCRIPT script)
if(SCRIPT AND CMAKE_HOST_SYSTEM_NAME STREQUAL "Linux")
  foreach(quiet IN ITEMS "" --quiet)
    set(command "on a terminal: pose - ${quiet}")
    execute_process(COMMAND ${SCRIPT} -qec "(sleep 2.6 && cat ball.off) | ${TOOL} pose - -o out/a.off ${quiet} > out/stdout.txt" /dev/null
      WORKING_DIRECTORY ${WORK} TIMEOUT 120 RESULT_VARIABLE exit_code OUTPUT_VARIABLE stderr INPUT_FILE /dev/null)
    if(quiet)
      expect_match("${exit_code}<${stderr}>" "^0<>$")
    else()
      expect_match("${exit_code}<${stderr}>" "^0<\r2 s: reading standard input +\r.*\r +\r>$")
    endif()
  endforeach()
else()
  message(STATUS "What the tool tells a terminal is not tested: the program script was not found")
endif()

# Computed values are given: the distances exactly, the target as it was written.
expect_exit(0 geodesics ball.off --source 0 --source 3 --source 8 -o out/distances.txt)
expect_exit(0 pose ball.off -o out/a.off --rounds 1 --given-distances out/distances.txt --target out/target.off
  --report out/report.json)
expect_json(out/report.json 3 target landmarks)
expect_exit(0 pose ball.off -o out/b.off --rounds 1 --given-distances out/distances.txt --given-target out/target.off
  --report out/report.json)
expect_json(out/report.json given target kernel)
expect_exit(0 pose ball.off -o out/c.off --rounds 1 --given-distances out/distances.txt --target out/canonical.off
  --frame canonical)
expect_same_bytes(out/canonical.off out/target.off)
expect_exit(0 pose ball.off -o out/d.off --rounds 1 --given-distances out/distances.txt --given-target out/canonical.off)
expect_same_bytes(out/d.off out/b.off)
expect_exit(0 pose ball.mesh --rounds 1 -o out/pose.mesh --target out/target.off)
expect_exit(0 pose ball.mesh --rounds 1 -o out/again.mesh --given-target out/target.off)
file(WRITE ${WORK}/seven.txt "0 1 2 3 4 5 6")
expect_refusal("has 12 vertices, but a target has 24" pose two_balls.off -o out/a.off --components each
  --given-target ball.off)
expect_refusal("no multiple of the 12 vertices" pose ball.off -o out/a.off --given-distances seven.txt)
expect_refusal("has no landmark" pose ball.off -o out/a.off --given-distances factors.txt)

# ---- compare -----------------------------------------------------------------------------------------------

expect_exit(0 compare ball.off ball.ply)
expect_match("${stdout}" "\n0.000000  0.000000   mean of 1 pair\n$")
expect_exit(0 compare ball.off hole.off ball.stl --pairs --report out/pairs.json)
expect_json(out/pairs.json hole.off pairs 0 poses 1)
expect_match("${stdout}" "   hole.off ball.stl\n[^\n]*mean of 3 pairs\n$")
expect_exit(0 compare ball.off hole.off ball.stl)
expect_match("${stdout}" "   ball.off\n[^\n]*   hole.off\n[^\n]*   ball.stl\n[^\n]*mean of 3 pairs\n$")
expect_exit(2 compare ball.off)
expect_refusal("'missing.off': it cannot be opened" compare ball.off missing.off)
expect_refusal("'missing.off': it cannot be opened" pose ball.off -o out/a.off --given-target missing.off)
expect_refusal("ball.off, two_balls.off: poses of 12 and 24 points" compare ball.off two_balls.off)

# ---- geodesics ---------------------------------------------------------------------------------------------

foreach(kind IN ITEMS heat wavefront exact)
  expect_exit(0 geodesics two_balls.off --source 0 --source 23 -o out/distances.txt --geodesics ${kind})
  file(STRINGS ${WORK}/out/distances.txt lines)
  list(LENGTH lines length)
  expect_match(${length} "^24$")
  list(GET lines 0 line)
  expect_match("${line}" "^0 inf$")
  list(GET lines 23 line)
  expect_match("${line}" "^inf 0$")
endforeach()
foreach(input IN ITEMS hole.off turned.off quad.off crossing.off)
  expect_exit(0 geodesics ${input} --source 3 -o out/distances.txt)
  file(STRINGS ${WORK}/out/distances.txt lines)
  list(LENGTH lines length)
  expect_match(${length} "^12$")
endforeach()
# what shares an edge is reached; an isolated vertex is not; faces without area are repaired
foreach(kind IN ITEMS heat wavefront exact)
  file(WRITE ${WORK}/three.off "OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n9 9 9\n3 0 1 2\n3 0 1 3\n3 0 1 4\n")
  expect_exit(0 geodesics three.off --source 2 -o out/distances.txt --geodesics ${kind})
  file(READ ${WORK}/out/distances.txt distances)
  expect_match("${distances}" "^(1|1\\.0000000[0-9]*|0\\.9999999[0-9]*)\n1\\.414213[0-9]*\n0\n(2|2\\.0000000[0-9]*|1\\.9999999[0-9]*)\n(2|2\\.0000000[0-9]*|1\\.9999999[0-9]*)\ninf\n$")
  file(WRITE ${WORK}/flat.off "OFF\n6 5 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0.5 0 0\n0.5 -1 0\n3 0 4 2\n3 4 3 2\n3 4 1 3\n3 0 1 4\n3 0 5 1\n")
  expect_exit(0 geodesics flat.off --source 2 -o out/distances.txt --geodesics ${kind})
  file(READ ${WORK}/out/distances.txt distances)
  expect_match("${distances}" "\n1\\.11803[0-9]*\n2\\.06155[0-9]*\n$")
endforeach()
expect_exit(0 pose flat.off -o out/flat.off --geodesics exact --landmarks 10 --rounds 0) # many paths in a plane take long

# ---- the sample: the time is accounted for, and the bytes do not depend on the threads -------------------------

if(MAKE_FIGURE)
  execute_process(COMMAND ${MAKE_FIGURE} --vertices 2500 ${WORK}/figure.off COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  foreach(threads IN ITEMS 1 2)
    set(words pose figure.off -o out/pose_${threads}.off --threads ${threads} --report out/report.json)
    expect_exit(0 ${words})
    expect_complete_report(out/report.json)
    expect_accounted_time(out/report.json ${words})
  endforeach()
  expect_same_bytes(out/pose_1.off out/pose_2.off)
  expect_same_faces(figure.off out/pose_1.off)
  expect_match("${stdout}" "converged after [0-9]+ iterations, energy .*stress")

  # No cell is inverted, unless this is allowed. There are rounds, unless they are switched off.
  execute_process(COMMAND ${MAKE_FIGURE} --vertices 2500 --pose sitting ${WORK}/sitting.off
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  expect_exit(0 pose sitting.off -o out/a.off --rounds 2 --report out/rounds.json)
  expect_match("${stdout}" ", 0 of [0-9]+ cells inverted")
  expect_rounds(out/rounds.json 2)
  file(READ ${WORK}/out/rounds.json json)
  foreach(field IN ITEMS stress energy median_edge_strain seconds)
    string(JSON value GET "${json}" rounds 1 ${field})
    if(NOT value GREATER 0)
      fail("out/rounds.json: ${field} of a round should be positive, but is ${value}.")
    endif()
  endforeach()
  expect_exit(0 pose sitting.off -o out/a.off --rounds 0 --detail-length 0.05 --no-injective --report out/no_rounds.json)
  expect_match("${stdout}" ", [1-9][0-9]* of [0-9]+ cells inverted")
  expect_rounds(out/no_rounds.json 0)
  expect_exit(0 pose sitting.off -o out/a.off --rounds 0 --detail-length 0.05 --injective)
  expect_match("${stdout}" ", 0 of [0-9]+ cells inverted")
  expect_exit(2 pose sitting.off -o out/a.off --injective --no-injective)
  expect_exit(2 pose sitting.off -o out/a.off --rounds -1)
endif()
