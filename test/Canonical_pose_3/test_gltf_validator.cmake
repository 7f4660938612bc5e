# Khronos' validator finds neither errors nor warnings in the glTF files of the tool.
# Called with -DTOOL=path -DMAKE_FIGURE=path -DNPM=path -DNODE=path -DWORK=directory; WORK is emptied first.

cmake_minimum_required(VERSION 3.19...3.31)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/package.json "{\"private\": true}")
execute_process(COMMAND ${NPM} install --no-audit --no-fund gltf-validator@2.0.0-dev.3.10 WORKING_DIRECTORY ${WORK}
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET TIMEOUT 120)
if(result)
  message("gltf-validator cannot be installed")
  return()
endif()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/validate_gltf.js DESTINATION ${WORK})
include(${CMAKE_CURRENT_LIST_DIR}/test_tool_inputs.cmake)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

foreach(input IN LISTS dirty_inputs ITEMS ball.off ball.mesh)
  string(REPLACE "." "_" name ${input})
  set(pose ${name}.glb)
  if(input STREQUAL ball.mesh)
    set(pose ${name}.vtu)
  endif()
  run(${TOOL} pose ${input} --components each --rounds 0 -o ${pose} --scene ${name}_scene.glb)
endforeach()
run(${TOOL} segment ball.off --parts 4 --method sweep -o parts.glb)
run(${TOOL} geodesics two_balls.off --source 0 --source 23 -o distances.glb)
set(quick --rounds 0 --landmarks 12 --detail-length 0.2) # how good the pose is does not matter
run(${MAKE_FIGURE} --vertices 70000 figure.off) # indices of four bytes
run(${TOOL} pose figure.off ${quick} -o figure.glb --scene figure_scene.glb)
run(${MAKE_FIGURE} --vertices 260000 large.off) # quantized
run(${TOOL} pose large.off ${quick} -o large.glb --scene large_scene.glb)
# Skins; that of glTF is replaced.
run(${MAKE_FIGURE} --vertices 3000 --pose running running.off)
run(${TOOL} pose running.off --stance t -o stance.glb --scene stance_scene.glb)
run(${TOOL} pose stance.glb --stance a -o stance_of_glb.glb --scene stance_of_glb_scene.glb)
run(${TOOL} pose large.off --stance t --rounds 0 --landmarks 12 -o large_stance.glb --scene large_stance_scene.glb)
# Two materials, a texture of one pixel with a seam, and colors.
run(${NODE} -e "require('fs').writeFileSync('a.png', Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==', 'base64'))")
file(WRITE ${WORK}/a.mtl "newmtl a\nmap_Kd a.png\nnewmtl b\nKd 1 0 0\nd .5\n")
file(WRITE ${WORK}/textured.obj "mtllib a.mtl\nv 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 0 2 0 0 0 1\nv 0 0 2 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
  "usemtl a\nf 1/1 3/2 2/3\nf 1/3 2/2 4/1\nusemtl b\nf 2/1 3/2 4/3\nf 3/3 1/2 4/2\n")
run(${TOOL} pose textured.obj -o textured.glb --scene textured_scene.glb)
run(${TOOL} segment textured.obj --parts 1 --method sweep -o textured_parts.glb)
run(${TOOL} geodesics textured.obj --source 0 -o textured_distances.glb)
# Two textures of faces, and colors with opacity.
configure_file(${WORK}/a.png ${WORK}/b.png COPYONLY)
file(WRITE ${WORK}/textures.ply "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
  "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
  "property uchar blue\nproperty uchar alpha\nelement face 4\nproperty list uchar int vertex_indices\n"
  "property list uchar float texcoord\nproperty int texnumber\nend_header\n0 0 0 255 0 0 51\n2 0 0 0 255 0 255\n"
  "0 2 0 0 0 255 255\n0 0 2 9 9 9 255\n3 0 2 1 6 0 0 1 0 0 1 0\n3 0 1 3 6 0 0 1 0 0 1 1\n3 1 2 3 6 0 0 1 0 0 1 1\n"
  "3 2 0 3 6 0 0 1 0 0 1 -1\n")
run(${TOOL} pose textures.ply -o textures.glb --scene textures_scene.glb)
file(GLOB files ${WORK}/*.glb)
execute_process(COMMAND ${NODE} validate_gltf.js ${files} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE report)
list(LENGTH files number)
message(STATUS "${number} files:\n${report}")
if(result)
  message(FATAL_ERROR "The validator finds errors or warnings.")
endif()
