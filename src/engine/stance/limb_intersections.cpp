// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "limb_intersections.h"
#include "../surface/Self_intersections.h"

#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>

#include <Eigen/Geometry>

#include <limits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

std::vector<std::pair<std::size_t, std::size_t>>
limb_intersections(const Body_plan& body, const Point_matrix& pose,
                   const std::vector<std::array<std::size_t, 3>>& triangles)
{
  const std::size_t trunk = body.limbs().size(), none = trunk + 1;
  std::vector<std::size_t> parts(static_cast<std::size_t>(pose.rows()), trunk);
  for(std::size_t v = 0; v < parts.size(); ++v)
    for(std::size_t limb = 0; limb < trunk; ++limb)
      if(const double share = body.share_of_limb(body.limbs()[limb], static_cast<Eigen::Index>(v));
         share > 0)
        parts[v] = share == 1 && parts[v] == trunk ? limb : none;
  Triangle_soup soup;
  std::vector<Eigen::AlignedBox3d> boxes(trunk + 1);
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
  soup.keep_if([&](const std::size_t i) {
    const Eigen::AlignedBox3d box = box_of(soup.triangles[i]);
    for(std::size_t part = 0; part < boxes.size(); ++part)
      if(part != soup.face_of_triangle[i] && box.intersects(boxes[part]))
        return true;
    return false;
  });
  return Self_intersections(pose, soup)
    .run((std::numeric_limits<std::size_t>::max)())
    .value_or(std::vector<std::pair<std::size_t, std::size_t>>());
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
