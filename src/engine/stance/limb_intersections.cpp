// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "limb_intersections.h"
#include "../surface/Self_intersections.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

namespace {

// How often a surface winds around a point, by solid angles: unlike Triangle_tree, which counts what a ray crosses, about right also if
// there are holes.
double winding_number(const Point_matrix& points, const std::vector<Index_triangle>& triangles,
                      const Eigen::RowVector3d& point)
{
  double sum = 0;
  for(const Index_triangle& t : triangles)
  {
    const auto way = [&](const std::size_t i) -> Eigen::RowVector3d {
      return (points.row(static_cast<Eigen::Index>(t[i])) - point).normalized();
    };
    const Eigen::RowVector3d a = way(0), b = way(1), c = way(2);
    sum += std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (2 * CGAL_PI);
}

// Whether the middle of a limb is inside of another part, too.
bool is_inside(const Body_plan& body, const Limb& limb, const Point_matrix& pose,
               const Surface_component_3& posed)
{
  constexpr double least_winding = 1.5;
  for(const double share : {.1, .3, .5, .7})
    if(winding_number(posed.points, posed.triangles,
                      body.center(pose, limb, limb.end + share * (limb.root - limb.end)))
       > least_winding)
      return true;
  return false;
}

} // namespace

std::vector<std::pair<std::size_t, std::size_t>>
limb_intersections(const Body_plan& body, const Coarse_surface_3& coarse, const Point_matrix& pose,
                   const std::vector<Index_triangle>& triangles)
{
  const std::size_t trunk = body.limbs().size(), first_joint = trunk + 1, none = 2 * trunk + 1;
  std::vector<std::size_t> parts(static_cast<std::size_t>(pose.rows()), trunk);
  for(std::size_t v = 0; v < parts.size(); ++v)
    for(std::size_t limb = 0; limb < trunk; ++limb)
      if(const double share = body.share_of_limb(body.limbs()[limb], static_cast<Eigen::Index>(v));
         share > 0)
        parts[v] = parts[v] != trunk ? none : share == 1 ? limb : first_joint + limb;
  Triangle_soup soup;
  std::vector<Eigen::AlignedBox3d> boxes(none);
  const auto box_of = [&](const Index_triangle& t) {
    Eigen::AlignedBox3d box;
    for(const std::size_t v : t)
      box.extend(pose.row(static_cast<Eigen::Index>(v)).transpose());
    return box;
  };
  for(const Index_triangle& t : triangles)
    if(const std::size_t part = parts[t[0]]; part != none && parts[t[1]] == part
                                             && parts[t[2]] == part && !is_degenerate(pose, t))
    {
      soup.triangles.push_back(t);
      soup.face_of_triangle.push_back(part);
      boxes[part].extend(box_of(t));
    }
  // Joints intersect limbs only, not their own one.
  const auto is_searched = [&](const std::size_t part, const std::size_t other) {
    const std::size_t small = (std::min)(part, other), large = (std::max)(part, other);
    return small < trunk && small != large && large != first_joint + small;
  };
  soup.keep_if([&](const std::size_t i) {
    const Eigen::AlignedBox3d box = box_of(soup.triangles[i]);
    for(std::size_t part = 0; part < boxes.size(); ++part)
      if(is_searched(soup.face_of_triangle[i], part) && box.intersects(boxes[part]))
        return true;
    return false;
  });
  std::vector<std::pair<std::size_t, std::size_t>> result;
  const auto pairs = Self_intersections(pose, soup).run((std::numeric_limits<std::size_t>::max)());
  if(pairs)
    for(const auto& [part, other] : *pairs)
      if(is_searched(part, other))
        result.emplace_back(part, (std::min)(other, trunk));
  const Surface_component_3 posed = coarse.posed(pose);
  for(std::size_t limb = 0; limb < trunk; ++limb)
    if(std::none_of(result.begin(), result.end(),
                    [&](const auto& pair) { return pair.first == limb || pair.second == limb; })
       && is_inside(body, body.limbs()[limb], pose, posed))
      result.emplace_back(limb, trunk);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
