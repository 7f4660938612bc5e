// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pose_in_stance.h"
#include "timed.h"
#include "../stance/Body_plan.h"
#include "../stance/limb_goals.h"
#include "../stance/limb_intersections.h"
#include "../stance/skeleton_of_body.h"
#include "../stance/stance_target.h"
#include "../support/Point_search.h"
#include "../support/angle_between.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <CGAL/number_type_config.h>

#include <boost/algorithm/string/join.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The registration to a stance: no vertex near a joint is matched, and nothing is refined. The limbs of animals resist more, since they
// are thick where they bend.
Component_options options_in_stance(const Component_options& options, const Surface_body_3& body,
                                    const Skeleton_3::Kind kind, const Eigen::VectorXd& weights,
                                    const Eigen::Index number_of_rows)
{
  const double share_of_detail_length = kind == Skeleton_3::Kind::PERSON ? .35 : .15;
  Component_options result = options;
  result.number_of_rounds = 0;
  result.registration.detail_length
    = (std::max)(share_of_detail_length * options.registration.detail_length,
                 Registration_options::SMALLEST_DETAIL_LENGTH);
  result.volume_ratio_limit.reset();
  Eigen::VectorXd factors = Eigen::VectorXd::Zero(number_of_rows);
  for(std::size_t i = 0; i < body.surface_vertices.size(); ++i)
    factors[static_cast<Eigen::Index>(body.surface_vertices[i])]
      = weights[static_cast<Eigen::Index>(i)];
  result.matching_weights = options.matching_weights.size() == 0
                              ? factors
                              : options.matching_weights.cwiseProduct(factors).eval();
  return result;
}

constexpr double degrees_per_radian = 180 / CGAL_PI;

std::string in_degrees(const double angle)
{
  return std::to_string(static_cast<int>(std::round(angle))) + " degrees";
}

// Names the limbs that are far from their directions, are bent by far though they should be straight, have another length than
// their partners, pass through each other, or end above the floor though they stand. `to_body`: from the pose to the frame of the
// body.
std::vector<std::string> warnings_of_limbs(const Body_plan& plan, const Point_matrix& pose,
                                           const Surface_component_3& surface,
                                           const Coarse_surface_3& coarse,
                                           const std::array<Eigen::Vector3d, 4>& directions,
                                           const Limb_goals& goals,
                                           const Eigen::Isometry3d& to_body)
{
  const double largest_bend = plan.kind() == Skeleton_3::Kind::PERSON ? 30 : 45;
  constexpr double largest_angle = 15, largest_ratio = 1.25, largest_height = .04;
  std::vector<std::string> off, bent, unequal, crossing, above;
  std::array<double, 4> lengths;
  const Eigen::VectorXd heights
    = pose * to_body.linear().row(1).transpose(); // above an arbitrary plane
  const double size = heights.maxCoeff() - heights.minCoeff();
  std::map<std::size_t, double> heights_of_feet;
  for(std::size_t i = 0; i < goals.size(); ++i)
  {
    const Limb& limb = plan.limbs()[i];
    const std::string name = name_of_limb(plan.kind(), i);
    const Eigen::Vector3d direction = to_body.linear() * direction_of_limb(plan, limb, pose);
    const double angle = degrees_per_radian * angle_between(direction, directions[i]);
    if(angle > largest_angle)
      off.push_back(name + " by " + in_degrees(angle));
    const Eigen::Vector3d middle = plan.center(pose, limb, (limb.root + limb.end) / 2),
                          upper = middle - plan.center(pose, limb, limb.root).transpose(),
                          lower = plan.end_joint(pose, limb).transpose() - middle;
    lengths[i] = upper.norm() + lower.norm();
    const double bend = degrees_per_radian * angle_between(upper, lower);
    if(goals[i].is_straight() && bend > largest_bend)
      bent.push_back(name + " by " + in_degrees(bend));
    if(goals[i].stands())
      heights_of_feet[i] = (limb.distances.array() <= limb.end)
                             .select(heights.array(), (std::numeric_limits<double>::infinity)())
                             .minCoeff();
  }
  const auto lowest = std::min_element(
    heights_of_feet.begin(), heights_of_feet.end(),
    [](const auto& foot, const auto& other) { return foot.second < other.second; });
  for(const auto& [limb, height] : heights_of_feet)
    if(height - lowest->second > largest_height * size)
      above.push_back(name_of_limb(plan.kind(), limb));
  for(const std::size_t i : {0, 2})
    if((std::max)(lengths[i], lengths[i + 1])
       > largest_ratio * (std::min)(lengths[i], lengths[i + 1]))
      unequal.push_back(name_of_limb(plan.kind(), i) + " and " + name_of_limb(plan.kind(), i + 1));
  for(const auto& [limb, other] : limb_intersections(plan, coarse, pose, surface.triangles))
    crossing.push_back(
      name_of_limb(plan.kind(), limb) + " and "
      + (other < goals.size() ? name_of_limb(plan.kind(), other) : "trunk or head"));
  std::vector<std::string> result;
  for(const auto& [text, limbs] : {std::make_pair("limbs are off their directions", off),
                                   std::make_pair("limbs are bent", bent),
                                   std::make_pair("limbs have different lengths", unequal),
                                   std::make_pair("parts pass through each other", crossing),
                                   std::make_pair("feet are above the floor", above)})
    if(!limbs.empty())
      result.push_back(std::string(text)
                       + " in the stance: " + boost::algorithm::join(limbs, ", "));
  return result;
}

