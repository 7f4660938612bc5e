// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Unfolded_sides.h"
#include "Wavefront.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#endif

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

class Wavefront_solver final : public Distance_solver
{
public:
  explicit Wavefront_solver(const Delaunay_surface& surface)
    : m_exponent(surface.exponent()), m_sides(surface.triangulation())
  {}

  Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Constant(
      size(), static_cast<Eigen::Index>(sources.size()), std::numeric_limits<double>::infinity());
    const auto fill = [&](Wavefront& wave, std::size_t k) {
      Eigen::VectorXd column = unreached();
      wave.lower(static_cast<int>(sources[k]), column);
      result.col(static_cast<Eigen::Index>(k)) = scaled(column, m_exponent);
    };
#ifdef CGAL_LINKED_WITH_TBB
    // waves keep no state: results do not depend on which thread runs which wave
    tbb::enumerable_thread_specific<Wavefront> waves([this] { return wavefront(); });
    for_each_index(sources.size(), [&](std::size_t k) { fill(waves.local(), k); });
#else
    Wavefront wave = wavefront();
    for(std::size_t k = 0; k < sources.size(); ++k)
      fill(wave, k);
#endif
    return result;
  }

  Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::VectorXd nearest = unreached();
    wavefront().lower(std::vector<int>(sources.begin(), sources.end()), nearest);
    return scaled(nearest, m_exponent);
  }

private:
  Wavefront wavefront() const { return Wavefront(m_sides); }

  Eigen::VectorXd unreached() const
  {
    return Eigen::VectorXd::Constant(size(), std::numeric_limits<double>::infinity());
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(m_sides.number_of_vertices()); }

  static Eigen::VectorXd scaled(Eigen::VectorXd values, const int exponent)
  {
    multiply_by_power_of_two(values, exponent);
    return values;
  }

  int m_exponent; // distances are multiplied by 2 to this power
  Unfolded_sides m_sides;
};

std::unique_ptr<Distance_solver> make_wavefront_solver(const Face_corners& corners,
                                                       const Point_matrix& points)
{
  return std::make_unique<Wavefront_solver>(Delaunay_surface(corners, points));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
