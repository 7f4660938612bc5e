// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LIMB_DIRECTION_3_H
#define CGAL_CANONICAL_POSE_3_LIMB_DIRECTION_3_H

#include <Eigen/Core>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief says where a limb of a person, or of an animal with four legs, goes.

\sa `Vertex_options::limb_directions`
*/
struct Limb_direction_3
{
  /// the limbs: the first four are those of persons, the others those of animals. Left and right are those of the
  /// body.
  enum class Limb {
    LEFT_ARM,
    RIGHT_ARM,
    LEFT_LEG,
    RIGHT_LEG,
    LEFT_FRONT_LEG,
    RIGHT_FRONT_LEG,
    LEFT_HIND_LEG,
    RIGHT_HIND_LEG
  };

  /// the limb, or the index of one of its vertices, such as its tip, in the order of `vertices(tmesh)`, of the points of
  /// a soup, or of the vertices of a complex (one of its boundary).
  std::variant<Limb, std::size_t> limb = Limb::LEFT_ARM;

  /// the direction from shoulder or hip to wrist or ankle, in the frame of the body: \f$ x \f$ to its left, \f$ y \f$
  /// upward, \f$ z \f$ to the front. Of any length but 0.
  Eigen::RowVector3d direction = Eigen::RowVector3d::UnitX();

  /// whether the limb becomes straight. Otherwise it has the bends of the canonical pose.
  bool is_straightened = true;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief is thrown for an element of `Vertex_options::limb_directions` that is not valid, or does not fit the shape.
*/
class Limb_direction_error : public std::invalid_argument
{
public:
  /// \param index the index of the element
  /// \param defect what is wrong with it
  Limb_direction_error(const std::size_t index, const std::string& defect)
    : std::invalid_argument("limb direction " + std::to_string(index) + ' ' + defect),
      m_index(index), m_defect(defect)
  {}

  /// returns the index of the element.
  std::size_t index() const { return m_index; }

  /// returns what is wrong with it, without its name.
  const std::string& defect() const { return m_defect; }

private:
  std::size_t m_index;
  std::string m_defect;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LIMB_DIRECTION_3_H
