# Debian packages, made by `cpack` (see scripts/package): the tool, the headers with the library, and the
# Python module.

if(NOT WITH_packages)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Canonical_pose_3 authors <canonical-pose-3@example.org>")
set(CPACK_PACKAGE_VENDOR "The Canonical_pose_3 authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# add_debian_package(component package section summary text [dependency...])
set(CPACK_COMPONENTS_ALL "")
function(add_debian_package component package section summary text)
  string(TOUPPER ${component} name)
  list(JOIN ARGN ", " dependencies)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_DEPENDS "${dependencies}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  install(FILES ${PROJECT_SOURCE_DIR}/scripts/debian/copyright ${PROJECT_BINARY_DIR}/changelog.gz
    DESTINATION share/doc/${package} COMPONENT ${component})
endfunction()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/changelog "canonical-pose-3 (${PROJECT_VERSION}) unstable; urgency=medium

  * See CHANGES.md at the home of the project.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)

set(about "Whether bent or straight, sitting or standing, a shape ends up in nearly the
same pose: it is pulled toward the multidimensional scaling embedding of its
geodesic distances, while an as-rigid-as-possible energy preserves its
details.")
set(libraries libcgal-dev libeigen3-dev)
foreach(library IN ITEMS "CHOLMOD:libsuitesparse-dev" "TBB:libtbb-dev" "TetGen:libtet1.5-dev")
  string(REPLACE ":" ";" library ${library})
  list(GET library 0 name)
  list(GET library 1 package)
  if(Canonical_pose_3_${name}_FOUND)
    list(APPEND libraries ${package})
  endif()
endforeach()
add_debian_package(development libcanonical-pose-3-dev libdevel
  "detail-preserving canonical poses of 3D shapes (C++ library)"
  "${about}\n.\nThis package contains the headers and the library, an extension of CGAL."
  ${libraries})
if(TARGET canonical-pose)
  add_debian_package(tools canonical-pose math
    "detail-preserving canonical poses of 3D shapes (tool)"
    "${about}\n.\nThis package contains the command canonical-pose, which computes poses,\nsegments shapes, and searches collections of shapes.")
endif()
if(TARGET canonical_pose_python)
  add_debian_package(python python3-canonical-pose python
    "detail-preserving canonical poses of 3D shapes (Python module)"
    "${about}\n.\nThis package contains the module canonical_pose for Python 3."
    python3 python3-numpy)
  # What the interpreter has compiled belongs to no package.
  file(WRITE ${PROJECT_BINARY_DIR}/prerm "#!/bin/sh
set -e
rm -rf /usr/lib/python3/dist-packages/canonical_pose/__pycache__
")
  file(CHMOD ${PROJECT_BINARY_DIR}/prerm
    PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/prerm)
endif()

include(CPack)
