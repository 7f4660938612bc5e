// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Global_system.h"
#include "Quasi_newton_direction.h"
#include "Taubin_fairing.h"
#include "../energy/Arap_energy.h"
#include "../injective/Injective_repair.h"
#include "../linear_algebra/transposed_product.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>

#include <CGAL/Real_timer.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Energies; local and global steps.
class Body_registration final : public Arap_registration
{
public:
  Body_registration(const Body_view& body, const Eigen::VectorXd& matching_weights,
                    const double length_scale, const Registration_options& options,
                    const Eigen::VectorXd& stiffness, const Rotation_routines& rotations,
                    const Factor_maker factor_maker)
    : m_body(body), m_length_scale(checked_length_scale(length_scale)), m_options(options),
      m_weights(checked_matching_weights(body, matching_weights)),
      m_arap(body.points() / length_scale, body.cells(), body.cell_weights(),
             checked_stiffness(stiffness, body.cells().size()), rotations),
      m_factor_maker(factor_maker), m_system(m_body, factor_maker)
  {
    m_options.check();
    if(m_options.fairing_passes > 0)
      m_fairing.emplace(body.points(), body.cells());
  }

  const Registration_options& options() const override { return m_options; }

  void set_options(const Registration_options& options) override
  {
    options.check();
    CANONICAL_POSE_3_PRECONDITION(m_fairing || options.fairing_passes == 0);
    const bool changes_matrix
      = options.detail_length != m_options.detail_length || options.tikhonov != m_options.tikhonov;
    m_options = options;
    if(changes_matrix)
      m_system.forget_matrix();
  }

  void set_number_of_iterations(const int number_of_iterations) override
  {
    CANONICAL_POSE_3_PRECONDITION(number_of_iterations >= 0);
    m_options.number_of_iterations = number_of_iterations;
  }

  void set_detail_length(const double detail_length) override
  {
    Registration_options options = m_options;
    options.detail_length = detail_length;
    set_options(options);
  }

  void add_constraint(std::unique_ptr<Registration_constraint_base> constraint) override
  {
    m_system.add(std::move(constraint));
  }

  void remove_constraint(const void* const constraint) override { m_system.remove(constraint); }

  void set_target(const Point_matrix& target) override
  {
    CANONICAL_POSE_3_PRECONDITION(target.rows() == m_weights.size());
    check_finite(target);
    if(m_unfolding)
      m_system.forget_matrix();
    m_unfolding.reset();
    m_target = target / m_length_scale;
    transposed_product(m_body.embedding(), m_weights.asDiagonal() * m_target, m_target_term);
  }

  void set_unfolding(const Unfolding& unfolding) override
  {
    unfolding.check();
    check_that_body_is_connected(m_body);
    if(!m_unfolding)
      m_system.forget_matrix();
    m_unfolding = unfolding;
  }

  void factor() override
  {
    m_system.factor([this] { return assemble_matrix(); });
  }

  Registration_summary register_to_target(Point_matrix& body_points,
                                          const Registration_visitor& visitor,
                                          Best_pose* const best) override
  {
    CANONICAL_POSE_3_PRECONDITION(m_unfolding || m_target.rows() == m_weights.size());
    CANONICAL_POSE_3_PRECONDITION(body_points.rows() == 0
                                  || body_points.rows() == m_body.points().rows());
    Registration_summary summary;
    summary.solver = m_system.name();
    for(const char* stage : {"factorization", "local_steps", "global_steps"})
      summary.add_seconds(stage, 0);
    summary.body.vertices = static_cast<std::size_t>(m_body.points().rows());
    summary.body.tetrahedra = m_body.cells().size();
    timed(summary, "factorization", [&] { factor(); });

    Point_matrix v;
    timed(summary, "global_steps", [&] {
      v = body_points.rows() == 0 ? start() : Point_matrix(body_points / m_length_scale);
    });
    timed(summary, "local_steps", [&] { evaluate(v, summary); });
    summary.energy_history.push_back(summary.energy);
    Best_pose own{m_options.detail_length};
    iterate(v, body_points.rows() > 0, visitor, best != nullptr ? *best : own, summary);
    if(summary.termination == Registration_summary::CANCELED && own.energy < summary.energy)
    {
      v = own.points / m_length_scale;
      timed(summary, "local_steps", [&] { evaluate(v, summary); });
    }
    if(m_options.is_injective() && summary.is_usable() && summary.inverted > 0)
      repair(v, summary);
    if(summary.is_usable())
      body_points = v * m_length_scale;
    return summary;
  }

