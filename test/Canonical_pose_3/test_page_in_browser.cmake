# Makes a page of a pose, an animal, parts and distances, and opens it in Chromium.
# Called with -DTOOL=path -DMAKE_FIGURE=path -DNODE=path -DCHROMIUM=path -DWORK=directory; WORK is emptied first.

cmake_minimum_required(VERSION 3.19...3.31)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/screenshots)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${MAKE_FIGURE} --vertices 5000 --pose running running.off)
run(${MAKE_FIGURE} --vertices 5000 --shape animal animal.off)
run(${TOOL} pose running.off -o pose.off --scene running.glb --quiet)
run(${TOOL} pose animal.off -o pose.off --scene animal.glb --quiet)
run(${TOOL} segment running.off --method sweep --parts 8 -o parts.glb --quiet)
run(${TOOL} geodesics running.off --source 0 -o distances.glb)
run(${TOOL} page running.glb animal.glb parts.glb distances.glb -o page.html)
run(${NODE} ${CMAKE_CURRENT_LIST_DIR}/test_page_in_browser.js ${CHROMIUM} page.html --screenshots screenshots)