// Directions with vertices of the pose, with those of the surface.
std::vector<Limb_direction_3> directions_on_surface(std::vector<Limb_direction_3> directions,
                                                    const Surface_body_3& body)
{
  for(std::size_t i = 0; i < directions.size(); ++i)
    if(auto* const vertex = std::get_if<std::size_t>(&directions[i].limb))
    {
      const auto found
        = std::find(body.surface_vertices.begin(), body.surface_vertices.end(), *vertex);
      if(found == body.surface_vertices.end())
        throw Limb_direction_error(i, "names a vertex that is not on the surface");
      *vertex = static_cast<std::size_t>(found - body.surface_vertices.begin());
    }
  return directions;
}

} // namespace

Skeleton_3 with_weights_at(const Point_matrix& others, const Point_matrix& points,
                           Skeleton_3 skeleton)
{
  if(others.rows() == points.rows() && others == points)
    return skeleton;
  const auto nearest = Point_search(points).nearest(others, 1);
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t i = 0; i < nearest.size(); ++i)
    for(Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(
          skeleton.weights, static_cast<Eigen::Index>(nearest[i][0]));
        entry; ++entry)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(entry.col()), entry.value());
  skeleton.weights.resize(others.rows(), skeleton.weights.cols());
  skeleton.weights.setFromTriplets(entries.begin(), entries.end());
  return skeleton;
}

Result pose_in_stance(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                      const Surface_body_3& body, const Component_options& options,
                      Result canonical)
{
  Registration_summary& summary = canonical.summary;
  if(summary.termination == Registration_summary::CANCELED)
    return canonical;
  Method_options distances = options;
  distances.number_of_landmarks = Method_options().number_of_landmarks;
  distances.random_seed = 0;
  const Body_plan plan = timed(summary, "stance", [&] {
    return Body_plan(
      surface, coarse, rows_at(canonical.pose, body.surface_vertices),
      [&](const Surface_component_3& measured, const std::vector<std::size_t>& sources) {
        return sources.empty() ? landmark_fields(measured, distances)
                               : landmark_fields(measured, sources, distances);
      });
  });
  Result result;
  Point_matrix upright = plan.upright();
  std::optional<std::array<Eigen::Vector3d, 4>> directions;
  Limb_goals goals;
  if(options.stance == Options::Stance::CANONICAL && options.limb_directions.empty())
    result = std::move(canonical);
  else
  {
    goals = limb_goals(plan, options.stance, directions_on_surface(options.limb_directions, body));
    Target_3 target;
    target.is_given = true;
    target.summary = summary.target;
    const Stance_target stance
      = timed(summary, "stance", [&] { return stance_target(plan, options.stance, goals); });
    upright = stance.points;
    directions = stance.directions;
    target.points = align_target(stance.points, surface.points, plan.shares());
    result = registered_pose(
      surface, coarse, Landmark_fields_3{{}, Eigen::MatrixXd(coarse.surface.points.rows(), 0), 0},
      target, body,
      options_in_stance(options, body, plan.kind(), stance.weights, canonical.pose.rows()));
    for(const Registration_summary::Stage& stage : summary.stages)
      result.summary.add_seconds(stage.first, stage.second);
    for(const std::string& warning : summary.warnings)
      if(std::find(result.summary.warnings.begin(), result.summary.warnings.end(), warning)
         == result.summary.warnings.end())
        result.summary.warnings.push_back(warning);
    result.summary.rounds = summary.rounds;
    result.summary.iterations += summary.iterations;
  }
  if(!result.is_usable())
    return result;
  const Point_matrix pose = rows_at(result.pose, body.surface_vertices);
  result.skeleton = with_weights_at(result.pose, pose, skeleton_of_body(plan, pose, upright));
  if(directions)
  {
    const auto warnings
      = warnings_of_limbs(plan, pose, surface, coarse, *directions, goals, result.skeleton->frame);
    result.summary.warnings.insert(result.summary.warnings.end(), warnings.begin(), warnings.end());
  }
  if(!plan.is_certain())
    result.summary.warnings.push_back(
      plan.kind() == Skeleton_3::Kind::PERSON
        ? "front and back of the body may be confused: the toes hardly tell them apart"
        : "the back and the belly of the animal may be confused: its legs hardly tell them apart");
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
