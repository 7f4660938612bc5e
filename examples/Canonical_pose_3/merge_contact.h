// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXAMPLES_MERGE_CONTACT_H
#define CGAL_CANONICAL_POSE_3_EXAMPLES_MERGE_CONTACT_H

// False contacts, as in scans: parts that touch become one surface.

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

namespace Canonical_pose_examples {

namespace detail {

using Triangles = std::vector<std::array<std::size_t, 3>>;

/// The vertices around a disc, in the order of its faces, which are removed from `triangles`: those
/// with a vertex within `radius` of `center`, connected to it.
inline std::vector<std::size_t> cut_disc(const std::vector<std::array<double, 3>>& points,
                                         const std::size_t center, const double radius,
                                         Triangles& triangles)
{
  const auto position = [&](const std::size_t v) { return Eigen::Vector3d(points[v].data()); };
  const auto is_near
    = [&](const std::size_t v) { return (position(v) - position(center)).norm() <= radius; };
  std::vector<bool> is_inside(points.size(), false);
  is_inside[center] = true;
  for(bool grows = true; grows;)
  {
    grows = false;
    for(const auto& t : triangles)
      if(is_inside[t[0]] || is_inside[t[1]] || is_inside[t[2]])
        for(const std::size_t v : t)
          if(!is_inside[v] && is_near(v))
            grows = is_inside[v] = true;
  }
  std::map<std::size_t, std::size_t> next;
  std::size_t number_of_edges = 0;
  const auto is_cut = [&](const std::array<std::size_t, 3>& t) {
    if(!is_inside[t[0]] && !is_inside[t[1]] && !is_inside[t[2]])
      return false;
    for(std::size_t k = 0; k < 3; ++k)
      if(!is_inside[t[k]] && !is_inside[t[(k + 1) % 3]])
      {
        next[t[k]] = t[(k + 1) % 3];
        ++number_of_edges;
      }
    return true;
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), is_cut), triangles.end());
  std::vector<std::size_t> border;
  if(!next.empty())
    for(std::size_t v = next.begin()->first; border.empty() || v != border.front(); v = next.at(v))
      border.push_back(v);
  if(border.size() < 3 || border.size() != number_of_edges)
    throw std::invalid_argument("the faces around a contact are not a disc");
  return border;
}

} // namespace detail

/*!
The triangles of a closed surface after parts of it that touch became one: the discs of the given
radius around two vertices are replaced by a tube. This adds a handle. The vertices inside the discs
become isolated, so that vertices with and without contact correspond by number.
*/
inline detail::Triangles merge_contact(const std::vector<std::array<double, 3>>& points,
                                       detail::Triangles triangles, const std::size_t first,
                                       const std::size_t second, const double radius)
{
  const std::vector<std::size_t> a = detail::cut_disc(points, first, radius, triangles);
  std::vector<std::size_t> b = detail::cut_disc(points, second, radius, triangles);
  const auto distance = [&](const std::size_t v, const std::size_t w) {
    return (Eigen::Vector3d(points[v].data()) - Eigen::Vector3d(points[w].data())).norm();
  };
  std::reverse(b.begin(), b.end()); // the discs face each other
  const auto from_front = [&](const std::size_t v, const std::size_t w) {
    return distance(a.front(), v) < distance(a.front(), w);
  };
  std::rotate(b.begin(), std::min_element(b.begin(), b.end(), from_front), b.end());
  constexpr double never = (std::numeric_limits<double>::infinity)();
  for(std::size_t i = 0, j = 0; i < a.size() || j < b.size();)
  {
    const std::size_t v = a[i % a.size()], w = b[j % b.size()];
    const std::size_t after_v = a[(i + 1) % a.size()], after_w = b[(j + 1) % b.size()];
    if((i < a.size() ? distance(after_v, w) : never)
       < (j < b.size() ? distance(v, after_w) : never))
    {
      triangles.push_back({{v, after_v, w}});
      ++i;
    }
    else
    {
      triangles.push_back({{after_w, w, v}});
      ++j;
    }
  }
  return triangles;
}

} // namespace Canonical_pose_examples

#endif // CGAL_CANONICAL_POSE_3_EXAMPLES_MERGE_CONTACT_H