  void untangle(Point_matrix& body_points, Registration_summary& summary) override
  {
    if(summary.inverted == 0)
      return;
    Point_matrix v = body_points / m_length_scale;
    timed(summary, "local_steps", [&] { evaluate(v, summary); });
    repair(v, summary);
    if(summary.is_usable())
      body_points = v * m_length_scale;
  }

  Point_matrix surface_points(const Point_matrix& body_points) const override
  {
    CANONICAL_POSE_3_PRECONDITION(body_points.rows() == m_body.points().rows());
    return m_body.embedding() * body_points;
  }

private:
  template <class Function>
  static void timed(Registration_summary& summary, const char* stage, const Function& f)
  {
    Real_timer timer;
    timer.start();
    f();
    summary.add_seconds(stage, timer.time());
  }

  // The weight of the term that holds an iterate near the previous one. Without a target, it makes
  // the matrix positive definite: the other terms do not depend on translations, so it holds the
  // centroid. It is small compared to the smallest other eigenvalues of the matrix, which are at
  // least about pi^2 l^2 (those of a bar), and hardly slows down the convergence.
  double proximal_weight() const
  {
    constexpr double fraction = 0.05;
    return m_options.tikhonov
           + (m_unfolding ? fraction * m_options.detail_length * m_options.detail_length : 0);
  }

