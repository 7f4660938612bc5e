// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_SURFACE_WITH_RAYS_H
#define CGAL_CANONICAL_POSE_3_TEST_SURFACE_WITH_RAYS_H

#include "engine/lattice/Surface_rays.h"

#include <CGAL/Random.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace Canonical_pose_test {

using Hit = CGAL::Canonical_pose_3::internal::Surface_rays::Hit;

struct Surface
{
  explicit Surface(const Triangle_soup& soup, const double unit = 1)
    : points(unit * to_matrix(soup.points)), triangles(soup.triangles), rays(points, triangles)
  {}

  std::vector<Hit> hits(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const
  {
    std::vector<Hit> result;
    rays.trace(origin, direction, triangles.size(), [&](const Hit& hit) {
      result.push_back(hit);
      return true;
    });
    return result;
  }

  Eigen::Vector3d corner(const std::size_t face, const std::size_t k) const
  {
    return points.row(Eigen::Index(triangles[face][k]));
  }

  CGAL::Canonical_pose_3::internal::Row_points points;
  std::vector<CGAL::Canonical_pose_3::internal::Index_triangle> triangles;
  CGAL::Canonical_pose_3::internal::Surface_rays rays;
};

// The intersection of a ray and the plane of a face: how far inside the face (the smallest
// barycentric coordinate), how far along the ray, and whether along the normal. By Cramer's rule,
// face by face.
struct Meeting
{
  double inside, distance;
  bool is_exit;
  bool is_parallel; // nearly, so the numbers are meaningless
};
inline Meeting meeting(const Surface& s, const std::size_t f, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d a = s.corner(f, 0);
  Eigen::Matrix3d m;
  m << s.corner(f, 1) - a, s.corner(f, 2) - a, -direction;
  const double determinant = m.determinant();
  Eigen::Vector3d x;
  for(int k = 0; k < 3; ++k)
  {
    Eigen::Matrix3d replaced = m;
    replaced.col(k) = origin - a;
    x[k] = replaced.determinant() / determinant;
  }
  return {(std::min)({x[0], x[1], 1 - x[0] - x[1]}), x[2], determinant < 0,
          std::abs(determinant) <= 1e-9 * m.col(0).cross(m.col(1)).norm()};
}

inline Eigen::Vector3d random_vector(CGAL::Random& random)
{
  return {random.get_double(-1, 1), random.get_double(-1, 1), random.get_double(-1, 1)};
}

// `n` long narrow triangles through the unit cube, from near one corner to near the opposite one.
inline Triangle_soup needles(const std::size_t n, const double width)
{
  CGAL::Random random(5);
  Triangle_soup soup;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Eigen::Vector3d a = 0.1 * random_vector(random);
    const Eigen::Vector3d b = Eigen::Vector3d::Ones() + 0.1 * random_vector(random);
    for(const Eigen::Vector3d& p : {a, b, Eigen::Vector3d(b + width * random_vector(random))})
      soup.points.push_back({{p[0], p[1], p[2]}});
    soup.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
  }
  return soup;
}

inline Triangle_soup joined(Triangle_soup a, const Triangle_soup& b)
{
  for(const auto& t : b.triangles)
    a.triangles.push_back(
      {{t[0] + a.points.size(), t[1] + a.points.size(), t[2] + a.points.size()}});
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  return a;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_SURFACE_WITH_RAYS_H
