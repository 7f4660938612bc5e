// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_DESCRIPTORS_H
#define CGAL_CANONICAL_POSE_3_TOOL_DESCRIPTORS_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

struct Descriptor
{
  std::string name;
  int version;
  bool needs_pose;
  double weight; // among others, if the user gives none; see the manual on how it was chosen
  // Throws std::invalid_argument if the surface cannot be described.
  std::function<Eigen::VectorXd(const CGAL::Canonical_pose_3::Point_matrix& points,
                                const CGAL::Canonical_pose_3::Face_list& polygons)>
    values;
  Eigen::Index size; // of the values
  // The distances of a query to the columns of a matrix.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& query,
                                const Eigen::Ref<const Eigen::MatrixXd>& others)>
    distances;
};

// All descriptors, or those with the given names. Throws std::invalid_argument if a name is unknown,
// or if the tool was built without what a descriptor needs.
std::vector<Descriptor> descriptors(const std::vector<std::string>& names);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_DESCRIPTORS_H
