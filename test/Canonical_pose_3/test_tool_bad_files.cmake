# Files that test_tool.cmake expects to be refused, in addition to those of test_tool_inputs.cmake, whose functions
# write them: they announce missing content, do not announce existing content, or contain non-integers where integers
# are required. Those of `strange_inputs` are unusual, but valid.

set(strange_inputs "")

# ---- PLY: the header, then lists and numbers -------------------------------------------------------------

# bad_ply(name message elements data): the properties `xyz` and `corners` are the expected ones.
macro(bad_ply name message elements data)
  file(WRITE ${WORK}/${name}.ply "ply\nformat ascii 1.0\n${elements}end_header\n${data}")
  bad(${name}.ply "${message}")
endmacro()

join(vertex_lines "" ${vertices})
join(face_lines "3 " ${faces})
set(data "${vertex_lines}${face_lines}")
set(xyz "property double x\nproperty double y\nproperty double z\n")
set(corners "property list uchar int vertex_indices\n")
set(all_vertices "element vertex 12\n${xyz}")
set(all_faces "element face 20\n${corners}")

string(REPLACE "double y" "double x" doubled "${xyz}")
bad_ply(doubled "the header announces x of a vertex 2 times" "element vertex 12\n${doubled}${all_faces}" "${data}")
string(REPLACE "double z" "double w" missing "${xyz}")
bad_ply(missing "the header does not announce z of a vertex" "element vertex 12\n${missing}${all_faces}" "${data}")
string(REPLACE "double y" "list uchar double y" list "${xyz}")
bad_ply(list "the header announces y of a vertex as a list" "element vertex 12\n${list}${all_faces}" "${data}")
bad_ply(vertices "line 7: there is a second element 'vertex'"
  "element vertex 1\n${xyz}element vertex 11\n${xyz}${all_faces}" "${data}")
bad_ply(faces "line 9: there is a second element 'face'"
  "${all_vertices}element face 1\n${corners}element face 19\n${corners}" "${data}")
join(doubled "3 0 0 0 3 " ${faces})
bad_ply(lists "the header announces 2 lists of the vertices of a face"
  "${all_vertices}${all_faces}property list uchar int vertex_index\n" "${vertex_lines}${doubled}")
bad_ply(corners "the header does not announce the list vertex_indices of a face"
  "${all_vertices}element face 20\nproperty list uchar int indices\n" "${data}")
bad_ply(minus_faces "the number of elements 'face': '-20' is negative (line 7)"
  "${all_vertices}element face -20\n${corners}" "${data}")
bad_ply(minus_edges "the number of elements 'edge': '-1' is negative (line 9)"
  "${all_vertices}${all_faces}element edge -1\nproperty int vertex1\n" "${data}")
bad_ply(keyword "line 7: the keyword 'elment' is unknown" "${all_vertices}elment face 20\n${corners}" "${data}")
bad_ply(formats "line 3: there is a second format" "format ascii 1.0\n${all_vertices}${all_faces}" "${data}")
file(WRITE ${WORK}/format.ply "ply\n${all_vertices}${all_faces}end_header\n${data}")
bad(format.ply "the header announces no format")
string(REPLACE "face 20" "face 19" fewer "${all_faces}")
bad_ply(fewer "the file goes on after face 18, the last one announced (line 41)" "${all_vertices}${fewer}" "${data}")

foreach(number IN ITEMS -1 2.5 nan inf)
  set(lists "")
  foreach(vertex IN LISTS vertices)
    string(APPEND lists "${vertex} 0\n")
  endforeach()
  string(REPLACE "1.1 1.8 0 0\n" "1.1 1.8 0 ${number} 7 7 7\n" lists "${lists}")
  bad_ply(number_${number} "vertex 4: the number of its 'weights' is ${number}"
    "${all_vertices}property list float float weights\n${all_faces}" "${lists}${face_lines}")
endforeach()
string(REPLACE "3 0 5 9\n" "-3 0 5 9\n" bad_lines "${face_lines}")
bad_ply(minus_corners "face 3: the number of its 'vertex_indices' is -3" "${all_vertices}${all_faces}"
  "${vertex_lines}${bad_lines}")
foreach(index IN ITEMS 5.5 nan 1e+300)
  string(REPLACE "3 0 5 9\n" "3 0 ${index} 9\n" bad_lines "${face_lines}")
  bad_ply(index_${index} "face 3 names vertex ${index}, which cannot be the index of a vertex"
    "${all_vertices}${all_faces}" "${vertex_lines}${bad_lines}")
