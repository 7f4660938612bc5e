// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_SOLVER_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_SOLVER_H

#include <CGAL/Canonical_pose_3/internal/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/Sparse_factor.h>
#include <CGAL/Canonical_pose_3/internal/cotangent_operators.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws when no face has an area. A face counts as flat when rounding alone explains its height.
inline void check_some_area(const Face_corners& corners, const Point_matrix& points)
{
  if(corners.origins.empty())
    throw std::invalid_argument("the mesh is empty: it has no face");
  for(std::size_t h = 0; h < corners.origins.size(); h += 3)
  {
    const Eigen::Vector3d a = points.row(corners.origins[h]);
    const Eigen::Vector3d side = points.row(corners.origins[h + 1]).transpose() - a;
    const Eigen::Vector3d other = points.row(corners.origins[h + 2]).transpose() - a;
    const double longest
      = (std::max)({side.squaredNorm(), other.squaredNorm(), (side - other).squaredNorm()});
    if(side.cross(other).norm() > 1e-13 * longest)
      return;
  }
  throw std::invalid_argument("face 0 is degenerate, and so are all the others");
}

// The connected components of the vertices, numbered in the order of their first vertices.
class Vertex_components
{
public:
  explicit Vertex_components(const Intrinsic_triangulation& triangulation)
    : m_component(triangulation.number_of_vertices())
  {
    std::vector<int> parent(m_component.size());
    for(std::size_t i = 0; i < parent.size(); ++i)
      parent[i] = static_cast<int>(i);
    const auto root = [&parent](int i) {
      for(auto k = static_cast<std::size_t>(i); parent[k] != i; k = static_cast<std::size_t>(i))
        i = parent[k] = parent[static_cast<std::size_t>(parent[k])];
      return i;
    };
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    {
      const int i = root(triangulation.origin(h)), j = root(triangulation.target(h));
      parent[static_cast<std::size_t>((std::max)(i, j))] = (std::min)(i, j);
    }
    for(std::size_t i = 0; i < parent.size(); ++i)
    {
      const int r = root(static_cast<int>(i));
      if(r == static_cast<int>(i))
        m_first_vertices.push_back(r);
      m_component[i]
        = r == static_cast<int>(i) ? size() - 1 : m_component[static_cast<std::size_t>(r)];
    }
  }

  int size() const { return static_cast<int>(m_first_vertices.size()); }
  const std::vector<int>& of_vertices() const { return m_component; }
  int operator[](Eigen::Index vertex) const
  {
    return m_component[static_cast<std::size_t>(vertex)];
  }
  const std::vector<int>& first_vertices() const { return m_first_vertices; }

private:
  std::vector<int> m_component;
  std::vector<int> m_first_vertices;
};

// Length of the longest of the shortest paths along edges from the first vertex of each component.
// No two vertices of the component are farther apart on the surface than twice this number.
inline std::vector<double> edge_graph_radii(const Intrinsic_triangulation& triangulation,
                                            const Vertex_components& components)
{
  const std::size_t n = triangulation.number_of_vertices();
  std::vector<std::vector<std::pair<int, double>>> neighbors(n);
  for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(triangulation.is_edge_representative(h))
    {
      const int i = triangulation.origin(h), j = triangulation.target(h);
      neighbors[static_cast<std::size_t>(i)].emplace_back(j, triangulation.length(h));
      neighbors[static_cast<std::size_t>(j)].emplace_back(i, triangulation.length(h));
    }
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<double> distances(n, (std::numeric_limits<double>::infinity)());
  for(int v : components.first_vertices())
  {
    distances[static_cast<std::size_t>(v)] = 0;
    queue.emplace(0., v);
  }
  std::vector<double> radii(static_cast<std::size_t>(components.size()), 0.);
  while(!queue.empty())
  {
    const auto [distance, v] = queue.top();
    queue.pop();
    if(distance > distances[static_cast<std::size_t>(v)])
      continue;
    radii[static_cast<std::size_t>(components[v])] = distance; // settled in increasing order
    for(const auto& [w, length] : neighbors[static_cast<std::size_t>(v)])
      if(distance + length < distances[static_cast<std::size_t>(w)])
      {
        distances[static_cast<std::size_t>(w)] = distance + length;
        queue.emplace(distance + length, w);
      }
  }
  return radii;
}

// The heat method on an intrinsic Delaunay triangulation: heat spreads for a short time from the
// source, and the distance is the function whose gradient follows the directions of descent of the
// heat.
//
// Both matrices are block diagonal over the components of the mesh, and each component has a time
// step of its own, h^2. h is the mean edge length, but at least 1/300 of the radius of the edge
// graph: the heat decays at most like exp(-d/h), which a double cannot hold beyond d/h = 708 or so,
// and no two vertices are then farther apart than 600 h.
template <class FactorTraits>
class Heat_solver
{
public:
  Heat_solver(const Face_corners& corners, Point_matrix points)
    : m_exponent(normalize(points)), m_triangulation(triangulation(corners, points)),
      m_components(m_triangulation)
  {
    m_triangulation.mollify(m_components.of_vertices(), m_components.size());
    m_triangulation.flip_to_delaunay();
    m_field = Gradient_field(m_triangulation);
    Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(m_triangulation);
    const Eigen::SparseMatrix<double> heat = heat_matrix(laplacian);
    m_heat_diagonal = heat.diagonal();
    m_heat.factor(heat, "the matrix of the heat equation");
    pin(laplacian);
    m_poisson.factor(laplacian, "the matrix of the Poisson equation");
  }

