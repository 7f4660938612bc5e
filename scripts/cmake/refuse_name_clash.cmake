# Stops when the CGAL in use has a package of our name: whose header would be read then is a matter of
# luck. An earlier installation of this very package beside CGAL is no clash.

foreach(directory IN LISTS CGAL_INCLUDE_DIRS)
  file(GLOB namesakes
    "${directory}/CGAL/canonical_pose_3.h" "${directory}/CGAL/Canonical_pose_3/*.h")
  foreach(namesake IN LISTS namesakes)
    file(STRINGS "${namesake}" own_line LIMIT_INPUT 2000
      REGEX "belongs to Canonical_pose_3, an extension package for CGAL")
    if(NOT own_line)
      message(FATAL_ERROR
        "Canonical_pose_3: this CGAL already has a header of our name, ${namesake}")
    endif()
  endforeach()
endforeach()
