// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_NEAREST_POINTS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_NEAREST_POINTS_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;

/// Finds the nearest of points.
class Nearest_points
{
public:
  explicit Nearest_points(const Point_matrix& points)
  {
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      m_points.emplace_back(points(i, 0), points(i, 1), points(i, 2));
    std::vector<std::size_t> indices(m_points.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    m_map = CGAL::make_property_map(m_points);
    m_tree.emplace(indices.begin(), indices.end(), typename Search::Splitter(), Traits(m_map));
    m_tree->build();
  }
  Nearest_points(const Nearest_points&) = delete;
  Nearest_points& operator=(const Nearest_points&) = delete;

  /// Returns the rows of the `number` points that are nearest to a position, the nearest first.
  std::vector<std::size_t> find(const Eigen::RowVector3d& position, const unsigned number) const
  {
    const Search search(*m_tree, Kernel::Point_3(position[0], position[1], position[2]), number, 0,
                        true, Search::Distance(m_map));
    std::vector<std::size_t> result;
    for(const auto& [index, squared_distance] : search)
      result.push_back(index);
    return result;
  }

  /// Returns the row of the nearest point of each position.
  std::vector<std::size_t> find(const Point_matrix& positions) const
  {
    std::vector<std::size_t> result;
    for(Eigen::Index i = 0; i < positions.rows(); ++i)
      result.push_back(find(positions.row(i), 1).front());
    return result;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Map = CGAL::Pointer_property_map<Kernel::Point_3>::type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

  std::vector<Kernel::Point_3> m_points;
  Map m_map;
  std::optional<Search::Tree> m_tree;
};

/// Some rows of a matrix.
template <class Matrix>
Matrix rows_of(const Matrix& matrix, const std::vector<std::size_t>& rows)
{
  return matrix(rows, Eigen::all);
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_NEAREST_POINTS_H