  const Intrinsic_triangulation& intrinsic_triangulation() const { return m_triangulation; }

  // One column per source (a row of the points): n distances in the unit of the input.
  Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const
  {
    const auto count = static_cast<Eigen::Index>(sources.size());
    Eigen::MatrixXd result(m_heat_diagonal.size(), count);
    for(Eigen::Index first = 0; first < count; first += BLOCK_WIDTH)
    {
      const Eigen::Index width = (std::min)(BLOCK_WIDTH, count - first);
      result.middleCols(first, width) = block(sources.data() + first, width);
    }
    return result;
  }

private:
  static constexpr Eigen::Index BLOCK_WIDTH = 16; // bounds the memory in use; changes no byte

  Intrinsic_triangulation triangulation(const Face_corners& corners, const Point_matrix& points)
  {
    check_some_area(corners, points);
    std::vector<double> lengths = side_lengths(corners, points);
    const int exponent = std::ilogb(
      Eigen::Map<const Eigen::VectorXd>(lengths.data(), static_cast<Eigen::Index>(lengths.size()))
        .mean());
    for(double& length : lengths)
      length = std::ldexp(length, -exponent);
    m_exponent += exponent;
    return {static_cast<std::size_t>(points.rows()), corners.origins, corners.twins,
            std::move(lengths)};
  }

  // M + diag(t) L: symmetric, since t is constant on a component, and positive definite. A vertex
  // without face, which has neither mass nor neighbors, gets a 1.
  Eigen::SparseMatrix<double> heat_matrix(const Eigen::SparseMatrix<double>& laplacian) const
  {
    const auto means
      = m_triangulation.mean_edge_lengths(m_components.of_vertices(), m_components.size());
    const auto radii = edge_graph_radii(m_triangulation, m_components);
    const Eigen::VectorXd mass = lumped_mass(m_triangulation);
    Eigen::SparseMatrix<double> matrix = laplacian;
    for(Eigen::Index i = 0; i < matrix.cols(); ++i)
    {
      const auto c = static_cast<std::size_t>(m_components[i]);
      const double h = (std::max)(means[c], radii[c] / 300);
      for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, i); it; ++it)
        it.valueRef() *= h * h;
      matrix.coeffRef(i, i) += mass[i] > 0 ? mass[i] : 1.;
    }
    return matrix;
  }

  // Adds a positive number to one diagonal entry per component. This makes the matrix definite and
  // leaves the solution alone: summed over the component, the equations say that the number times
  // the value there is the sum of the right-hand side, which is 0 for a divergence.
  void pin(Eigen::SparseMatrix<double>& laplacian) const
  {
    for(int v : m_components.first_vertices())
    {
      double& entry = laplacian.coeffRef(v, v);
      entry += entry > 0 ? entry : 1.;
    }
  }

  Eigen::MatrixXd block(const Eigen::Index* sources, Eigen::Index width) const
  {
    Eigen::MatrixXd impulses = Eigen::MatrixXd::Zero(m_heat_diagonal.size(), width);
    for(Eigen::Index k = 0; k < width; ++k)
      impulses(sources[k], k) = m_heat_diagonal[sources[k]]; // heat of order 1 at the source
    Eigen::MatrixXd columns = m_heat.solve(impulses);
    for_each_column(width, [&](Eigen::Index k) {
      columns.col(k) = m_field.divergence_of_unit_descent(columns.col(k));
    });
    columns = m_poisson.solve(columns);
    for_each_column(width, [&](Eigen::Index k) { finish(sources[k], columns.col(k)); });
    return columns;
  }

  // From a potential to distances: 0 at the source, infinite on other components.
  void finish(Eigen::Index source, Eigen::Ref<Eigen::VectorXd> column) const
  {
    const double offset = column[source];
    for(Eigen::Index i = 0; i < column.size(); ++i)
      column[i] = m_components[i] == m_components[source]
                    ? std::ldexp((std::max)(column[i] - offset, 0.), m_exponent)
                    : (std::numeric_limits<double>::infinity)();
  }

  template <class Function>
  static void for_each_column(Eigen::Index width, const Function& function)
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(Eigen::Index(0), width, function);
#else
    for(Eigen::Index k = 0; k < width; ++k)
      function(k);
#endif
  }

  int m_exponent; // distances are multiplied by 2 to this power
  Intrinsic_triangulation m_triangulation;
  Vertex_components m_components;
  Gradient_field m_field;
  Eigen::VectorXd m_heat_diagonal;
  Sparse_factor<FactorTraits> m_heat;
  Sparse_factor<FactorTraits> m_poisson;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_HEAT_SOLVER_H
