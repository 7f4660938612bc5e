// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_LIMB_MEASURES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_LIMB_MEASURES_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Skeleton_3;
using Stance = CGAL::Canonical_pose_3::Options::Stance;

constexpr std::size_t number_of_limbs = 4; // left and right arm or front leg, left and right leg

/// From the root to the end.
inline const std::array<std::array<const char*, 3>, number_of_limbs>& joints_of_limbs()
{
  static const std::array<std::array<const char*, 3>, number_of_limbs> names
    = {{{"left shoulder", "left elbow", "left wrist"},
        {"right shoulder", "right elbow", "right wrist"},
        {"left hip", "left knee", "left ankle"},
        {"right hip", "right knee", "right ankle"}}};
  return names;
}

inline const char* name_of_limb(const std::size_t limb, const Stance stance)
{
  static const std::array<const char*, number_of_limbs> of_person
    = {"left arm", "right arm", "left leg", "right leg"},
    of_animal = {"left front leg", "right front leg", "left hind leg", "right hind leg"};
  return (stance == Stance::STAND ? of_animal : of_person)[limb];
}

/// Where a stance has a limb, from its root to its end, in the frame of the body: legs are parallel, or
/// apart by 22 degrees each. (The library's are apart by 2 degrees each where they are parallel, so that
/// feet do not touch.)
inline Eigen::Vector3d direction_of_limb(const std::size_t limb, const Stance stance)
{
  const bool is_arm = limb < 2;
  Eigen::Vector3d result(0, -1, 0);
  if(is_arm && stance == Stance::A)
    result = {1, -1, 0};
  else if(is_arm && stance != Stance::STAND)
    result = {1, 0, 0};
  else if(stance == Stance::VITRUVIAN)
    result = {.4, -1, 0};
  if(limb % 2 == 1)
    result[0] *= -1;
  return result;
}

inline double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / EIGEN_PI;
}

struct Limb_measures
{
  std::array<double, number_of_limbs> angles; ///< from root to end against the stance, in degrees
  std::array<double, number_of_limbs> bends;  ///< at elbow or knee, in degrees; 0: straight
  /// mean distance of a joint of a limb from the mirror image of its partner at the plane x = 0
  double asymmetry;
};

/// \param unit of the asymmetry, in the unit of the pose.
inline Limb_measures limb_measures(const Skeleton_3& skeleton, const Stance stance,
                                   const double unit)
{
  const auto position = [&](const std::string& name) -> Eigen::Vector3d {
    for(const Skeleton_3::Joint& joint : skeleton.joints)
      if(joint.name == name)
        return skeleton.frame * joint.position.transpose();
    throw std::runtime_error("the skeleton lacks " + name);
  };
  Limb_measures result = {};
  std::array<std::array<Eigen::Vector3d, 3>, number_of_limbs> joints;
  for(std::size_t i = 0; i < number_of_limbs; ++i)
  {
    std::transform(joints_of_limbs()[i].begin(), joints_of_limbs()[i].end(), joints[i].begin(),
                   position);
    const auto& [root, middle, end] = joints[i];
    result.angles[i] = degrees_between(end - root, direction_of_limb(i, stance));
    result.bends[i] = degrees_between(middle - root, end - middle);
  }
  for(std::size_t i = 0; i < number_of_limbs; i += 2)
    for(std::size_t k = 0; k < 3; ++k)
      result.asymmetry
        += (Eigen::Vector3d(-joints[i][k][0], joints[i][k][1], joints[i][k][2]) - joints[i + 1][k])
             .norm()
           / (unit * 6);
  return result;
}

/// Returns for each vertex the limb that it follows most; 4: the head, 5: the tail, 6: the trunk.
inline std::vector<std::size_t> limbs_of_vertices(const Skeleton_3& skeleton)
{
  std::vector<std::size_t> limb_of_joint;
  for(const Skeleton_3::Joint& joint : skeleton.joints)
  {
    std::size_t limb = 6;
    if(joint.name == "neck")
      limb = 4;
    else if(joint.name == "tail")
      limb = 5;
    for(std::size_t i = 0; i < number_of_limbs; ++i)
      for(const char* name : joints_of_limbs()[i])
        if(joint.name == name)
          limb = i;
    limb_of_joint.push_back(limb);
  }
  std::vector<std::size_t> result;
  for(Eigen::Index v = 0; v < skeleton.weights.rows(); ++v)
  {
    std::array<double, 7> sums = {};
    for(Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(skeleton.weights, v);
        entry; ++entry)
      sums[limb_of_joint[static_cast<std::size_t>(entry.col())]] += entry.value();
    result.push_back(
      static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin()));
  }
  return result;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_LIMB_MEASURES_H
