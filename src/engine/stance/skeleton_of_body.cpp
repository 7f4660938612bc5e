// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "skeleton_of_body.h"
#include "smooth_step.h"
#include "../target/aligning_motion.h"

#include <CGAL/Canonical_pose_3/Skeleton_3.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

using Weight = std::pair<double, Eigen::Index>; // of a joint

class Skeleton_of_body
{
public:
  Skeleton_of_body(const Body_plan& body, const Point_matrix& pose) : m_body(body), m_pose(pose)
  {
    m_result.kind = body.kind();
    m_result.is_front_certain = body.is_certain();
    const auto middle = [&](const Limb& limb, const Limb& other) {
      return Eigen::RowVector3d((position(limb, limb.root) + position(other, other.root)) / 2);
    };
    const std::array<Limb, 4>& limbs = body.limbs();
    add("hips", HIPS, middle(limbs[2], limbs[3]), 0);
    add("chest", HIPS, middle(limbs[0], limbs[1]), 0);
    add("neck", CHEST, position(body.head(), body.head().end),
        radius(body.head(), body.head().end));
    static constexpr std::array<const char*, 4> roots
      = {"left shoulder", "right shoulder", "left hip", "right hip"},
      middles = {"left elbow", "right elbow", "left knee", "right knee"},
      ends = {"left wrist", "right wrist", "left ankle", "right ankle"};
    for(std::size_t i = 0; i < limbs.size(); ++i)
    {
      m_first_joints[i] = m_result.joints.size();
      add(roots[i], i < 2 ? CHEST : HIPS, limbs[i], limbs[i].root);
      add(middles[i], m_first_joints[i], limbs[i], middle_of(limbs[i]));
      add(ends[i], m_first_joints[i] + 1, body.end_joint(pose, limbs[i]),
          radius(limbs[i], limbs[i].end));
    }
    if(body.tail())
    {
      m_tail = m_result.joints.size();
      add("tail", HIPS, *body.tail(), body.tail()->root);
    }
    for(const std::size_t trunk : {HIPS, CHEST})
      m_result.joints[trunk].radius
        = (m_result.joints[m_first_joints[trunk == CHEST ? 0 : 2]].position
           - m_result.joints[m_first_joints[trunk == CHEST ? 1 : 3]].position)
            .norm()
          / 2;
    set_weights();
  }

  Skeleton_3 result() && { return std::move(m_result); }

private:
  static constexpr std::size_t HIPS = 0, CHEST = 1, NECK = 2;

  Eigen::RowVector3d position(const Limb& limb, const double distance) const
  {
    return m_body.center(m_pose, limb, distance);
  }

  // Of a circle with the girth, in the unit of the pose.
  double radius(const Limb& limb, const double distance) const
  {
    return m_body.girth(limb, distance) * m_body.unit() / (2 * CGAL_PI);
  }

  static double middle_of(const Limb& limb) { return (limb.end + limb.root) / 2; }

  void add(const char* const name, const std::size_t parent, const Eigen::RowVector3d& position,
           const double radius)
  {
    m_result.joints.push_back({name, parent, position, radius});
  }

  void add(const char* const name, const std::size_t parent, const Limb& limb,
           const double distance)
  {
    add(name, parent, position(limb, distance), radius(limb, distance));
  }

  void set_weights()
  {
    constexpr std::size_t most = 4;
    std::vector<Eigen::Triplet<double>> entries;
    for(Eigen::Index v = 0; v < m_pose.rows(); ++v)
    {
      std::vector<Weight> weights = weights_of(v);
      std::stable_sort(weights.begin(), weights.end(),
                       [](const Weight& a, const Weight& b) { return a.first > b.first; });
      weights.resize((std::min)(weights.size(), most));
      double sum = 0;
      for(const Weight& weight : weights)
        sum += weight.first;
      for(const auto& [weight, joint] : weights)
        if(weight > 0)
          entries.emplace_back(static_cast<int>(v), static_cast<int>(joint), weight / sum);
    }
    m_result.weights.resize(m_pose.rows(), static_cast<Eigen::Index>(m_result.joints.size()));
    m_result.weights.setFromTriplets(entries.begin(), entries.end());
  }

  // Blended at joints: of the trunk along its axis, of limbs by the distance from the tip.
  std::vector<Weight> weights_of(const Eigen::Index v) const
  {
    const auto beyond = [v](const Limb& limb, const double distance) {
      return smooth_step((distance - limb.distances[v]) / (2 * Body_plan::width_of_joint(limb))
                         + .5);
    };
    std::vector<Weight> result;
    double trunk = 1;
    const auto split_off = [&](double& whole, const double share, const std::size_t joint) {
      result.emplace_back(share * whole, static_cast<Eigen::Index>(joint));
      whole *= 1 - share;
    };
    for(std::size_t i = 0; i < m_body.limbs().size(); ++i)
    {
      const Limb& limb = m_body.limbs()[i];
      double rest = trunk * m_body.share_of_limb(limb, v);
      if(rest == 0)
        continue;
      trunk -= rest;
      split_off(rest, beyond(limb, limb.end), m_first_joints[i] + 2);
      split_off(rest, beyond(limb, middle_of(limb)), m_first_joints[i] + 1);
      split_off(rest, 1, m_first_joints[i]);
    }
    split_off(trunk, beyond(m_body.head(), m_body.head().end), NECK);
    if(m_body.tail())
      split_off(trunk, beyond(*m_body.tail(), m_body.tail()->root), m_tail);
    split_off(trunk, m_body.share_of_chest(v), CHEST);
    split_off(trunk, 1, HIPS);
    return result;
  }

  const Body_plan& m_body;
  const Point_matrix& m_pose;
  Skeleton_3 m_result;
  std::array<std::size_t, 4> m_first_joints = {0, 0, 0, 0};
  std::size_t m_tail = 0;
};

} // namespace

Skeleton_3 skeleton_of_body(const Body_plan& body, const Point_matrix& pose,
                            const Point_matrix& upright)
{
  Skeleton_3 result = Skeleton_of_body(body, pose).result();
  result.frame = aligning_motion(pose, upright, body.shares());
  result.frame.translation()[1] -= (result.frame * pose.transpose()).row(1).minCoeff();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