endforeach()

# ---- OFF, OBJ, MEDIT -------------------------------------------------------------------------------------

# bad_edit(name.format message from to): the ball with something replaced.
macro(bad_edit name message from to)
  string(REGEX REPLACE ".*\\." "" format ${name})
  file(READ ${WORK}/ball.${format} text)
  string(REPLACE "${from}" "${to}" text "${text}")
  file(WRITE ${WORK}/${name} "${text}")
  bad(${name} "${message}")
endmacro()

bad_edit(fewer.off "the file goes on after face 18, the last one announced (line 34)" "12 20 0" "12 19 0")
bad_edit(minus.off "the number of faces: '-20' is negative (line 2)" "12 20 0" "12 -20 0")
bad_edit(huge.off "face 3: '99999999999999999999' is out of range" "3 0 5 9" "3 0 99999999999999999999 9")
bad_edit(fraction.off "face 3: '5.5' is not an integer" "3 0 5 9" "3 0 5.5 9")
bad_edit(before.obj "face 3 names vertex -13, but there are 12 before it" "f 1// 6// 10//" "f 1 -13 10")
bad_edit(huge.obj "face 3: '-9999999999999999999' is out of range" "f 1// 6// 10//" "f 1 -9999999999999999999 10")

bad_edit(texture.obj "face 3 names texture coordinate 2 (counted from 1), but there are 1 (line 17)" "f 1// 6// 10//" "f 1/1 6/2 10/1\nvt 0 0")

bad_edit(minus_vertices.mesh "the number of vertices: '-3' is negative (line 4)" "Vertices\n13" "Vertices\n-3")
bad_edit(minus_cells.mesh "the number of cells: '-20' is negative (line 19)" "Tetrahedra\n20" "Tetrahedra\n-20")
bad_edit(fewer.mesh "the file goes on after cell 18, the last one announced (line 39)" "Tetrahedra\n20" "Tetrahedra\n19")
bad_edit(label.mesh "cell 3: '99999999999999999999' is out of range" "1 6 10 13 7" "1 6 10 13 99999999999999999999")
bad_edit(second.mesh "line 40: there is a second section Tetrahedra" "End" "Tetrahedra\n1\n1 2 3 4 0\nEnd")
bad_edit(vertices.mesh "line 40: there is a second section Vertices" "End" "Vertices\n1\n0 0 9 0\nEnd")
bad_edit(unknown.mesh "line 40: the keyword 'Tetraedra' is unknown" "End" "Tetraedra\n1\n1 2 3 4 0\nEnd")
bad_edit(prism.mesh "line 41: there are cells that are no tetrahedra" "End" "Prisms\n1\n1 2 3 4 5 6 0\nEnd")
bad_edit(end.mesh "the file goes on after the keyword End (line 41)" "End" "End\nCorners\n0")
file(READ ${WORK}/ball.mesh text)
string(REPLACE "End" "Hexahedra 0\nCorners\n1\n1\nNormals 1\nnan 0 -inf\nGeometry\n\"a ball.mesh\"\n" text "${text}")
file(WRITE ${WORK}/sections.mesh "${text}")
list(APPEND strange_inputs sections.mesh)

# A triangle, and a polygon of 256 corners, which is also valid, but cannot be written as PLY.
set(corner_lines "0 0 0\n")
set(polygon 256)
foreach(corner RANGE 1 256)
  math(EXPR y "${corner} * ${corner}")
  string(APPEND corner_lines "${corner} ${y} 0\n")
  string(APPEND polygon " ${corner}")
endforeach()
file(WRITE ${WORK}/disk.off "OFF\n257 2 0\n${corner_lines}3 0 1 2\n${polygon}\n")

# ---- STL -------------------------------------------------------------------------------------------------

bad_edit(open.stl "face 19 is not closed by the keyword endfacet" "endfacet\nendsolid" "endsolid")
bad_edit(keyword.stl "face 0: the keyword 'vertx' is unknown (line 5)" "  vertex 0 1 1.7\n  vertex 0 -1 1.7\n  vertex 1.9 0 1\n"
  "  vertex 0 1 1.7\n  vertx 0 -1 1.7\n  vertex 0 -1 1.7\n  vertex 1.9 0 1\n")

include(${CMAKE_CURRENT_LIST_DIR}/test_tool_binary_files.cmake)
