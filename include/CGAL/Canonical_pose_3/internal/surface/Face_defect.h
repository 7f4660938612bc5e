// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_FACE_DEFECT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_FACE_DEFECT_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Describes what is wrong with a face: "is degenerate".
class Face_defect : public std::invalid_argument
{
public:
  Face_defect(const std::size_t face, const std::string& defect)
    : std::invalid_argument("face " + std::to_string(face) + ' ' + defect), m_face(face),
      m_defect(defect)
  {}

  std::size_t face() const { return m_face; }
  const std::string& defect() const { return m_defect; }

private:
  std::size_t m_face;
  std::string m_defect;
};

// Where a surface needs some area.
inline Face_defect no_face_has_area()
{
  return Face_defect(0, "is degenerate, and so are all the others");
}

// Calls f(). If it throws a defect of a triangle, the message refers to the face that contains the
// triangle. (A function of the user may have measured on another mesh.)
template <class Function>
auto with_faces_of_input(const std::vector<std::size_t>& face_of_triangle, const Function& f)
{
  try
  {
    return f();
  }
  catch(const Face_defect& defect)
  {
    if(defect.face() >= face_of_triangle.size())
      throw;
    throw Face_defect(face_of_triangle[defect.face()], defect.defect());
  }
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_FACE_DEFECT_H
