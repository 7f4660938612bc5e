// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FUZZ_MUTATED_SOUP_H
#define CGAL_CANONICAL_POSE_3_FUZZ_MUTATED_SOUP_H

#include "Byte_source.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Canonical_pose_fuzz {

/// A procedural shape whose faces and coordinates are modified by the bytes.
class Mutated_soup
{
public:
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> polygons;

  explicit Mutated_soup(Byte_source& bytes)
  {
    append_shape(bytes.byte());
    for(std::size_t n = bytes.below(MOST_MUTATIONS); n > 0; --n)
      bytes.byte() % 2 == 0 ? mutate_faces(bytes) : mutate_points(bytes);
  }

private:
  static constexpr std::size_t MOST_MUTATIONS = 20, MOST_VERTICES = 60;

  void append_shape(const std::uint8_t kind)
  {
    using namespace Canonical_pose_test;
    switch(kind % 8)
    {
    case 0:
      return append(icosphere_soup(0, 1));
    case 1:
      return append(icosphere_soup(1, 1));
    case 2:
      return append(torus_soup(8, 5, 1, 0.4));
    case 3:
      return append(tube_soup(8, 5, 4, 0.3));
    case 4:
      return append(tube_soup(20, 3, 20, 0.1));
    case 5:
      return append(plane_grid_soup(5, 4, 5, 4));
    case 6:
      return append(boundary(tetrahedral_bent_bar(6, 1, 1, 2)));
    default:
      return append(boundary(tetrahedral_box(1, 1, 1)));
    }
  }

  void append(const Canonical_pose_test::Triangle_soup& soup)
  {
    const std::size_t offset = points.size();
    if(offset + soup.points.size() > MOST_VERTICES + 2)
      return;
    for(const auto& p : soup.points)
      points.push_back({{p[0] + 0.7 * double(offset), p[1], p[2]}});
    for(const auto& t : soup.triangles)
      polygons.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }

  void mutate_faces(Byte_source& bytes)
  {
    const std::size_t f = bytes.below(polygons.size()), v = bytes.below(points.size());
    switch(polygons.empty() ? 4 : bytes.below(8))
    {
    case 0:
      polygons.erase(polygons.begin() + std::ptrdiff_t(f));
      break;
    case 1:
      polygons.push_back(std::vector<std::size_t>(polygons[f]));
      break;
    case 2:
      std::reverse(polygons[f].begin(), polygons[f].end());
      break;
    case 3:
      if(!polygons[f].empty())
        polygons[f][bytes.below(polygons[f].size())] = v;
      break;
    case 4:
      polygons.emplace_back();
      for(std::size_t k = bytes.below(9); k > 0; --k)
        polygons.back().push_back(bytes.below(points.size()));
      break;
    case 5:
      polygons[f].push_back(v);
      break;
    case 6:
      polygons[f].push_back(points.size() + bytes.byte());
      break;
    default:
      append_shape(bytes.byte());
    }
  }

  void mutate_points(Byte_source& bytes)
  {
    const std::size_t v = bytes.below(points.size()), w = bytes.below(points.size());
    const std::size_t axis = bytes.below(3);
    switch(bytes.below(8))
    {
    case 0:
      points[v] = points[w];
      break;
    case 1:
      points[v][axis] = (points[v][axis] + points[w][axis]) / 2;
      break;
    case 2:
      points[v][axis] += (bytes.byte() - 127.5) / 64;
      break;
    case 3:
      points[v][axis] = bytes.special_number();
      break;
    case 4:
      scale(std::ldexp(1, 8 * (bytes.byte() - 128)));
      break;
    case 5:
      for(auto& p : points)
        p[axis] = 0;
      break;
    case 6:
      for(auto& p : points)
        p[axis] += std::ldexp(1, bytes.byte() / 4);
      break;
    default:
      points.push_back(points[v]);
    }
  }

  void scale(const double factor)
  {
    for(auto& p : points)
      for(double& x : p)
        x *= factor;
  }
};

} // namespace Canonical_pose_fuzz

#endif // CGAL_CANONICAL_POSE_3_FUZZ_MUTATED_SOUP_H
