// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_TREE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_TREE_H

#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Finds the nearest triangle. Flat ones are ignored: a point near one of them is as near to its
// neighbors.
class Triangle_tree
{
public:
  // Throws `std::invalid_argument` if no triangle has an area.
  Triangle_tree(Point_matrix points, const std::vector<Index_triangle>& triangles)
    : m_exponent(normalize(points))
  {
    const auto row = [&](const std::size_t v) -> Eigen::RowVector3d {
      return points.row(static_cast<Eigen::Index>(v));
    };
    for(std::size_t i = 0; i < triangles.size(); ++i)
    {
      const Index_triangle& t = triangles[i];
      if(has_area(points, t))
        m_triangles.push_back(
          {Kernel::Triangle_3(point(row(t[0])), point(row(t[1])), point(row(t[2]))), i});
    }
    if(m_triangles.empty())
      throw std::invalid_argument("no triangle of the surface has an area");
    m_tree->insert(m_triangles.begin(), m_triangles.end());
    m_tree->build();
  }
  Triangle_tree(Triangle_tree&&) = default;
  Triangle_tree& operator=(Triangle_tree&&) = default;

  // A point in the unit of the tree, near enough that squares do not overflow.
  Eigen::RowVector3d normalized(const Eigen::RowVector3d& row) const
  {
    return row.unaryExpr([this](const double x) {
      return (std::max)(-FARTHEST, (std::min)(std::ldexp(x, -m_exponent), FARTHEST));
    });
  }

  // A point on a triangle.
  struct Location
  {
    std::size_t triangle;
    Eigen::Vector3d coordinates; // barycentric
  };

  // The location nearest to a point, given in the unit of the tree.
  Location nearest(const Eigen::RowVector3d& normalized_point) const
  {
    const auto [closest, found] = m_tree->closest_point_and_primitive(point(normalized_point));
    const auto vector = [&, p = closest](const Kernel::Point_3& q) {
      return Eigen::Vector3d(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
    };
    const Kernel::Triangle_3& t = found->triangle;
    const Eigen::Vector3d a = vector(t[1]) - vector(t[0]), b = vector(t[2]) - vector(t[0]);
    const Eigen::Vector3d rest = b - a.dot(b) / a.squaredNorm() * a; // orthogonal to a
    const double y = -vector(t[0]).dot(rest) / rest.squaredNorm();
    const double x = (-vector(t[0]) - y * b).dot(a) / a.squaredNorm();
    return {found->index, Eigen::Vector3d(1 - x - y, x, y)};
  }

  // The distance of a point from the nearest triangle, both in the unit of the input.
  double distance(const Eigen::RowVector3d& row) const
  {
    return std::ldexp(std::sqrt(m_tree->squared_distance(point(normalized(row)))), m_exponent);
  }

  // How often the triangles, if they form a closed surface, surround a point, given in the unit of
  // the input: a ray leaves the surface so much more often than it enters.
  int winding_number(const Eigen::RowVector3d& row) const
  {
    const Kernel::Vector_3 direction(0.5373, 0.4877, 0.6883); // parallel to no usual face
    std::vector<const Surface_triangle*> crossed;
    m_tree->all_intersected_primitives(Kernel::Ray_3(point(normalized(row)), direction),
                                       std::back_inserter(crossed));
    int result = 0;
    for(const Surface_triangle* const found : crossed)
    {
      const Kernel::Triangle_3& t = found->triangle;
      result += CGAL::cross_product(t[1] - t[0], t[2] - t[0]) * direction > 0 ? 1 : -1;
    }
    return result;
  }

private:
  using Kernel = Simple_cartesian<double>;

  static constexpr double FARTHEST = 1e100; // relative to the size of the surface

  static Kernel::Point_3 point(const Eigen::RowVector3d& row)
  {
    return Kernel::Point_3(row[0], row[1], row[2]);
  }

  struct Surface_triangle
  {
    Kernel::Triangle_3 triangle;
    std::size_t index;
  };

  struct Triangle_primitive
  {
    using Id = const Surface_triangle*;
    using Point = Kernel::Point_3;
    using Datum = Kernel::Triangle_3;

    Triangle_primitive() = default;
    explicit Triangle_primitive(const std::vector<Surface_triangle>::const_iterator triangle)
      : m_triangle(&*triangle)
    {}
    Id id() const { return m_triangle; }
    const Datum& datum() const { return m_triangle->triangle; }
    const Point& reference_point() const { return m_triangle->triangle.vertex(0); }

    Id m_triangle = nullptr;
  };
#if CGAL_VERSION_NR >= 1060000000
  using Tree = AABB_tree<AABB_traits_3<Kernel, Triangle_primitive>>;
#else
  using Tree = AABB_tree<AABB_traits<Kernel, Triangle_primitive>>;
#endif

  int m_exponent; // points were divided by this power of two
  std::vector<Surface_triangle> m_triangles;
  std::unique_ptr<Tree> m_tree = std::make_unique<Tree>(); // which cannot be moved
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_TREE_H
