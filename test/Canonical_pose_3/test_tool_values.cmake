# Values that the tool writes with surfaces and tetrahedral meshes, see test_tool.cmake: properties of PLY, arrays of
# VTK.

expect_exit(0 pose ball.off --rounds 0 -o out/pose.ply)
file(READ ${WORK}/out/pose.ply ply)
expect_match("${ply}" "property double strain\nelement face 20\n")
expect_match("${ply}" "end_header\n[^ \n]+ [^ \n]+ [^ \n]+ 0\\.[0-9]+\n")
expect_exit(0 compare out/pose.ply ball.off) # values are skipped

expect_exit(0 geodesics two_balls.off --source 0 -o out/distances.ply)
file(READ ${WORK}/out/distances.ply ply)
expect_match("${ply}" "property uchar red\n.*property double distance\nelement face")
expect_match("${ply}" "end_header\n0 1 1.7 68 1 84 0\n")
expect_match("${ply}" " 128 128 128 -1\n") # no path
expect_exit(0 geodesics ball.off --source 0 --source 3 -o out/distances.ply)
file(READ ${WORK}/out/distances.ply ply)
expect_match("${ply}" "property double distance_0\nproperty double distance_1\nelement face")

expect_exit(0 pose ball.mesh -o out/pose.vtu)
expect_exit(0 pose ball.mesh -o out/pose.mesh)
file(READ ${WORK}/out/pose.vtu vtu)
expect_match("${vtu}" "<Piece NumberOfPoints=\"13\" NumberOfCells=\"20\">")
expect_match("${vtu}" "Name=\"label\" NumberOfComponents=\"1\" format=\"ascii\">\n5\n5\n")
expect_match("${vtu}" "Name=\"strain\" NumberOfComponents=\"1\" format=\"ascii\">\n0\\.[0-9]+\n")
file(STRINGS ${WORK}/out/pose.mesh lines)
list(GET lines 4 line)
string(REGEX REPLACE " 5$" "" line "${line}")
string(FIND "${vtu}" "\n${line}\n" position) # the same numbers
if(position EQUAL -1)
  fail("out/pose.vtu should contain the point ${line}.")
endif()

expect_wrong_usage("a tetrahedral mesh (.mesh, .vtu)" pose ball.off -o out/a.vtu)
expect_refusal("written, but not read" check out/pose.vtu)
foreach(format IN ITEMS off obj stl mesh vtu json csv)
  expect_wrong_usage("'out/a.${format}' is neither a .txt nor a .ply nor a .glb file" geodesics ball.off --source 0 -o out/a.${format})
endforeach()

# The target of unfolding, on surfaces and tetrahedral meshes; contacts, of which there are none here.
file(MAKE_DIRECTORY ${WORK}/out)
foreach(input IN ITEMS ball.off ball.mesh)
  get_filename_component(extension ${input} EXT)
  expect_exit(0 pose ${input} --target-mode unfold -o out/unfolded${extension} --target out/target.off --report out/report.json)
  file(READ ${WORK}/out/report.json report)
  expect_match("${report}" "\"kernel\": \"unfolding\"")
  expect_match("${report}" "\"eigenvalues\": \\[\\]")
endforeach()
expect_exit(0 pose ball.off --rounds 0 -o out/kept.off)
expect_exit(0 pose ball.off --rounds 0 --contacts cut -o out/cut.off)
expect_same_bytes(out/kept.off out/cut.off)
expect_exit(2 pose ball.off --target-mode fold -o out/a.off)
expect_exit(2 pose ball.off --target-mode unfold --given-target ball.off -o out/a.off)
expect_exit(2 pose ball.off --contacts separate -o out/a.off)
expect_refusal("contacts can only be cut" pose ball.off --contacts cut --body mesh -o out/a.off)
expect_refusal("contacts of a tetrahedral complex" pose ball.mesh --contacts cut -o out/a.mesh)

# Matches: INPUT in the shape of OTHER, which is that of INPUT here, and a line per vertex.
if(HAS_SPECTRA)
  expect_exit(0 match ball.off ball.off -o out/match.txt --pose ball.off --other-pose ball.off --report out/match.json)
  file(STRINGS ${WORK}/out/match.txt lines)
  list(LENGTH lines number)
  if(NOT number EQUAL 12)
    fail("There should be a line for each of 12 vertices.")
  endif()
  list(GET lines 0 line)
  expect_match("${line}" "^[0-9]+ [0-9]+ [0-9]+ [0-9]+ [0-9.e-]+ [0-9.e-]+ [0-9.e-]+$")
  expect_exit(0 match ball.off ball.off -o out/match.off --pose ball.off --other-pose ball.off --landmark 0,0 --quiet)
  expect_exit(0 check out/match.off)
  expect_refusal("the landmark 0, 12 is out of range" match ball.off ball.off -o out/a.txt --pose ball.off
    --other-pose ball.off --landmark 0,12)
  expect_refusal("the landmark 24, 0 is out of range" match two_balls.off ball.off -o out/a.txt --components refuse
    --landmark 24,0) # at once: the pose would be refused
  expect_refusal("but the pose has" match ball.off ball.off -o out/a.txt --pose two_balls.off)
endif()
expect_wrong_usage("one of the extensions .txt, .off, .obj, .ply, .stl, .glb" match ball.off ball.off -o out/a.vtu)
file(WRITE ${WORK}/one_quad.off "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
expect_refusal("STL holds triangles only" match one_quad.off ball.off -o out/a.stl)
expect_wrong_usage("is not two vertex numbers" match ball.off ball.off -o out/a.txt --landmark 0)
expect_refusal("a surface is needed" match ball.mesh ball.off -o out/a.txt)
