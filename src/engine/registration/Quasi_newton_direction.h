// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_REGISTRATION_QUASI_NEWTON_DIRECTION_H
#define CANONICAL_POSE_3_ENGINE_REGISTRATION_QUASI_NEWTON_DIRECTION_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Descent directions by limited-memory BFGS. The initial Hessian matrix is a constant factored
// matrix, which is corrected by the last steps and the changes of the gradient along them.
class Quasi_newton_direction
{
public:
  // `window`: number of stored steps.
  explicit Quasi_newton_direction(const int window) : m_memory(window) {}

  bool has_memory() const { return m_used > 0; }

  void forget() { m_used = 0; }

  // Stores that the gradient changed by `change` along `step`.
  template <class Step, class Change>
  void remember(const Step& step, const Change& change)
  {
    const double curvature = step.cwiseProduct(change).sum();
    if(m_memory.empty() || !(curvature > 0))
      return;
    Pair& pair = m_memory[m_next];
    pair.step = step;
    pair.change = change;
    pair.curvature = curvature;
    m_next = (m_next + 1) % m_memory.size();
    m_used = (std::min)(m_used + 1, m_memory.size());
  }

  // Replaces the gradient, given in `direction`, by the direction to step against; `solve(x)` solves
  // for x in place.
  template <class Solve>
  void apply(Eigen::MatrixXd& direction, const Solve& solve) const
  {
    std::vector<double> weights(m_used);
    for(std::size_t k = 0; k < m_used; ++k) // starting with the newest
    {
      const Pair& pair = newest(k);
      weights[k] = pair.step.cwiseProduct(direction).sum() / pair.curvature;
      direction -= weights[k] * pair.change;
    }
    solve(direction);
    for(std::size_t k = m_used; k-- > 0;)
    {
      const Pair& pair = newest(k);
      direction
        += (weights[k] - pair.change.cwiseProduct(direction).sum() / pair.curvature) * pair.step;
    }
  }

private:
  struct Pair
  {
    Eigen::MatrixXd step, change;
    double curvature;
  };

  const Pair& newest(const std::size_t k) const
  {
    return m_memory[(m_next + m_memory.size() - 1 - k) % m_memory.size()];
  }

  std::vector<Pair> m_memory; // a ring buffer
  std::size_t m_next = 0, m_used = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_REGISTRATION_QUASI_NEWTON_DIRECTION_H
