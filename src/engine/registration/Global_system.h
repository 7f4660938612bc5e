// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_REGISTRATION_GLOBAL_SYSTEM_H
#define CANONICAL_POSE_3_ENGINE_REGISTRATION_GLOBAL_SYSTEM_H

#include "../linear_algebra/Updated_factor.h"
#include "../linear_algebra/low_rank_factors.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The matrix of the global step, of the vertices of a body, with that of the constraints, which are on its surface,
// and the factor of their sum. Refers to the body.
class Global_system
{
public:
  Global_system(const Body_view& body, const Factor_maker factor_maker)
    : m_embedding(body.embedding()), m_embedding_transposed(m_embedding.transpose()),
      m_factor_maker(factor_maker), m_factor(factor_maker)
  {}

  const Eigen::SparseMatrix<double>& embedding_transposed() const { return m_embedding_transposed; }
  const char* name() const { return m_factor.name(); }
  bool has_constraints() const { return !m_constraints.empty(); }

  void add(std::unique_ptr<Registration_constraint_base> constraint)
  {
    m_constraints.push_back(std::move(constraint));
    m_factored_revisions.reset();
  }

  void remove(const void* const constraint)
  {
    const auto position = std::find_if(m_constraints.begin(), m_constraints.end(),
                                       [&](const auto& c) { return c->is_model_of(constraint); });
    CANONICAL_POSE_3_PRECONDITION(position != m_constraints.end());
    m_constraints.erase(position);
    m_factored_revisions.reset();
  }

  void forget_matrix()
  {
    m_matrix.resize(0, 0);
    m_factor = Updated_factor(m_factor_maker);
    m_factored_revisions.reset();
  }

  // Factors the matrix, unless that was done. `matrix()` returns it, without constraints.
  template <class Function>
  void factor(const Function& matrix)
  {
    std::vector<std::size_t> revisions;
    for(const auto& constraint : m_constraints)
      revisions.push_back(constraint->matrix_revision());
    if(m_factored_revisions == revisions)
      return;
    m_factored_revisions.reset();
    if(m_matrix.size() == 0)
      m_matrix = matrix();
    m_constraint_matrix = assemble_constraint_matrix();
    if(!m_factor.is_factored() || !update_factor())
    {
      m_factor.factor(m_constraints.empty() ? m_matrix
                                            : m_matrix + brought_to_body(m_constraint_matrix),
                      "the matrix of the registration");
      m_factored_constraint_matrix = m_constraint_matrix;
    }
    m_factored_revisions = revisions;
  }

  void solve(const Eigen::MatrixXd& right_hand_side, Eigen::MatrixXd& solution) const
  {
    m_factor.solve(right_hand_side, solution);
  }

  // Without constraints.
  const Eigen::SparseMatrix<double>& matrix() const { return m_matrix; }

  const Eigen::SparseMatrix<double>& constraint_matrix() const { return m_constraint_matrix; }

  // A matrix of vertices of the surface.
  Eigen::SparseMatrix<double>
  surface_matrix(const std::vector<Eigen::Triplet<double>>& entries) const
  {
    Eigen::SparseMatrix<double> result(m_embedding.rows(), m_embedding.rows());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::SparseMatrix<double> brought_to_body(const Eigen::SparseMatrix<double>& surface) const
  {
    const Eigen::SparseMatrix<double> surface_embedded = surface * m_embedding;
    return m_embedding_transposed * surface_embedded;
  }

  // The right-hand sides of the constraints.
  Point_matrix constraint_terms(const Point_matrix& points) const
  {
    Point_matrix result = Point_matrix::Zero(points.rows(), 3);
    for(const auto& constraint : m_constraints)
      constraint->add_to_right_hand_side(points, result);
    return result;
  }

  double constraint_energy(const Point_matrix& points, const double length_scale) const
  {
    double result = 0;
    for(const auto& constraint : m_constraints)
      result += constraint->energy(points) / (length_scale * length_scale);
    return result;
  }

private:
  // Beyond this rank, a factorization is cheaper than the solves for an update and the products
  // with it in all iterations of a registration (measured on the armadillo in a body of TetGen).
  static constexpr std::size_t MOST_RANK_OF_AN_UPDATE = 32;

  Eigen::SparseMatrix<double> assemble_constraint_matrix() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(const auto& constraint : m_constraints)
      constraint->add_to_matrix(entries);
    for(const Eigen::Triplet<double>& entry : entries)
      for(const Eigen::Index row : {entry.row(), entry.col()})
        if(row < 0 || row >= m_embedding.rows())
          throw std::invalid_argument("a constraint names surface vertex " + std::to_string(row)
                                      + ", but there are " + std::to_string(m_embedding.rows()));
    return surface_matrix(entries);
  }

  // Updates the factor by the difference between the constraints at its factorization and the
  // current ones. Returns false if a new factorization is cheaper or more accurate.
  bool update_factor()
  {
    const Eigen::SparseMatrix<double> change = m_constraint_matrix - m_factored_constraint_matrix;
    Eigen::SparseMatrix<double> v;
    Eigen::VectorXd d;
    const std::size_t most = MOST_RANK_OF_AN_UPDATE;
    return low_rank_factors(change, 2 * most, v, d) // a spring has two rows
           && d.size() <= static_cast<Eigen::Index>(most)
           && m_factor.update(m_embedding_transposed * v, d);
  }

  const Eigen::SparseMatrix<double>& m_embedding;
  Eigen::SparseMatrix<double> m_embedding_transposed;
  std::vector<std::unique_ptr<Registration_constraint_base>> m_constraints;
  std::optional<std::vector<std::size_t>> m_factored_revisions; // none: list of constraints changed
  Eigen::SparseMatrix<double> m_matrix;                         // without constraints
  // on the surface: current ones, and those in the factor without its update
  Eigen::SparseMatrix<double> m_constraint_matrix, m_factored_constraint_matrix;
  Factor_maker m_factor_maker;
  Updated_factor m_factor;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_REGISTRATION_GLOBAL_SYSTEM_H
