// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_FUNCTIONAL_MAP_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_FUNCTIONAL_MAP_H

#include "Laplacian_spectrum.h"
#include "Nearest_points.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// A match of surfaces by lengths on them alone, as a reference.

namespace Canonical_pose_benchmark {

/// What a functional map needs of a connected surface.
class Spectral_surface
{
public:
  static constexpr Eigen::Index NUMBER_OF_FUNCTIONS = 100;

  Spectral_surface(const Point_matrix& given_points,
                   const std::vector<std::array<std::size_t, 3>>& triangles)
    : points(given_points), coarse(coarse_copy(points, triangles)),
      spectrum(coarse.surface.points, coarse.surface.triangles, NUMBER_OF_FUNCTIONS)
  {}

  /// The heat-kernel signature of each coarse vertex at some times, relative to the trace of the
  /// kernel (J. Sun et al., "A concise and provably informative multi-scale signature", 2009).
  Eigen::MatrixXd heat_kernels(const Eigen::VectorXd& times) const
  {
    const Eigen::MatrixXd decays = (-spectrum.values * times.transpose()).array().exp();
    return spectrum.functions.cwiseAbs2() * decays
           * decays.colwise().sum().cwiseInverse().asDiagonal();
  }

  /// For each vertex, the coarse one to which it is nearest, roughly.
  std::vector<std::size_t> nearest_coarse_vertices() const
  {
    std::vector<std::size_t> result(coarse.number_of_surface_vertices());
    for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
      result[coarse.vertices[i]] = i;
    for(const auto& [vertex, others, weights] : coarse.combinations)
      result[vertex] = result[others[static_cast<std::size_t>(
        std::max_element(weights.begin(), weights.end()) - weights.begin())]];
    return result;
  }

  Point_matrix points;
  CGAL::Canonical_pose_3::Coarse_surface_3 coarse;
  Laplacian_spectrum spectrum; ///< of the coarse surface

private:
  static CGAL::Canonical_pose_3::Coarse_surface_3
  coarse_copy(const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    constexpr std::size_t number_of_vertices = 4000;
    CGAL::Canonical_pose_3::Surface_component_3 surface;
    surface.points = points;
    surface.triangles = triangles;
    surface.face_of_triangle.assign(triangles.size(), 0);
    surface.origins.assign(static_cast<std::size_t>(points.rows()), 0);
    return CGAL::Canonical_pose_3::coarse_surface(surface, number_of_vertices);
  }
};

/// A functional map (M. Ovsjanikov et al., "Functional maps: a flexible representation of maps
/// between shapes", 2012) that preserves heat-kernel signatures and commutes with the Laplacian, as
/// well as possible; refined by more and more functions (S. Melzi et al., "ZoomOut: spectral
/// upsampling for efficient shape correspondence", 2019). Lengths do not tell left from right.
class Functional_map
{
public:
  Functional_map(const Spectral_surface& a, const Spectral_surface& b) : m_a(a), m_b(b)
  {
    constexpr Eigen::Index first = 10, step = 5;
    constexpr std::size_t stride = 4; // few pairs suffice for the map
    const auto last = (std::min)(
      {Spectral_surface::NUMBER_OF_FUNCTIONS, a.spectrum.values.size(), b.spectrum.values.size()});
    std::vector<std::size_t> rows;
    for(std::size_t i = 0; i < a.coarse.vertices.size(); i += stride)
      rows.push_back(i);
    m_map = map_of_signatures((std::min)(first, last));
    for(Eigen::Index number = (std::min)(first, last); number < last;)
    {
      const std::vector<std::size_t> pairs = pairs_of(rows);
      number = (std::min)(last, number + step);
      m_map = rows_of(functions(m_a, number), rows)
                .householderQr()
                .solve(rows_of(functions(m_b, number), pairs));
    }
  }

