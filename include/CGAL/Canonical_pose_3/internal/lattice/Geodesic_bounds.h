// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_GEODESIC_BOUNDS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_GEODESIC_BOUNDS_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Lower bounds of the geodesic distance between vertices by the triangle inequality: the largest
// difference of their distances to a landmark. The first landmarks, which are far apart, suffice.
class Geodesic_bounds
{
public:
  // `distances`: one row per vertex, one column per landmark; `unit`: the unit of the bounds.
  Geodesic_bounds(const Eigen::MatrixXd& distances, const double unit)
    : m_unit(unit), m_are_finite(distances.allFinite()), m_distances(used_part(distances, unit))
  {}

  // Replaces the vertices by those to which `map.interpolated()` maps values.
  template <class Map>
  void interpolate(const Map& map)
  {
    m_distances = map.interpolated(m_distances);
  }

  double unit() const { return m_unit; }

  // Whether all given distances are.
  bool are_finite() const { return m_are_finite; }

  // Appends the midpoint of each edge, whose endpoints may be such midpoints themselves; `points`:
  // all points, in the unit of the bounds. If a landmark is visible from both endpoints through
  // faces that unfold into a plane, its distance is the length of the median of a triangle.
  void add_middles(const std::vector<std::pair<std::size_t, std::size_t>>& edges,
                   const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& points)
  {
    Eigen::Index row = m_distances.rows();
    m_distances.conservativeResize(row + static_cast<Eigen::Index>(edges.size()), Eigen::NoChange);
    for(const auto& edge : edges)
    {
      const auto v = static_cast<Eigen::Index>(edge.first),
                 w = static_cast<Eigen::Index>(edge.second);
      const double squared_length = (points.row(v) - points.row(w)).squaredNorm();
      const Eigen::ArrayXd a = m_distances.row(v).transpose().cast<double>().array(),
                           b = m_distances.row(w).transpose().cast<double>().array();
      const Eigen::ArrayXd squares
        = (2 * (a.square() + b.square()) - squared_length).max((a - b).square());
      m_distances.row(row++) = (squares.sqrt() / 2).matrix().transpose().cast<float>();
    }
  }

  double operator()(const std::size_t v, const std::size_t w) const
  {
    return (m_distances.row(static_cast<Eigen::Index>(v))
            - m_distances.row(static_cast<Eigen::Index>(w)))
      .cwiseAbs()
      .maxCoeff();
  }

private:
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static constexpr Eigen::Index NUMBER_OF_LANDMARKS = 32;

  static Rows used_part(const Eigen::MatrixXd& distances, const double unit)
  {
    return (distances.leftCols((std::min)(distances.cols(), NUMBER_OF_LANDMARKS)) / unit)
      .cast<float>();
  }

  double m_unit;
  bool m_are_finite;
  Rows m_distances;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LATTICE_GEODESIC_BOUNDS_H
