// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SKELETON_3_H
#define CGAL_CANONICAL_POSE_3_SKELETON_3_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the joints of a person, or of an animal with four legs, and how vertices follow them.

\sa `Method_options::stance`
\sa `Vertex_options::limb_directions`
*/
struct Skeleton_3
{
  /// what was recognized.
  enum class Kind {
    PERSON,     ///< a head, two arms and two legs.
    FOUR_LEGGED ///< a head and four legs, possibly a tail.
  };

  /// is a joint, from which a bone leads to each joint whose parent it is.
  struct Joint
  {
    std::string name;            ///< such as `"left elbow"`.
    std::size_t parent;          ///< an earlier joint; that of the first one is itself.
    Eigen::RowVector3d position; ///< in the pose.
    double radius;               ///< that of the cross-section of the limb there.
  };

  /// the kind.
  Kind kind = Kind::PERSON;

  /// the joints. The first one is `"hips"`. Left and right are those of the body.
  std::vector<Joint> joints;

  /// \f$ n \times \f$ the number of joints: the weights with which each vertex follows the joints, nonnegative
  /// with the sum 1, at most four per vertex.
  Eigen::SparseMatrix<double, Eigen::RowMajor> weights;

  /// whether front and back of a person, or up and down of an animal, are told apart without doubt, by the
  /// direction of the toes and the relief of the head, or by the direction of the legs of the input.
  bool is_front_certain = false;

  /// the rigid motion from the pose to the frame of the body: \f$ x \f$ to the left, \f$ y \f$ upward,
  /// \f$ z \f$ to the front; the lowest point has \f$ y = 0 \f$.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SKELETON_3_H
