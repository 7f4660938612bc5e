// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SUPPORT_POINT_SEARCH_H
#define CANONICAL_POSE_3_ENGINE_SUPPORT_POINT_SEARCH_H

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Finds the nearest of points.
class Point_search
{
public:
  explicit Point_search(const Point_matrix& points)
  {
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      m_points.push_back(point(points, i));
    std::vector<std::size_t> indices(m_points.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    m_map = Map(m_points.data());
    m_tree.emplace(indices.begin(), indices.end(), Splitter(), Search_traits(m_map));
    m_tree->build();
  }
  Point_search(const Point_search&) = delete;
  Point_search& operator=(const Point_search&) = delete;

  // The `number` nearest ones of each row, the nearest first; all, if there are fewer.
  std::vector<std::vector<std::size_t>> nearest(const Point_matrix& queries,
                                                const std::size_t number) const
  {
    std::vector<std::vector<std::size_t>> result(static_cast<std::size_t>(queries.rows()));
    for_each_block(
      result.size(),
      [&](std::size_t, const std::size_t begin, const std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
        {
          const Search search(*m_tree, point(queries, static_cast<Eigen::Index>(i)),
                              static_cast<unsigned int>((std::min)(number, m_points.size())), 0,
                              true, Distance(m_map));
          for(const auto& [index, distance] : search)
            result[i].push_back(index);
        }
      },
      128);
    return result;
  }

  // Those within a distance of a row, in any order.
  std::vector<std::size_t> within(const double distance, const Eigen::RowVector3d& query) const
  {
    std::vector<std::size_t> result;
    m_tree->search(std::back_inserter(result),
                   Fuzzy_sphere<Search_traits>(Point(query[0], query[1], query[2]), distance, 0,
                                               Search_traits(m_map)));
    return result;
  }

private:
  using Point = Simple_cartesian<double>::Point_3;
  using Map = Pointer_property_map<Point>::const_type;
  using Plain_traits = Search_traits_3<Simple_cartesian<double>>;
  using Search_traits = Search_traits_adapter<std::size_t, Map, Plain_traits>;
  using Search = Orthogonal_k_neighbor_search<Search_traits>;
  using Distance = Search::Distance;
  using Splitter = Search::Tree::Splitter;

  static Point point(const Point_matrix& points, const Eigen::Index i)
  {
    return {points(i, 0), points(i, 1), points(i, 2)};
  }

  std::vector<Point> m_points;
  Map m_map;
  std::optional<Search::Tree> m_tree;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SUPPORT_POINT_SEARCH_H
