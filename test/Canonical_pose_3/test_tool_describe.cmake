# The command describe, see test_tool.cmake: values and what it refuses.

run_tool(describe ball.off --descriptor shape-distribution-d2 --pose ball.off -o out/ball.json)
file(READ ${WORK}/out/ball.json described)
string(JSON version GET "${described}" shape-distribution-d2 version)
string(JSON number LENGTH "${described}" shape-distribution-d2 values)
string(JSON descriptors LENGTH "${described}")
if(NOT version EQUAL 1 OR NOT number EQUAL 64 OR NOT descriptors EQUAL 1)
  fail("${descriptors} descriptors; D2 of version ${version} has ${number} values")
endif()
run_tool(describe ball.off -o out/all.json) # all, with its own pose
file(READ ${WORK}/out/all.json described)
string(JSON number LENGTH "${described}" shape-distribution-d2 values)
if(NOT number EQUAL 64)
  fail("D2 has ${number} values")
endif()
file(REMOVE ${WORK}/out/ball.json ${WORK}/out/all.json)

expect_exit(2 describe ball.off)
expect_wrong_usage("there is no descriptor 'guess' in this build, which has" describe ball.off -o out/a.json --descriptor guess)
expect_refusal("a surface is needed" describe ball.mesh -o out/a.json)
expect_refusal("No such file" describe missing.off -o out/a.json)
expect_refusal("the pose has 3 vertices" describe ball.off -o out/a.json --pose triangle.off)
expect_refusal("no such directory" describe ball.off -o out/nowhere/a.json)
