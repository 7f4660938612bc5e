# How canonical-pose moves its outputs to their destinations, see test_tool.cmake: all or none of them, through
# symbolic links, but not through files at its temporary names.

string(REPEAT a 246 long) # a name can have 255 bytes
expect_exit(0 geodesics ball.off --source 0 -o out/${long}.txt)
expect_refusal("File name too long" geodesics ball.off --source 0 -o out/${long}${long}.txt)

find_program(SH sh)
if(NOT SH OR NOT CMAKE_HOST_SYSTEM_NAME STREQUAL "Linux")
  message(STATUS "Links, and errors while writing, are not tested: this is not Linux, or there is no sh")
  return()
endif()

# Runs a shell script, in which $TOOL is the tool, like run_tool().
macro(run_sh text)
  set(command "${text}")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env "TOOL=${TOOL}" ${SH} -c "${text}" WORKING_DIRECTORY ${WORK} TIMEOUT 120
    RESULT_VARIABLE exit_code OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr)
endmacro()

function(expect_content name content)
  file(READ ${WORK}/${name} found)
  if(NOT found STREQUAL "${content}" OR IS_SYMLINK ${WORK}/${name})
    fail("${name} should be a file that holds '${content}', not '${found}'.")
  endif()
endfunction()

function(expect_files pattern)
  file(GLOB found RELATIVE ${WORK} ${WORK}/${pattern})
  if(NOT found STREQUAL "${ARGN}")
    fail("${pattern} should be ${ARGN}, not ${found}.")
  endif()
endfunction()

foreach(words IN ITEMS "geodesics ball.off --source 0 -o ''" "check ball.off --report ''" "pose ball.off -o ''"
    "pose ball.off -o out/a.off --target ''" "pose ball.off -o out/a.off --report ''"
    "pose ball.off -o out/a.off --matching-weights ''" "pose ball.off -o out/a.off --stiffness ''")
  run_sh("exec \"$TOOL\" ${words}")
  expect_match("${exit_code}<${stderr}>" "^2<[^\n]*the path is empty\n")
endforeach()

# ---- materials beside OBJ ----------------------------------------------------------------------------------------

file(WRITE ${WORK}/red.mtl "newmtl red\nKd 1 0 0\n")
file(READ ${WORK}/ball.obj text)
file(WRITE ${WORK}/red.obj "mtllib red.mtl\nusemtl red\n${text}")
file(WRITE ${WORK}/out/target.mtl "something else")
set(red pose red.obj --rounds 0 --landmarks 12 --detail-length 0.3 -o out/red.off)
expect_exit(0 ${red} --target out/target.obj)
expect_content(out/target.mtl "newmtl red\nKd 1 0 0\nd 1\n")
expect_exit(0 ${red} --target red_target.obj.gz)
expect_files(red*.mtl red.mtl)
file(REMOVE_RECURSE ${WORK}/out/red.off ${WORK}/red_target.obj.gz)
expect_refusal("'out/t.mtl' cannot be written: another output has the same name" ${red} --target out/t.obj --report out/t.mtl)
file(MAKE_DIRECTORY ${WORK}/red_target.mtl)
expect_refusal("red_target.mtl' cannot be written: it is not a file" ${red} --target red_target.obj)
expect_files(red_target* red_target.mtl)
file(REMOVE_RECURSE ${WORK}/red_target.mtl)
file(RENAME ${WORK}/red.mtl ${WORK}/red_target.mtl)
file(WRITE ${WORK}/red.obj "mtllib red_target.mtl\nusemtl red\ng all\n${text}")
string(REGEX REPLACE "(v [^\n]*)\n" "\\1 1 0 0\n" colored "${text}")
file(WRITE ${WORK}/colored.obj "${colored}")
expect_exit(0 ${red} --target red_target.obj) # the materials of the input are not replaced
expect_content(red_target.mtl "newmtl red\nKd 1 0 0\n")
expect_content(red_target_0.mtl "newmtl red\nKd 1 0 0\nd 1\n")
expect_refusal("'red_target.mtl' cannot be written: the input 'red.obj' names it" ${red} --report red_target.mtl)
expect_refusal("'red_target.mtl' cannot be written: the input 'red.obj' names it" pose red.obj -o red.obj --report red_target.mtl)
expect_refusal("'red_target.mtl' cannot be written: the input 'red.obj' names it" segment red.obj --method sweep -o out/a.txt --report red_target.mtl)
file(WRITE ${WORK}/other.mtl "newmtl red\nKd 0 1 0\n")
file(WRITE ${WORK}/other.obj "mtllib other.mtl\nusemtl red\n${text}")
expect_exit(0 pose other.obj --given-target red.obj --rounds 0 --target red_target.obj -o out/a.off)
expect_content(red_target.mtl "newmtl red\nKd 1 0 0\n")
expect_content(red_target_0.mtl "newmtl red\nKd 0 1 0\nd 1\n")
run_sh("\"$TOOL\" pose - -o out/red.obj --rounds 0 --landmarks 12 --detail-length 0.3 < red.obj")
expect_match("${exit_code}${stdout}" "^0.*\nwarning: the pose names 'red_target.mtl', which is not beside it\n$")
foreach(parts IN ITEMS 3 2)
  expect_exit(0 segment red.obj --method sweep --parts ${parts} -o out/red_parts/)
