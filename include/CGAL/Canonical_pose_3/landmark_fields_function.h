// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_FUNCTION_H
#define CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_FUNCTION_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns a function for `Options::landmark_fields_function` that measures distances with a
model of `GeodesicDistances_3`.

\tparam GeodesicDistances a model of `GeodesicDistances_3` that is constructed from a mesh; its
       `Triangle_mesh` is a model of `MutableFaceGraph` with an internal point property map

\sa `farthest_point_landmarks()`
*/
template <class GeodesicDistances>
Landmark_fields_function landmark_fields_function()
{
  return [](const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
            const std::size_t number_of_landmarks, const std::size_t first,
            const std::vector<std::size_t>& landmarks) {
    const auto mesh
      = make_triangle_mesh<typename GeodesicDistances::Triangle_mesh>(points, triangles);
    const auto vertex = [&](const std::size_t row) {
      internal::check_landmarks({row}, static_cast<std::size_t>(points.rows()), "the landmarks");
      return *std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(row));
    };
    const GeodesicDistances geodesics(mesh);
    if(landmarks.empty())
      return farthest_point_landmarks(geodesics, number_of_landmarks, vertex(first));
    Eigen::MatrixXd distances(points.rows(), static_cast<Eigen::Index>(landmarks.size()));
    for(std::size_t j = 0; j < landmarks.size(); ++j)
      distances.col(static_cast<Eigen::Index>(j)) = geodesics.distances(vertex(landmarks[j]));
    Landmark_fields_3 fields = landmark_fields(std::move(distances));
    fields.landmarks = landmarks; // there may be other points in the same place
    return fields;
  };
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LANDMARK_FIELDS_FUNCTION_H