  /// Returns the vertex of the second surface for each vertex of the first one.
  std::vector<std::size_t> vertices() const
  {
    constexpr unsigned number_of_candidates = 48;
    std::vector<std::size_t> all(m_a.coarse.vertices.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    const Nearest_points points_of_b(m_b.points);
    std::vector<std::vector<std::size_t>> candidates;
    for(const std::size_t j : pairs_of(all))
      candidates.push_back(points_of_b.find(
        m_b.coarse.surface.points.row(static_cast<Eigen::Index>(j)), number_of_candidates));
    const Rows features = m_a.coarse.interpolated(Rows(features_of_a())),
               others = m_b.coarse.interpolated(Rows(features_of_b()));
    std::vector<std::size_t> result;
    for(const std::size_t i : m_a.nearest_coarse_vertices())
    {
      const auto row = static_cast<Eigen::Index>(result.size());
      const auto distance = [&](const std::size_t j) {
        return (features.row(row) - others.row(static_cast<Eigen::Index>(j))).squaredNorm();
      };
      result.push_back(*std::min_element(
        candidates[i].begin(), candidates[i].end(),
        [&](const std::size_t j, const std::size_t k) { return distance(j) < distance(k); }));
    }
    return result;
  }

private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static Eigen::MatrixXd functions(const Spectral_surface& surface, const Eigen::Index number)
  {
    return surface.spectrum.functions.leftCols(number);
  }

  // Coefficients in functions of the first surface of those of the second one.
  Eigen::MatrixXd map_of_signatures(const Eigen::Index number) const
  {
    constexpr double weight = .01;
    constexpr Eigen::Index number_of_times = 100;
    const Eigen::VectorXd &values = m_a.spectrum.values, &values_of_b = m_b.spectrum.values;
    const double range = 4 * std::log(10.);
    const Eigen::VectorXd times
      = Eigen::VectorXd::LinSpaced(number_of_times, std::log(range / values[values.size() - 1]),
                                   std::log(range / values[1]))
          .array()
          .exp();
    const auto coefficients = [&](const Spectral_surface& surface) {
      const Eigen::MatrixXd result = functions(surface, number).transpose()
                                     * surface.spectrum.mass.asDiagonal()
                                     * surface.heat_kernels(times);
      return Eigen::MatrixXd(result / result.norm());
    };
    const Eigen::MatrixXd x = coefficients(m_b), y = coefficients(m_a);
    Eigen::MatrixXd result(number, number);
    for(Eigen::Index i = 0; i < number; ++i)
    {
      Eigen::MatrixXd matrix = x * x.transpose();
      matrix.diagonal() += weight
                           * ((values_of_b.head(number).array() - values[i]) / values[number - 1])
                               .square()
                               .matrix();
      matrix.diagonal().array() += 1e-9;
      result.row(i) = matrix.ldlt().solve(x * y.row(i).transpose()).transpose();
    }
    return result;
  }

  Eigen::MatrixXd features_of_a() const { return functions(m_a, m_map.rows()); }
  Eigen::MatrixXd features_of_b() const { return functions(m_b, m_map.cols()) * m_map.transpose(); }

  // For coarse vertices of the first surface, those of the second one with the nearest features.
  std::vector<std::size_t> pairs_of(const std::vector<std::size_t>& rows) const
  {
    const Eigen::MatrixXd others = features_of_b();
    Eigen::MatrixXd distances
      = -2 * others * rows_of(features_of_a(), rows).transpose(); // a column per row
    distances.colwise() += others.rowwise().squaredNorm();
    std::vector<std::size_t> result;
    for(Eigen::Index i = 0; i < distances.cols(); ++i)
    {
      Eigen::Index nearest;
      distances.col(i).minCoeff(&nearest);
      result.push_back(static_cast<std::size_t>(nearest));
    }
    return result;
  }

  const Spectral_surface &m_a, &m_b;
  Eigen::MatrixXd m_map;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_FUNCTIONAL_MAP_H
