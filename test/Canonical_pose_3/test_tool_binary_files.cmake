# Binary files for test_tool.cmake, a tetrahedron each; see test_tool_bad_files.cmake.

find_program(PRINTF printf)
if(NOT PRINTF)
  message(STATUS "Binary files are not tested: the program printf was not found")
  return()
endif()

# Writes the bytes printed by printf for the arguments.
function(write_bytes name)
  string(CONCAT bytes ${ARGN})
  execute_process(COMMAND ${PRINTF} "${bytes}" OUTPUT_FILE ${WORK}/${name} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Four-byte floating-point numbers, in little-endian order.
set(float_0 "\\000\\000\\000\\000")
set(float_1 "\\000\\000\\200\\077")
set(float_1.5 "\\000\\000\\300\\077")
set(float_2 "\\000\\000\\000\\100")
set(float_3 "\\000\\000\\100\\100")
set(points "0 0 0" "1 0 0" "0 1 0" "0 0 1")
set(triangles "0 2 1" "0 1 3" "1 2 3" "2 0 3")

# Converts space-separated numbers to floats.
function(floats result)
  set(bytes "")
  string(REPLACE " " ";" numbers "${ARGN}")
  foreach(number IN LISTS numbers)
    string(APPEND bytes "${float_${number}}")
  endforeach()
  set(${result} "${bytes}" PARENT_SCOPE)
endfunction()

# binary_ply(name number_of_corners triangles rest): the first triangle announces `number_of_corners`. Indices are floats.
function(binary_ply name number triangles rest)
  floats(bytes ${points})
  foreach(triangle IN LISTS triangles)
    floats(indices ${triangle})
    string(APPEND bytes "${number}${indices}")
    set(number "\\003")
  endforeach()
  write_bytes(${name} "ply\\nformat binary_little_endian 1.0\\nelement vertex 4\\nproperty float x\\nproperty float y\\n"
    "property float z\\nelement face 4\\nproperty list char float vertex_indices\\nend_header\\n" "${bytes}${rest}")
endfunction()

binary_ply(binary.ply "\\003" "${triangles}" "\\r\\n")
list(APPEND strange_inputs binary.ply)
binary_ply(fraction.ply "\\003" "0 2 1;0 1 3;1 1.5 3;2 0 3" "")
bad(fraction.ply "face 2 names vertex 1.5, which cannot be the index of a vertex")
binary_ply(minus.ply "\\375" "${triangles}" "")
bad(minus.ply "face 0: the number of its 'vertex_indices' is -3")
binary_ply(longer.ply "\\003" "${triangles}" "\\003${float_0}${float_1}${float_2}")
bad(longer.ply "the file goes on for 13 bytes after face 3, the last one announced")

# binary_stl(name number rest): announces `number` faces, and has four.
function(binary_stl name number rest)
  string(REPEAT "x" 80 bytes)
  string(APPEND bytes "\\00${number}\\000\\000\\000")
  foreach(triangle IN LISTS triangles)
    string(REPLACE " " ";" corners "${triangle}")
    string(APPEND bytes "${float_0}${float_0}${float_0}")
    foreach(corner IN LISTS corners)
      list(GET points ${corner} point)
      floats(coordinates ${point})
      string(APPEND bytes "${coordinates}")
    endforeach()
    string(APPEND bytes "\\000\\000")
  endforeach()
  write_bytes(${name} "${bytes}${rest}")
endfunction()

binary_stl(binary.stl 4 "\\n")
list(APPEND strange_inputs binary.stl)
binary_stl(fewer.stl 3 "")
bad(fewer.stl "the file goes on for 50 bytes after the 3 faces announced")
binary_stl(more.stl 5 "")
bad(more.stl "the file is truncated: 284 bytes, but 5 faces of binary STL need 334")
