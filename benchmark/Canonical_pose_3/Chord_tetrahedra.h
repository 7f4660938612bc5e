// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

/// Finds where rays from the centroids of faces against their normals leave the shape: the first way out
/// that is not much farther by geodesics than straight on, as it is where limbs overlap.
class Chord_exits
{
public:
  using Triangles = std::vector<std::array<std::size_t, 3>>;

  /// `points` and `distances`: in units of the largest distance.
  Chord_exits(const CGAL::Canonical_pose_3::Point_matrix& points, const Triangles& triangles,
              const Triangles& caps, const Eigen::MatrixXd& distances)
    : m_triangles(triangles), m_distances(distances)
  {
    for(const Triangles* const soup : {&triangles, &caps})
      for(const auto& t : *soup)
      {
        std::array<Kernel::Point_3, 3> corners;
        for(std::size_t k = 0; k < 3; ++k)
        {
          const auto v = static_cast<Eigen::Index>(t[k]);
          corners[k] = Kernel::Point_3(points(v, 0), points(v, 1), points(v, 2));
        }
        m_faces.emplace_back(corners[0], corners[1], corners[2]);
      }
    m_tree.insert(m_faces.begin(), m_faces.end());
    m_tree.build();
  }
  Chord_exits(const Chord_exits&) = delete;
  Chord_exits& operator=(const Chord_exits&) = delete;

  /// Returns the face where the ray from `face` leaves the shape; none at a cap, or without a way out.
  std::optional<std::size_t> operator()(const std::size_t face) const
  {
    const std::vector<Way_out> ways = ways_out(face);
    if(ways.empty())
      return std::nullopt;
    const auto is_near = [&](const Way_out& way) {
      return geodesic_bound(face, way.second) <= 1.6 * way.first + 0.01;
    };
    const auto found = std::find_if(ways.begin(), ways.end(), is_near);
    const std::size_t exit = (found == ways.end() ? ways.front() : *found).second;
    return exit < m_triangles.size() ? std::make_optional(exit) : std::nullopt;
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Faces = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR >= 6
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Faces::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Faces::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif
  using Way_out = std::pair<double, std::size_t>; // distance and face

  // Along the ray, the nearest first.
  std::vector<Way_out> ways_out(const std::size_t face) const
  {
    const Kernel::Point_3 start
      = centroid(m_faces[face].vertex(0), m_faces[face].vertex(1), m_faces[face].vertex(2));
    const Kernel::Vector_3 inward = -normal(face);
    std::vector<Way_out> ways;
    if(inward == CGAL::NULL_VECTOR)
      return ways;
    std::vector<Faces::const_iterator> met;
    m_tree.all_intersected_primitives(Kernel::Ray_3(start, inward), std::back_inserter(met));
    for(const Faces::const_iterator hit : met)
    {
      const auto exit = static_cast<std::size_t>(hit - m_faces.begin());
      const double slope = normal(exit) * inward;
      if(exit != face && slope > 0)
        ways.emplace_back((hit->vertex(0) - start) * normal(exit) / slope
                            * std::sqrt(inward.squared_length()),
                          exit);
    }
    std::sort(ways.begin(), ways.end());
    return ways;
  }

  Kernel::Vector_3 normal(const std::size_t face) const
  {
    return CGAL::cross_product(m_faces[face].vertex(1) - m_faces[face].vertex(0),
                               m_faces[face].vertex(2) - m_faces[face].vertex(0));
  }

  // By the triangle inequality; 0 to a cap.
  double geodesic_bound(const std::size_t face, const std::size_t exit) const
  {
    if(exit >= m_triangles.size())
      return 0;
    return (m_distances.row(static_cast<Eigen::Index>(m_triangles[face][0]))
            - m_distances.row(static_cast<Eigen::Index>(m_triangles[exit][0])))
      .cwiseAbs()
      .maxCoeff();
  }

  const Triangles& m_triangles;
  const Eigen::MatrixXd m_distances;
  Faces m_faces; // and caps
  Tree m_tree;
};

/// Returns a body that requires no mesher: one tetrahedron per face, from the face to a vertex of
/// the face where the ray from its centroid against its normal leaves the shape. The tetrahedra
/// overlap; a face without such a vertex has none. Any oriented surface can be used.
///
/// `caps`: triangles that close the holes; `distances`: those to the landmarks; `unit`: the largest
/// of them. Rays do not stop at other limbs that they cross.
inline CGAL::Canonical_pose_3::Conforming_body_3
chord_tetrahedra(const CGAL::Canonical_pose_3::Point_matrix& points,
                 const std::vector<std::array<std::size_t, 3>>& triangles,
                 const std::vector<std::array<std::size_t, 3>>& caps,
                 const Eigen::MatrixXd& distances, const double unit)
{
  const CGAL::Canonical_pose_3::Point_matrix unit_points = points / unit;
  const Chord_exits exit_of(unit_points, triangles, caps, distances / unit);
  std::vector<std::array<int, 4>> cells;
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const std::optional<std::size_t> exit = exit_of(f);
    if(!exit)
      continue;
    const auto& t = triangles[f];
    const std::array<std::size_t, 4> corners = {t[0], t[1], t[2], triangles[*exit][0]};
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.row(k) = unit_points.row(static_cast<Eigen::Index>(corners[k + 1]))
                     - unit_points.row(static_cast<Eigen::Index>(corners[0]));
    if(std::abs(edges.determinant()) > 1e-15)
      cells.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                       static_cast<int>(corners[2]), static_cast<int>(corners[3])});
  }
  return CGAL::Canonical_pose_3::Conforming_body_3(points, std::move(cells),
                                                   static_cast<std::size_t>(points.rows()));
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H
