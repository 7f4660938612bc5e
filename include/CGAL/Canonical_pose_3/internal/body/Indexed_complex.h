// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_BODY_INDEXED_COMPLEX_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_BODY_INDEXED_COMPLEX_H

#include <CGAL/Canonical_pose_3/Tetrahedral_complex_traits_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A complex in indexed form: row i corresponds to the i-th vertex of the range of the traits.
template <class Vertex_descriptor>
struct Indexed_complex
{
  std::vector<Vertex_descriptor> vertices;
  Point_matrix points;
  std::vector<std::array<int, 4>> cells;
};

// Whether `Tetrahedral_complex_traits_3` is specialized for T.
template <class T, class = void>
struct Is_tetrahedral_complex : std::false_type
{};

template <class T>
struct Is_tetrahedral_complex<
  T, typename Make_void<typename Tetrahedral_complex_traits_3<T>::Vertex_descriptor>::type>
  : std::true_type
{};

template <class Complex>
using Complex_point = typename Tetrahedral_complex_traits_3<Complex>::Point_3;

template <class Complex, class Traits>
auto indexed_complex(const Complex& complex, const Traits& traits)
{
  using Complex_traits = Tetrahedral_complex_traits_3<Complex>;
  using Vertex_descriptor = typename Complex_traits::Vertex_descriptor;

  Indexed_complex<Vertex_descriptor> result;
  std::unordered_map<Vertex_descriptor, int> row;
  for(const Vertex_descriptor v : Complex_traits::vertices(complex))
  {
    row.emplace(v, static_cast<int>(result.vertices.size()));
    result.vertices.push_back(v);
  }
  result.points.resize(static_cast<Eigen::Index>(result.vertices.size()), 3);
  for(std::size_t i = 0; i < result.vertices.size(); ++i)
    result.points.row(static_cast<Eigen::Index>(i))
      = to_row(traits, Complex_traits::point(complex, result.vertices[i])).transpose();

  for(const auto& cell : Complex_traits::cells(complex))
  {
    std::array<int, 4> rows;
    for(int k = 0; k < 4; ++k)
    {
      const auto found = row.find(static_cast<Vertex_descriptor>(cell[k]));
      if(found == row.end())
        throw std::invalid_argument("cell " + std::to_string(result.cells.size())
                                    + " names a vertex that the complex does not have");
      rows[k] = found->second;
    }
    for(int k = 0; k < 4; ++k)
      if(std::count(rows.begin(), rows.end(), rows[k]) > 1)
        throw std::invalid_argument("cell " + std::to_string(result.cells.size())
                                    + " names a vertex twice");
    result.cells.push_back(rows);
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_BODY_INDEXED_COMPLEX_H
