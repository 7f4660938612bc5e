# Finds what Canonical_pose_3 stands on. Read by the build and, once installed, by find_package():
# both see the same libraries under the same names.
#
# Input:  WITH_CHOLMOD, WITH_TBB, WITH_TETGEN
# Output: Canonical_pose_3_dependencies_FOUND, Canonical_pose_3_dependencies_message
#         Canonical_pose_3_CGAL_VERSION
#         Canonical_pose_3_{CHOLMOD,TBB,TetGen}_{FOUND,message}
#         targets CGAL::CGAL, Eigen3::Eigen, TBB::tbb, TBB::tbbmalloc,
#                 Canonical_pose_3::CHOLMOD_library, Canonical_pose_3::TetGen_library

# Sets <name>_FOUND and <name>_message, and defines the imported target Canonical_pose_3::<name>_library.
macro(canonical_pose_3_find_library name wanted header library packages note)
  set(Canonical_pose_3_${name}_FOUND FALSE)
  if(NOT ${wanted})
    set(Canonical_pose_3_${name}_message "no (${wanted} is off)")
  else()
    find_path(Canonical_pose_3_${name}_INCLUDE_DIR ${header} PATH_SUFFIXES suitesparse)
    find_library(Canonical_pose_3_${name}_LIBRARY ${library})
    mark_as_advanced(Canonical_pose_3_${name}_INCLUDE_DIR Canonical_pose_3_${name}_LIBRARY)
    if(Canonical_pose_3_${name}_INCLUDE_DIR AND Canonical_pose_3_${name}_LIBRARY)
      set(Canonical_pose_3_${name}_FOUND TRUE)
      set(Canonical_pose_3_${name}_message "yes${note} (${Canonical_pose_3_${name}_LIBRARY})")
      if(NOT TARGET Canonical_pose_3::${name}_library)
        add_library(Canonical_pose_3::${name}_library UNKNOWN IMPORTED GLOBAL)
        set_target_properties(Canonical_pose_3::${name}_library PROPERTIES
          IMPORTED_LOCATION "${Canonical_pose_3_${name}_LIBRARY}"
          INTERFACE_INCLUDE_DIRECTORIES "${Canonical_pose_3_${name}_INCLUDE_DIR}")
      endif()
    else()
      set(Canonical_pose_3_${name}_message "no (not found; Debian: ${packages})")
    endif()
  endif()
endmacro()

set(Canonical_pose_3_dependencies_FOUND FALSE)

# No version here: CGAL's version file accepts the same major version only, so that a request for
# 5.5 would turn CGAL 6 down.
find_package(CGAL QUIET)
find_package(Eigen3 3.3 QUIET NO_MODULE)
if(CGAL_FOUND)
  # 1MMmmb1000: major, minor and bug-fix number
  foreach(directory IN LISTS CGAL_INCLUDE_DIRS)
    if(EXISTS "${directory}/CGAL/version.h")
      file(STRINGS "${directory}/CGAL/version.h" Canonical_pose_3_CGAL_VERSION_NR
        REGEX "^#define CGAL_VERSION_NR +[0-9]+")
      string(REGEX REPLACE "[^0-9]" "" Canonical_pose_3_CGAL_VERSION_NR
        "${Canonical_pose_3_CGAL_VERSION_NR}")
      file(STRINGS "${directory}/CGAL/version.h" Canonical_pose_3_CGAL_VERSION
        REGEX "^#define CGAL_VERSION +[0-9]+")
      string(REGEX REPLACE "^#define CGAL_VERSION +" "" Canonical_pose_3_CGAL_VERSION
        "${Canonical_pose_3_CGAL_VERSION}")
      break()
    endif()
  endforeach()
endif()

if(NOT CGAL_FOUND)
  set(Canonical_pose_3_dependencies_message
    "CGAL was not found (Debian: libcgal-dev), or Boost, GMP or MPFR, which it needs")
elseif(NOT Canonical_pose_3_CGAL_VERSION_NR GREATER_EQUAL 1050511000)
  set(Canonical_pose_3_dependencies_message
    "CGAL 5.5.1 or later is needed, ${Canonical_pose_3_CGAL_VERSION} was found")
elseif(NOT TARGET Eigen3::Eigen)
  set(Canonical_pose_3_dependencies_message
    "Eigen 3.3 or later was not found (Debian: libeigen3-dev)")
else()
  set(Canonical_pose_3_dependencies_FOUND TRUE)
endif()

canonical_pose_3_find_library(CHOLMOD WITH_CHOLMOD cholmod.h cholmod
  "libsuitesparse-dev libopenblas0-pthread" "")
canonical_pose_3_find_library(TetGen WITH_TETGEN tetgen.h tet
  "libtet1.5-dev" ", AGPL-3.0-or-later")
if(Canonical_pose_3_TetGen_FOUND)
  # tetgen.h declares the function tetrahedralize() only under this macro.
  set_target_properties(Canonical_pose_3::TetGen_library PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS TETLIBRARY)
endif()

set(Canonical_pose_3_TBB_FOUND FALSE)
if(NOT WITH_TBB)
  set(Canonical_pose_3_TBB_message "no (WITH_TBB is off)")
else()
  find_package(TBB QUIET)
  if(TARGET TBB::tbb AND TARGET TBB::tbbmalloc)
    set(Canonical_pose_3_TBB_FOUND TRUE)
    set(Canonical_pose_3_TBB_message "yes (${TBB_VERSION})")
  else()
    set(Canonical_pose_3_TBB_message "no (not found; Debian: libtbb-dev)")
  endif()
endif()