endforeach()
expect_match("${stdout}" "\nwarning: the parts lack groups, comments of the input\n$")
expect_exit(0 ${red} --target out/red.ply)
expect_match("${stdout}" "the pose in 'out/red.off' lacks materials, groups, comments of the input\nwarning: the target in 'out/red.ply' lacks materials, groups, comments of")
expect_exit(0 geodesics colored.obj --source 0 -o out/red.ply)
expect_match("${stdout}" "^warning: the distances lack colors of the input\n$")
expect_exit(0 geodesics colored.obj --source 0 -o out/red.ply --quiet)
expect_match("${stdout}" "^$")
expect_files(out/red_parts/* out/red_parts/part_0.mtl out/red_parts/part_0.obj out/red_parts/part_1.mtl out/red_parts/part_1.obj)
file(REMOVE_RECURSE ${WORK}/out/red_parts ${WORK}/out/red.off ${WORK}/out/red.ply)

# ---- standard streams, and compressed files --------------------------------------------------------------------

set(quick "--rounds 0 --landmarks 12 --detail-length 0.3 --quiet")
run_sh("\"$TOOL\" pose ball.off -o expected.off ${quick} && \"$TOOL\" pose ball.off -o expected.ply ${quick}")
foreach(words IN ITEMS "- -o - ${quick} < ball.off > out/a.off" "ball.off -o - --rounds 0 --landmarks 12 --detail-length 0.3 2> out/messages > out/a.off"
    "- -o out/a.off ${quick} < ball.off" "- --format off -o - ${quick} < ball.off > out/a.off")
  run_sh("\"$TOOL\" pose ${words}")
  expect_match("${exit_code}<${stdout}${stderr}>" "^0<>$")
  expect_same_bytes(out/a.off expected.off)
endforeach()
file(READ ${WORK}/out/messages messages)
expect_match("${messages}" "^converged")
run_sh("\"$TOOL\" pose - --format ply -o - ${quick} < ball.off | tee out/a.ply | \"$TOOL\" check -")
expect_match("${exit_code}${stdout}" "^0vertices +12\n")
expect_same_bytes(out/a.ply expected.ply)
foreach(words IN ITEMS "geodesics - --source 0 -o -" "segment - -o - --method sweep" "describe - -o - --descriptor shape-distribution-d2"
    "pose - -o out/a.off --report - --rounds 0" "check - --report - --quiet")
  run_sh("\"$TOOL\" ${words} < ball.off 2> out/messages")
  expect_match("${exit_code}<${stdout}>" "^0<[0-9{].*")
endforeach()
expect_wrong_usage("the output is a file" pose ball.off -o out/a.off --format ply)
expect_wrong_usage("the extension of '-' is not one of" pose ball.off -o out/a.off --target -)
expect_wrong_usage("two outputs cannot both be the standard output" pose ball.off -o - --report -)
run_sh("\"$TOOL\" check ball.off --report - 2> out/messages")
string(JSON vertices GET "${stdout}" input vertices)
expect_match("${vertices}" "^12$")
run_sh("echo hello | \"$TOOL\" check -")
expect_match("${exit_code}${stderr}" "^1canonical-pose: [^\n]*the content of standard input is not one of .off, [^\n]*\n$")
run_sh("cat ball.off | \"$TOOL\" check /dev/stdin && mkfifo pipe && (cat ball.off > pipe & \"$TOOL\" check pipe)")
expect_match("${exit_code}${stdout}" "^0vertices +12\n.*\nvertices +12\n")
run_sh("\"$TOOL\" check - < /dev/null")
expect_match("${exit_code}${stderr}" "^1canonical-pose: standard input: the file is empty\n$")
execute_process(COMMAND test -c /dev/full RESULT_VARIABLE lacks_full_device)
if(NOT lacks_full_device)
  run_sh("\"$TOOL\" pose ball.off -o - > /dev/full")
  expect_match("${exit_code}${stderr}" "the standard output cannot be written\n$")
endif()

run_sh("command -v gzip && \"$TOOL\" pose ball.off -o out/a.off.gz ${quick}")
if(NOT stderr MATCHES "without zlib" AND exit_code EQUAL 0)
  run_sh("gzip -dc out/a.off.gz | cmp - expected.off && gzip -c ball.off > out/b.off.gz && \"$TOOL\" pose out/b.off.gz -o out/a.off ${quick}")
  expect_match("${exit_code}<${stdout}${stderr}>" "^0<>$")
  expect_same_bytes(out/a.off expected.off)
endif()
file(REMOVE ${WORK}/out/a.off ${WORK}/out/a.ply ${WORK}/out/a.off.gz ${WORK}/out/b.off.gz ${WORK}/expected.off ${WORK}/expected.ply
  ${WORK}/out/messages)

# ---- no output replaces an input, but the pose ---------------------------------------------------------------

file(MAKE_DIRECTORY ${WORK}/kept)
foreach(name IN ITEMS ball.off numbers.txt target.off)
  file(COPY_FILE ${WORK}/ball.off ${WORK}/kept/${name})
endforeach()
file(COPY_FILE ${WORK}/ball.ply ${WORK}/kept/ball.ply)
file(CREATE_LINK ball.off ${WORK}/kept/link.off SYMBOLIC)
file(READ ${WORK}/kept/ball.off ball)
foreach(words IN ITEMS "pose kept/ball.off -o out/a.off --report kept/ball.off" "pose kept/ball.off -o out/a.off --report kept/link.off"
    "pose kept/ball.off -o out/a.off --target kept/ball.off" "pose ball.off -o kept/target.off --given-target kept/target.off"
    "pose ball.off -o out/a.off --stiffness kept/numbers.txt --report kept/numbers.txt" "check kept/ball.off --report kept/ball.off"
    "geodesics kept/ball.ply --source 0 -o kept/ball.ply" "segment ball.off -o out/a.txt --pose kept/ball.off --report kept/ball.off"
    "evaluate --database ball.db --classes kept/numbers.txt --csv kept/numbers.txt"
    "collection kept/ball.off --database out/a.db --poses kept --descriptor shape-distribution-d2")
  run_sh("exec \"$TOOL\" ${words}")
  expect_match("${exit_code}<${stderr}>" "^1<[^\n]*(it is an input|would replace it)\n")
  expect_content(kept/ball.off "${ball}")
  expect_content(kept/target.off "${ball}")
endforeach()
expect_exit(0 pose kept/ball.off -o kept/ball.off --rounds 0)
expect_wrong_usage("'a.txt' is not a .json file" describe ball.off -o a.txt)
expect_wrong_usage("'a.txt' is not a .html file" page ball.glb -o a.txt)
expect_wrong_usage("'a.jpg' is not a .png file" evaluate --database a.db --classes a.txt --plot a.jpg)
expect_wrong_usage(".off, .obj, .ply, .stl, .mesh, .glb, .vtu\n" pose ball.off -o a.xyz)

# ---- symbolic links are followed, even if their target does not exist yet ----------------------------------

run_tool(geodesics ball.off --source 0 -o distances.txt)
file(READ ${WORK}/distances.txt distances)
file(MAKE_DIRECTORY ${WORK}/links ${WORK}/deep/far)
file(CREATE_LINK ../deep/far ${WORK}/links/folder SYMBOLIC)
file(CREATE_LINK ../deep/new.txt ${WORK}/links/dangling.txt SYMBOLIC)
file(CREATE_LINK ${WORK}/links/folder/second.txt ${WORK}/links/first.txt SYMBOLIC)
file(CREATE_LINK ../chained.txt ${WORK}/deep/far/second.txt SYMBOLIC) # which is not links/chained.txt
file(CREATE_LINK pool.txt ${WORK}/links/loop.txt SYMBOLIC)
file(CREATE_LINK loop.txt ${WORK}/links/pool.txt SYMBOLIC)
file(CREATE_LINK loop ${WORK}/links/loop SYMBOLIC)
file(CREATE_LINK nowhere/a.txt ${WORK}/links/nowhere.txt SYMBOLIC)
file(CREATE_LINK ../deep/same.off ${WORK}/links/same.off SYMBOLIC)
expect_wrong_usage("another output has the same name"
  pose ball.off -o links/same.off --report deep/same.off)
expect_refusal("Too many levels of symbolic links" geodesics ball.off --source 0 -o links/loop.txt)
expect_refusal("Too many levels of symbolic links" geodesics ball.off --source 0 -o links/loop/a.txt)
expect_refusal("no such directory" geodesics ball.off --source 0 -o links/nowhere.txt)
set(links dangling.txt first.txt folder/plain.txt)
set(places new.txt chained.txt far/plain.txt)
foreach(link place IN ZIP_LISTS links places)
  foreach(time IN ITEMS first second) # when there is no file, and when there is one
    expect_exit(0 geodesics ball.off --source 0 -o links/${link})
    expect_content(deep/${place} "${distances}")
    if(NOT link MATCHES folder AND NOT IS_SYMLINK ${WORK}/links/${link})
      fail("${link} should still be a symbolic link.")
    endif()
  endforeach()
endforeach()
expect_files(deep/*.txt deep/chained.txt deep/new.txt)
expect_files(deep/far/* deep/far/plain.txt deep/far/second.txt)

# ---- nothing is written through existing files at the temporary names --------------------------------------

file(WRITE ${WORK}/victim.txt "precious")
foreach(plant IN ITEMS "ln -s ../victim.txt" "ln -s nowhere.txt" "ln ../victim.txt" mkdir)
  file(REMOVE_RECURSE ${WORK}/out)
  file(MAKE_DIRECTORY ${WORK}/out)
  run_sh("cd out && ${plant} a.txt.part-$$ && exec \"$TOOL\" geodesics ../ball.off --source 0 -o a.txt")
  expect_match("${exit_code}<${stderr}>" "^0<>$")
  expect_content(out/a.txt "${distances}")
  expect_content(victim.txt "precious")
  file(GLOB files ${WORK}/out/*)
  list(LENGTH files length)
  expect_match(${length} "^2$") # the other one was planted
endforeach()

# ---- all or nothing --------------------------------------------------------------------------------------

file(REMOVE_RECURSE ${WORK}/out)
file(MAKE_DIRECTORY ${WORK}/out)
file(WRITE ${WORK}/out/a.off "before")
run_sh("trap '' XFSZ; ulimit -f 3; exec \"$TOOL\" pose ball.off -o out/a.off --report out/c.json")
expect_match("${exit_code}<${stderr}>" "^1<canonical-pose: [^\n]*'out/c.json' cannot be written: File too large\n>$")
expect_content(out/a.off "before")
expect_files(out/* out/a.off)

# A folder with the name of the last output is created while the input is read, that is, after the outputs were checked.
foreach(before IN ITEMS before "")
  file(REMOVE_RECURSE ${WORK}/out ${WORK}/pipe.off)
  file(MAKE_DIRECTORY ${WORK}/out)
  if(before)
    file(WRITE ${WORK}/out/a.off "${before}")
  endif()
  run_sh("mkfifo pipe.off; \"$TOOL\" pose pipe.off -o out/a.off --target out/b.off --report out/c.json --quiet & tool=$!
    exec 3> pipe.off; mkdir out/c.json; cat ball.off >&3; exec 3>&-; wait $tool")
  expect_match("${exit_code}<${stderr}>" "^1<canonical-pose: [^\n]*'out/c.json' cannot be written: Is a directory\n>$")
  if(before)
    expect_content(out/a.off "${before}")
    expect_files(out/* out/a.off out/c.json)
  else()
    expect_files(out/* out/c.json)
  endif()
endforeach()

# A signal removes the folder of parts.
file(REMOVE_RECURSE ${WORK}/out ${WORK}/pipe.off)
file(MAKE_DIRECTORY ${WORK}/out)
run_sh("mkfifo pipe.off; \"$TOOL\" segment pipe.off -o out/parts/ & tool=$!; exec 3> pipe.off; kill -TERM $tool; wait $tool")
expect_match("${exit_code}" "^143$")
expect_files(out/* "")

# A signal, at ten moments: the outputs are all there, or none, and nothing else is.
find_program(TIMEOUT timeout)
mark_as_advanced(TIMEOUT)
if(TIMEOUT)
  set(signals INT 130 TERM 143 HUP 129)
  foreach(moment RANGE 1 10)
    math(EXPR i "2 * (${moment} % 3)")
    math(EXPR j "${i} + 1")
    list(GET signals ${i} signal)
    list(GET signals ${j} code)
    math(EXPR hundredths "4 * ${moment}")
    if(hundredths LESS 10)
      set(hundredths 0${hundredths})
    endif()
    foreach(words IN ITEMS "pose ball.off -o out/a.off --report out/b.json --quiet" "segment ball.off -o out/a.txt --report out/b.json --quiet")
      file(REMOVE_RECURSE ${WORK}/out)
      file(MAKE_DIRECTORY ${WORK}/out)
      run_sh("${TIMEOUT} --preserve-status -s ${signal} 0.${hundredths} \"$TOOL\" ${words}")
      if(exit_code STREQUAL 0)
        file(GLOB files RELATIVE ${WORK}/out ${WORK}/out/*)
        expect_match("${files}" "^a.(off|txt);b.json$")
      else()
        expect_match("${exit_code}" "^${code}$")
        expect_files(out/* "")
      endif()
    endforeach()
  endforeach()
endif()

# ---- what is printed ---------------------------------------------------------------------------------------

if(NOT lacks_full_device)
  run_sh("exec \"$TOOL\" check ball.off > /dev/full")
  expect_match("${exit_code}<${stderr}>" "^1<canonical-pose: 'ball.off': the standard output cannot be written\n>$")
endif()
