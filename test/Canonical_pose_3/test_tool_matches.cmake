# collection --match and compare --mean, see test_tool.cmake.

# ---- the mean ----------------------------------------------------------------------------------------------

expect_wrong_usage("mean.txt" compare ball.off ball.ply --mean out/mean.txt)
expect_refusal("it is an input" compare ball.off ball.ply --mean ball.ply)
expect_refusal("ball.off, two_balls.off: poses of 12 and 24 points" compare ball.off two_balls.off --mean out/a.off)
expect_refusal("must be a surface, as 'ball.off' is" compare ball.off ball.ply --mean out/mean.mesh)
expect_refusal("must be a tetrahedral mesh" compare ball.mesh ball.mesh --mean out/mean.off)
expect_exit(0 compare ball.mesh ball.mesh --mean out/mean.mesh)
expect_same_faces(ball.mesh out/mean.mesh)
expect_exit(0 compare ball.off ball.ply --mean out/mean.off)
expect_match("${stdout}" "mean of 1 pair\n$")
expect_same_faces(ball.off out/mean.off)
expect_exit(0 compare ball.off out/mean.off)
expect_match("${stdout}" "\n0.000000  0.000000   ball.off out/mean.off\n")
run_tool(compare ball.off ball.ply --mean -)
expect_match("${exit_code}${stdout}" "^0OFF\n")
expect_match("${stderr}" "^proper ")

# ---- matches -----------------------------------------------------------------------------------------------

expect_exit(2 collection ball.off --database a.db --match ball.ply)
expect_exit(2 collection ball.off --database a.db --matches out/m)
set(of_ball collection ball.off --database out/a.db)
expect_wrong_usage("must be different folders" ${of_ball} --match ball.ply --matches out/m --poses ${WORK}/out/m/)
expect_refusal("the template '${WORK}/nowhere.off' cannot be read" ${of_ball} --match nowhere.off --matches out/m)
expect_refusal("the match of '${WORK}/ball.off' would replace it" ${of_ball} --match two_balls.off --matches .)
expect_refusal("the match of '${WORK}/shapes/ball.off' would replace '${WORK}/ball.off'" collection shapes/ball.off
  --database out/a.db --match ball.off --matches .)
expect_refusal("the matches of '${WORK}/ball.off' and '${WORK}/ball.ply' would have the same name" ${of_ball} ball.ply
  --match two_balls.off --matches out/m)
expect_refusal("the poses of '${WORK}/ball.off' and '${WORK}/shapes/ball.off' would have the same name" ${of_ball}
  --match shapes/ball.off --matches out/m)
run_tool(collection two_balls.off --database out/a.db --match ball.mesh --matches out/m)
expect_match("${exit_code}${stderr}" "^1canonical-pose: the template '[^\n]*ball.mesh': a surface is needed")

# ---- what is transferred -----------------------------------------------------------------------------------

expect_wrong_usage("labels are written to .txt" match ball.off ball.ply --transfer labels.txt -o out/a.off)
expect_wrong_usage("is a text, but --transfer" match ball.off ball.ply --transfer pose -o out/a.txt)
expect_wrong_usage("does not hold what is transferred" match ball.off ball.ply --transfer colors -o out/a.stl)
expect_wrong_usage("does not hold what is transferred" match ball.off ball.ply --transfer texture -o out/a.off)
expect_refusal("'ball.off' has no colors" match ball.ply ball.off --transfer colors -o out/a.ply)
expect_refusal("'ball.off' has no texture coordinates" match ball.ply ball.off --transfer texture -o out/a.obj)
file(WRITE ${WORK}/labels.txt "1 2 3\n")
expect_refusal("'labels.txt' has 3 labels, but OTHER has 20 faces" match ball.ply ball.off --transfer labels.txt -o out/a.txt)
string(REPEAT "-1\n" 20 labels)
file(WRITE ${WORK}/labels.txt "${labels}")
expect_refusal("the label of face 0 is not an integer" match ball.ply ball.off --transfer labels.txt -o out/a.txt)

if(NOT MAKE_FIGURE OR NOT HAS_SPECTRA)
  message(STATUS "Matches of collections are not tested: there is no make_figure, or no Spectra")
  return()
