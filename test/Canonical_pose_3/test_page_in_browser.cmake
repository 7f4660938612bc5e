# Makes a page of a pose in three stances, an animal, parts and distances, and one of scenes of other programs, and opens both in
# Chromium. The pose that the page saves has to be the pose.
# Called with -DTOOL=path -DMAKE_FIGURE=path -DNODE=path -DCHROMIUM=path -DWORK=directory; WORK is emptied first.

cmake_minimum_required(VERSION 3.19...3.31)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/screenshots ${WORK}/saved ${WORK}/others)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${MAKE_FIGURE} --vertices 5000 --pose running running.off)
run(${MAKE_FIGURE} --vertices 5000 --shape animal animal.off)
run(${TOOL} pose running.off -o pose.off --scene running.glb --quiet)
run(${TOOL} pose animal.off -o animal_pose.off --scene animal.glb --quiet)
run(${TOOL} segment running.off --method sweep --parts 8 -o parts.glb --quiet)
run(${TOOL} geodesics running.off --source 0 -o distances.glb)
run(${TOOL} pose running.off --stance t -o t.off --scene running_t.glb --quiet)
run(${TOOL} pose running.off --stance a -o a.off --scene running_a.glb --quiet)
run(${TOOL} page running.glb running_t.glb running_a.glb animal.glb parts.glb distances.glb -o page.html)
execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/scenes_of_others.js others WORKING_DIRECTORY ${WORK}
  OUTPUT_VARIABLE others COMMAND_ERROR_IS_FATAL ANY)
run(${TOOL} page ${others} -o others.html)
run(${NODE} ${CMAKE_CURRENT_LIST_DIR}/test_page_in_browser.js ${CHROMIUM} page.html --others others.html --saved saved
  --screenshots screenshots)

foreach(pair IN ITEMS "pose.off;saved/running_pose.obj" "a.off;saved/running_a_pose.obj")
  execute_process(COMMAND ${TOOL} compare ${pair} WORKING_DIRECTORY ${WORK}
    OUTPUT_VARIABLE difference COMMAND_ERROR_IS_FATAL ANY)
  if(NOT difference MATCHES "\n0\\.000000")
    message(FATAL_ERROR "The pose that the page saves differs from the pose: ${difference}")
  endif()
endforeach()
