// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHECK_LANDMARK_FIELDS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHECK_LANDMARK_FIELDS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws `std::invalid_argument` if there are no landmarks, or one is not one of `n` vertices. `what`: what
// messages call them.
inline void check_landmarks(const std::vector<std::size_t>& landmarks, const std::size_t n,
                            const std::string& what)
{
  if(landmarks.empty())
    throw std::invalid_argument(what + " are none");
  for(const std::size_t landmark : landmarks)
    if(landmark >= n)
      throw std::invalid_argument(what + " have landmark " + std::to_string(landmark)
                                  + ", but there are " + std::to_string(n) + " vertices");
}

// Throws `std::invalid_argument` unless there are distances of `n` vertices to as many landmarks as there are columns, at
// least one. `what`: what messages call the fields.
inline void check_shape(const Landmark_fields_3& fields, const std::size_t n,
                        const std::string& what)
{
  const auto rows = static_cast<std::size_t>(fields.distances.rows()),
             columns = static_cast<std::size_t>(fields.distances.cols());
  const auto refuse
    = [&](const std::string& defect) { throw std::invalid_argument(what + ' ' + defect); };
  if(columns == 0)
    refuse("have no column");
  if(rows != n)
    refuse("have " + std::to_string(rows) + " rows, but there are " + std::to_string(n)
           + " vertices");
  if(fields.landmarks.size() != columns)
    refuse("have " + std::to_string(fields.landmarks.size()) + " landmarks, but "
           + std::to_string(columns) + " columns");
  check_landmarks(fields.landmarks, n, what);
}

// Throws `std::invalid_argument` if entry (i, j) is negative or not finite. `vertex`: what messages call vertex i.
inline void check_distance(const Landmark_fields_3& fields, const Eigen::Index i,
                           const Eigen::Index j, const std::string& what,
                           const char* const vertex = "vertex")
{
  const double distance = fields.distances(i, j);
  if(!(distance >= 0) || !std::isfinite(distance))
    throw std::invalid_argument(what + ": the distance of " + vertex + ' ' + std::to_string(i)
                                + " to landmark "
                                + std::to_string(fields.landmarks[static_cast<std::size_t>(j)])
                                + " is " + (distance < 0 ? "negative" : "not finite"));
}

inline void check_covering_radius(const Landmark_fields_3& fields, const std::string& what)
{
  if(!(fields.covering_radius >= 0) || !std::isfinite(fields.covering_radius))
    throw std::invalid_argument(what + " have a covering_radius that is negative or not finite");
}

// Does all of this, for all distances.
inline void check_landmark_fields(const Landmark_fields_3& fields, const std::size_t n,
                                  const std::string& what)
{
  check_shape(fields, n, what);
  for(Eigen::Index j = 0; j < fields.distances.cols(); ++j)
    for(Eigen::Index i = 0; i < fields.distances.rows(); ++i)
      check_distance(fields, i, j, what);
  check_covering_radius(fields, what);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_TARGET_CHECK_LANDMARK_FIELDS_H