endif()

file(REMOVE_RECURSE ${WORK}/people ${WORK}/matched ${WORK}/people.db ${WORK}/template.off)
file(MAKE_DIRECTORY ${WORK}/people)
macro(make_person file pose vertices)
  execute_process(COMMAND ${MAKE_FIGURE} --pose ${pose} --vertices ${vertices} ${WORK}/${file}
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endmacro()
set(people running sitting waving) # in the order of their paths
set(matched "")
foreach(pose IN LISTS people)
  make_person(people/${pose}.off ${pose} 2000)
  list(APPEND matched matched/${pose}.off)
endforeach()
make_person(template.off standing 2000)
set(match collection people --database people.db --descriptor shape-distribution-d2 --match template.off --matches matched)

# expect_computed(number what key...): so many of these values of the reports are not those of the call before.
macro(expect_computed expected what)
  run_tool(collection --list --json --database people.db)
  set(number 0)
  foreach(index RANGE 2)
    string(JSON value GET "${stdout}" ${index} report ${ARGN})
    if(NOT "${value}" STREQUAL "${${what}_${index}}")
      math(EXPR number "${number} + 1")
    endif()
    set(${what}_${index} "${value}")
  endforeach()
  expect_match("${number} ${what}" "^${expected} ")
endmacro()
macro(expect_computed_matches expected)
  expect_computed(${expected} matches match seconds)
endmacro()
macro(expect_computed_poses expected)
  expect_computed(${expected} poses total_seconds)
endmacro()

set(match_of_two match people/sitting.off people/running.off)
expect_exit(0 ${match_of_two} --transfer pose -o out/posture.off)
expect_same_faces(people/sitting.off out/posture.off)
expect_exit(0 compare people/running.off out/posture.off --report out/difference.json --quiet)
file(READ ${WORK}/out/difference.json report)
string(JSON difference GET "${report}" mean proper)
expect_match("${difference}" "^0.0[0-4]")
expect_exit(0 segment people/running.off -o out/labels.txt --quiet)
expect_exit(0 ${match_of_two} --transfer ${WORK}/out/labels.txt -o out/transferred.txt)
file(STRINGS ${WORK}/out/labels.txt labels)
file(STRINGS ${WORK}/out/transferred.txt transferred)
set(differences 0)
foreach(label other IN ZIP_LISTS labels transferred) # figures have the same faces
  if(NOT label STREQUAL other)
    math(EXPR differences "${differences} + 1")
  endif()
endforeach()
expect_match("${differences}" "^[0-9]?[0-9]?[0-9]$") # of 3996; beside the borders
expect_exit(0 geodesics people/running.off --source 0 -o out/distances.ply --quiet)
expect_exit(0 match people/sitting.off out/distances.ply --transfer colors -o out/colors.obj)
file(STRINGS ${WORK}/out/colors.obj colored REGEX "^v [^ ]+ [^ ]+ [^ ]+ [^ ]+ [^ ]+ [^ ]+$" LIMIT_COUNT 1)
expect_match("${colored}" "^v ")

expect_exit(0 ${match} --workers 2)
expect_match("${stdout}" "^3 shapes, 3 computed now\ndone +3\n$")
expect_computed_matches(3)
expect_computed_poses(3)
foreach(pose IN LISTS people)
  # The template has the vertices of the figures.
  expect_same_faces(template.off matched/${pose}.off)
  expect_exit(0 compare people/${pose}.off matched/${pose}.off --report out/difference.json --quiet)
  file(READ ${WORK}/out/difference.json report)
  string(JSON difference GET "${report}" mean proper)
  expect_match("${difference}" "^0.0[0-4]")
endforeach()
run_tool(collection --list --json --database people.db)
string(JSON report GET "${stdout}" 0 report match)
foreach(key IN ITEMS mean_distance mean_round_trip)
  string(JSON value GET "${report}" ${key})
  expect_match("${value}" "^0.0")
endforeach()
string(JSON is_certain GET "${report}" is_rotation_certain)
expect_match("${is_certain}" "^ON$")

expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 0 computed now\n")

# A match that is not there, or not the one that was written: only that.
file(RENAME ${WORK}/matched/sitting.off ${WORK}/before.off)
expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 1 computed now\n")
expect_computed_matches(1)
expect_computed_poses(0)
expect_same_bytes(matched/sitting.off before.off)
file(WRITE ${WORK}/matched/sitting.off "something else")
expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 1 computed now\n")
expect_computed_matches(1)

# Another descriptor: the match is kept.
expect_exit(0 collection people --database people.db --descriptor shape-dna)
expect_match("${stdout}" "^3 shapes, 3 computed now\n")
expect_computed_matches(0)
expect_computed_poses(3)

# Another template: all matches, and no pose.
make_person(template.off standing 3000)
expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 3 computed now\n")
expect_computed_matches(3)
expect_computed_poses(0)
expect_same_faces(template.off matched/waving.off)

# What could not be written is tried again.
file(REMOVE ${WORK}/matched/sitting.off)
file(MAKE_DIRECTORY ${WORK}/matched/sitting.off)
run_tool(${match})
expect_match("${exit_code}${stdout}" "^03 shapes, 1 computed now\ndone +2\nnot written +1\nnot written\t[^\n]*cannot be written: it is not a file\n$")
file(REMOVE_RECURSE ${WORK}/matched/sitting.off)
expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 1 computed now\ndone +3\n")

# What takes too long is tried again with another limit or template.
file(REMOVE ${WORK}/matched/sitting.off)
foreach(computed IN ITEMS 1 0)
  expect_exit(0 ${match} --time-limit .01)
  expect_match("${stdout}" "^3 shapes, ${computed} computed now\ndone +2\ntime limit +1\n")
endforeach()
expect_exit(0 ${match})
expect_match("${stdout}" "^3 shapes, 1 computed now\ndone +3\n")

expect_exit(0 compare ${matched} --mean out/mean.off)
expect_match("${stdout}" "\n[0-9.]+  [0-9.]+   mean of 3 pairs\n$")
expect_same_faces(template.off out/mean.off)
expect_exit(0 check out/mean.off)
expect_match("${stdout}" "^vertices +3000\n")

# A database of the version before, without matches.
if(SQLITE)
  execute_process(COMMAND ${SQLITE} ${WORK}/people.db "ALTER TABLE shape DROP COLUMN \"match\"; PRAGMA user_version = 2;"
    COMMAND_ERROR_IS_FATAL ANY)
  expect_exit(0 collection --list --database people.db)
  file(REMOVE ${WORK}/matched/running.off)
  expect_exit(0 collection people/running.off --database people.db --descriptor shape-dna --match template.off --matches matched)
  expect_match("${stdout}" "^1 shape, 1 computed now\ndone +1\n$")
  expect_exit(0 collection people/running.off --database people.db --descriptor shape-dna --match template.off --matches matched)
  expect_match("${stdout}" "^1 shape, 0 computed now\ndone +1\n$")
endif()

# Shares, into the same folder, and ranks of MPI: the same.
file(REMOVE ${WORK}/share_1.db ${WORK}/share_2.db ${WORK}/shared.db)
foreach(k IN ITEMS 1 2)
  expect_exit(0 collection people --database share_${k}.db --shard ${k}/2 --descriptor shape-dna --match template.off --matches shared)
endforeach()
expect_exit(0 collection merge share_1.db share_2.db -o shared.db)
expect_exit(0 collection people --database shared.db --descriptor shape-dna --match template.off --matches shared)
expect_match("${stdout}" "^3 shapes, 0 computed now\ndone +3\n$")
expect_same_bytes(matched/waving.off shared/waving.off)
if(MPIRUN AND HAS_MPI)
  execute_process(COMMAND ${MPIRUN} --allow-run-as-root --oversubscribe -n 3 ${TOOL} collection people --database ranks.db
    --descriptor shape-dna --match template.off --matches of_ranks --quiet
    WORKING_DIRECTORY ${WORK} TIMEOUT 120 RESULT_VARIABLE exit_code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
  expect_match("${exit_code}${stdout}" "^0$")
  foreach(pose IN LISTS people)
    expect_same_bytes(shared/${pose}.off of_ranks/${pose}.off)
  endforeach()
endif()