  // The matrix without constraints.
  Eigen::SparseMatrix<double> assemble_matrix() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(Eigen::Index i = 0; i < m_weights.size(); ++i)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i),
                           ((m_unfolding ? 0 : 1) + proximal_weight()) * m_weights[i]);
    return m_arap.matrix(m_options.detail_length * m_options.detail_length)
           + m_system.brought_to_body(m_system.surface_matrix(entries));
  }

  // Where the iteration starts if no positions are given.
  Point_matrix start() const
  {
    if(m_unfolding)
      return m_body.points() / m_length_scale;
    Point_matrix right_hand_side = (1 + m_options.tikhonov) * m_target_term;
    if(m_system.has_constraints())
    {
      Point_matrix points = surface_points(m_body.points());
      for(Eigen::Index i = 0; i < m_weights.size(); ++i)
        if(m_weights[i] > 0)
          points.row(i) = m_target.row(i) * m_length_scale;
      Point_matrix term;
      transposed_product(m_body.embedding(), m_system.constraint_terms(points) / m_length_scale,
                         term);
      right_hand_side += term;
    }
    Eigen::MatrixXd solution;
    m_system.solve(right_hand_side, solution);
    Point_matrix v = solution;
    for(Eigen::Index i = 0; i < m_weights.size(); ++i)
      if(m_weights[i] > 0)
      {
        Eigen::SparseMatrix<double>::InnerIterator entry(m_system.embedding_transposed(), i);
        const Eigen::Index vertex = entry.row();
        if(entry.value() == 1 && !++entry)
          v.row(vertex) = m_target.row(i);
      }
    return v;
  }

  // Local step: computes surface, rotations and energies at v.
  void evaluate(const Point_matrix& v, Registration_summary& summary)
  {
    transposed_product(m_system.embedding_transposed(), v, m_surface);
    const auto arap = m_arap.fit_rotations(v);
    summary.energy_match
      = m_unfolding ? -m_unfolding->weight
                        * m_weights.dot((m_surface.rowwise() - centroid()).rowwise().norm())
                    : ((m_surface - m_target).array().square().colwise() * m_weights.array()).sum();
    summary.energy_arap = m_options.detail_length * m_options.detail_length * arap.energy;
    summary.energy_constraints
      = m_system.has_constraints()
          ? m_system.constraint_energy(m_surface * m_length_scale, m_length_scale)
          : 0;
    summary.energy = summary.energy_match + summary.energy_arap + summary.energy_constraints;
    summary.inverted = arap.inverted;
    summary.volume_ratio = arap.volume_ratio;
  }

  // Returns the right-hand side for the surface and rotations of the last local step, minus the
  // left-hand side terms of the constraints.
  const Point_matrix& right_hand_side()
  {
    find_surface_terms();
    m_arap.add_to_right_hand_side(m_options.detail_length * m_options.detail_length,
                                  m_right_hand_side);
    return m_right_hand_side;
  }

  // Of the surface of the last local step.
  Eigen::RowVector3d centroid() const { return m_weights.transpose() * m_surface; }

  // Half the negative gradient of the unfolding term with respect to the surface. The term is
  // concave, so its linearization is an upper bound.
  Point_matrix half_growth() const
  {
    Point_matrix directions = m_surface.rowwise() - centroid();
    for(Eigen::Index i = 0; i < directions.rows(); ++i)
    {
      const double norm = directions.row(i).norm();
      if(norm > 0)
        directions.row(i) /= norm;
    }
    const Eigen::RowVector3d mean = m_weights.transpose() * directions;
    return m_unfolding->weight / 2 * (m_weights.asDiagonal() * (directions.rowwise() - mean));
  }

  // Computes the terms that do not depend on rotations.
  void find_surface_terms()
  {
    if(m_unfolding)
      transposed_product(m_body.embedding(), half_growth(), m_right_hand_side);
    else
      m_right_hand_side = m_target_term;
    if(proximal_weight() > 0 || m_system.has_constraints())
    {
      const Point_matrix points = m_surface * m_length_scale;
      Point_matrix sum = m_system.constraint_terms(points), term;
      sum -= m_system.constraint_matrix() * points;
      transposed_product(
        m_body.embedding(),
        proximal_weight() * (m_weights.asDiagonal() * m_surface) + sum / m_length_scale, term);
      m_right_hand_side += term;
    }
  }

  // Computes half the gradient of the energy at v, the position of the last local step.
  void half_gradient(const Point_matrix& v, Point_matrix& result)
  {
    transposed_product(m_system.matrix(), v, result); // the matrix is symmetric
    result -= right_hand_side();
  }

  // Untangles inverted cells, starting from the last local step. `start`: see `Injective_repair`.
  Injective_repair::Outcome untangled(Point_matrix& v, const Injective_repair::Start& start)
  {
    find_surface_terms();
    Eigen::SparseMatrix<double> matrix = m_system.matrix();
    Point_matrix right_hand_side = m_right_hand_side;
    if(m_system.has_constraints()) // they are part of the left-hand side
    {
      const Eigen::SparseMatrix<double> constraints
        = m_system.brought_to_body(m_system.constraint_matrix());
      matrix += constraints;
      right_hand_side += constraints * v;
    }
    const Injective_repair repair(m_arap, m_options.detail_length * m_options.detail_length, matrix,
                                  m_factor_maker);
    return repair(right_hand_side, start, v);
  }

  // The pose of a stiffer body without inverted cells, if there is one. `v`: where it starts.
  std::optional<Point_matrix> stiffer_pose(Point_matrix v, Registration_summary& summary)
  {
    constexpr int most = 3;
    constexpr double factor_of_detail_length = 2;
    const Registration_options options = m_options;
    std::optional<Point_matrix> result;
    for(int i = 0; i < most && !result; ++i)
    {
      set_detail_length((std::min)(factor_of_detail_length * m_options.detail_length,
                                   Registration_options::LARGEST_DETAIL_LENGTH));
      factor();
      Registration_summary of_stiffer;
      Best_pose best{m_options.detail_length};
      evaluate(v, of_stiffer);
      iterate(v, true, {}, best, of_stiffer);
      summary.iterations += of_stiffer.iterations;
      if(!of_stiffer.is_usable())
        break;
      if(of_stiffer.inverted > 0)
      {
        untangled(v, [] { return std::nullopt; });
        evaluate(v, of_stiffer);
      }
      if(of_stiffer.inverted == 0)
        result = v;
    }
    set_options(options);
    factor();
    return result;
  }

  // Untangles inverted cells, starting from the last local step: at last from the pose of a stiffer
  // body, or from the rest pose.
  void repair(Point_matrix& v, Registration_summary& summary)
  {
    timed(summary, "global_steps", [&] {
      bool is_from_rest = false;
      const Point_matrix registered = v;
      const auto outcome = untangled(v, [&] {
        std::optional<Point_matrix> start = stiffer_pose(registered, summary);
        if(!start)
        {
          is_from_rest = true;
          start = m_body.points() / m_length_scale;
        }
        return start;
      });
      if(!outcome.is_minimal && summary.converged())
        summary.termination = Registration_summary::ITERATION_LIMIT;
      if(is_from_rest)
        summary.warnings.push_back("inverted cells resisted repair; vertices of the body that "
                                   "started anew from the rest pose: "
                                   + std::to_string(outcome.restarted_vertices));
    });
    timed(summary, "local_steps", [&] { evaluate(v, summary); });
    summary.energy_history.push_back(summary.energy);
    if(summary.inverted > 0)
      summary.warnings.push_back("inverted cells that remain, although there should be none: "
                                 + std::to_string(summary.inverted));
  }

  // Returns the largest displacement of a surface vertex if the body moves by `step`.
  double largest_move(const Eigen::MatrixXd& step) const
  {
    Point_matrix moves;
    transposed_product(m_system.embedding_transposed(), step, moves);
    return std::sqrt(moves.rowwise().squaredNorm().maxCoeff());
  }

  // Returns whether to continue after an iteration that moved the body by `step`.
  bool visit(const Registration_visitor& visitor, const Registration_summary& summary,
             const Eigen::MatrixXd& step) const
  {
    return !visitor
           || visitor({summary.iterations, summary.energy, summary.energy_match,
                       summary.energy_arap, summary.energy_constraints, largest_move(step), 0, 0});
  }

  // Keeps v, the position of the last local step, if it is better.
  void keep(const Point_matrix& v, const Registration_summary& summary, Best_pose& best) const
  {
    const double factor = best.detail_length / m_options.detail_length;
    const double energy
      = summary.energy_match + factor * factor * summary.energy_arap + summary.energy_constraints;
    if(!(energy < best.energy))
      return;
    best.energy = energy;
    best.points = v * m_length_scale;
  }

  void iterate(Point_matrix& v, const bool is_warm_start, const Registration_visitor& visitor,
               Best_pose& best, Registration_summary& summary)
  {
    if(visitor)
      keep(v, summary, best);
    const bool is_accelerated = !m_fairing && m_options.tikhonov == 0;
    Quasi_newton_direction direction(is_accelerated ? m_options.acceleration_window : 0);
    Eigen::MatrixXd step, solution;
    Point_matrix next, gradient, previous_gradient;
    const auto solve = [&](Eigen::MatrixXd& x) {
      m_system.solve(x, solution);
      x.swap(solution);
    };
    const auto plain_move = [&] { // in the last iteration
      if(!direction.has_memory())
        return largest_move(step);
      Eigen::MatrixXd plain_step = gradient;
      timed(summary, "global_steps", [&] { solve(plain_step); });
      return largest_move(plain_step);
    };
    bool is_small = false; // the last change of the energy
    summary.termination = Registration_summary::ITERATION_LIMIT;
    while(summary.iterations < m_options.number_of_iterations && std::isfinite(summary.energy))
    {
      if(m_fairing && (is_warm_start || summary.iterations > 0))
        timed(summary, "local_steps", [&] {
          m_arap.fit_rotations((*m_fairing)(v, m_options.fairing_passes, m_options.fairing_lambda,
                                            m_options.fairing_mu));
        });
      timed(summary, "global_steps", [&] {
        half_gradient(v, gradient);
        if(summary.iterations > 0)
          direction.remember(-step, gradient - previous_gradient);
        step = gradient;
        direction.apply(step, solve);
        next = v - step;
      });
      const double previous = summary.energy;
      timed(summary, "local_steps", [&] { evaluate(next, summary); });
      if(direction.has_memory()
         && !(summary.energy <= previous - 0.2 * gradient.cwiseProduct(step).sum()))
      {
        direction.forget();
        timed(summary, "global_steps", [&] {
          step = gradient;
          solve(step);
          next = v - step;
        });
        timed(summary, "local_steps", [&] { evaluate(next, summary); });
      }
      v.swap(next);
      ++summary.iterations;
      summary.energy_history.push_back(summary.energy);
      if(visitor)
        keep(v, summary, best);
      const bool goes_on = !std::isfinite(summary.energy) || visit(visitor, summary, step);
      const bool was_small = is_small;
      is_small = std::abs(previous - summary.energy)
                 <= m_options.energy_tolerance * (std::max)(std::abs(previous), 1e-15);
      if(is_small && (was_small || !direction.has_memory())
         && plain_move() <= m_options.move_tolerance)
      {
        summary.termination = Registration_summary::CONVERGED;
        return;
      }
      if(!goes_on)
      {
        summary.termination = Registration_summary::CANCELED;
        return;
      }
      gradient.swap(previous_gradient);
    }
    if(!std::isfinite(summary.energy))
      summary.termination = Registration_summary::NOT_FINITE;
  }

  Body_view m_body;
  double m_length_scale;
  Registration_options m_options;
  Eigen::VectorXd m_weights;
  Arap_energy m_arap;
  std::optional<Taubin_fairing> m_fairing;
  const Factor_maker m_factor_maker;
  Global_system m_system;
  Point_matrix m_target, m_target_term; // the target, and its term of the right-hand side
  std::optional<Unfolding> m_unfolding; // instead of the target
  Point_matrix m_surface, m_right_hand_side;
};

std::unique_ptr<Arap_registration>
make_arap_registration(const Body_view& body, const Eigen::VectorXd& matching_weights,
                       const double length_scale, const Registration_options& options,
                       const Eigen::VectorXd& stiffness, const Rotation_routines& rotations,
                       const Factor_maker factor_maker)
{
  return std::make_unique<Body_registration>(body, matching_weights, length_scale, options,
                                             stiffness, rotations, factor_maker);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
