// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H
#define CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a spring between two vertices of the surface.
*/
struct Spring_3
{
  std::size_t p = 0;      ///< row of the first vertex.
  std::size_t q = 0;      ///< row of the second vertex, another one.
  double rest_length = 0; ///< wished distance, in the unit of the mesh. Not negative.
  double stiffness = 1;   ///< \f$ \kappa \f$, without unit. Positive.
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief adds springs between pairs of vertices to a registration, as in Section 7 of
\cgalCite{cgal:canonical-s-sdacm-15} by the splitting of \cgalCite{cgal:canonical-lbok-fsmss-13}.

The energy of spring \f$ s \f$ is \f$ \frac{1}{2} \kappa_s (|p_s - q_s| - r_s)^2 \f$. In an
iteration \f$ |p - q - d|^2 \f$ takes the place of the square, \f$ d \f$ being of length \f$ r \f$
and in the direction of \f$ p - q \f$ before it. Where \f$ p \f$ and \f$ q \f$ coincide the last
direction stands (the first axis if there is none). With \f$ n \f$ vertices, the stiffness of
Equation 16 of the paper is \f$ n \kappa \f$, the matching weights being \f$ 1/n \f$ each.

\cgalModels `RegistrationConstraint_3`

\sa `Tetrahedral_arap_registrar_3::add_constraint()`
*/
class Spring_constraint_adaptor_3
{
public:
  /// constructs a constraint on a surface of `number_of_vertices` vertices, without springs.
  explicit Spring_constraint_adaptor_3(const std::size_t number_of_vertices)
    : m_number_of_vertices(number_of_vertices)
  {}

  /// adds a spring and returns its index. The matrix of the registrar will be factored anew.
  /// \throws std::invalid_argument if a vertex does not exist, both are the same, or a number is
  ///        out of its bounds.
  std::size_t insert(const Spring_3& spring)
  {
    const std::string name = "spring " + std::to_string(m_springs.size());
    for(const std::size_t v : {spring.p, spring.q})
      if(v >= m_number_of_vertices)
        throw std::invalid_argument(name + " names vertex " + std::to_string(v) + ", but there are "
                                    + std::to_string(m_number_of_vertices));
    if(spring.p == spring.q)
      throw std::invalid_argument(name + " joins vertex " + std::to_string(spring.p)
                                  + " to itself");
    if(!(spring.stiffness > 0) || !std::isfinite(spring.stiffness))
      throw std::invalid_argument(name + " has a stiffness that is not positive");
    check_rest_length(name, spring.rest_length);
    m_springs.push_back(spring);
    m_directions.push_back(Eigen::RowVector3d::UnitX());
    ++m_matrix_revision;
    return m_springs.size() - 1;
  }

  /// changes the rest length of a spring; no factorisation is needed.
  /// \throws std::invalid_argument if `rest_length` is negative or not finite.
  /// \pre `index < springs().size()`
  void set_rest_length(const std::size_t index, const double rest_length)
  {
    CGAL_precondition(index < m_springs.size());
    check_rest_length("spring " + std::to_string(index), rest_length);
    m_springs[index].rest_length = rest_length;
  }

  /// returns the springs.
  const std::vector<Spring_3>& springs() const { return m_springs; }

  /// \name Requirements of `RegistrationConstraint_3`
  /// @{

  /// returns a number that changes whenever the matrix does.
  std::size_t matrix_revision() const { return m_matrix_revision; }

  /// appends the entries of \f$ \frac{1}{2} \sum_s \kappa_s b_s b_s^t \f$.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    for(const Spring_3& s : m_springs)
    {
      const int p = static_cast<int>(s.p), q = static_cast<int>(s.q);
      const double k = s.stiffness / 2;
      matrix.emplace_back(p, p, k);
      matrix.emplace_back(q, q, k);
      matrix.emplace_back(p, q, -k);
      matrix.emplace_back(q, p, -k);
    }
  }

  /// adds \f$ \frac{1}{2} \sum_s \kappa_s b_s d_s^t \f$ for the directions at `points` (\f$ n
  /// \times 3 \f$).
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side)
  {
    for(std::size_t i = 0; i < m_springs.size(); ++i)
    {
      const Spring_3& s = m_springs[i];
      const Eigen::RowVector3d difference = points.row(s.p) - points.row(s.q);
      const double length = difference.stableNorm();
      if(length > 0)
        m_directions[i] = difference / length;
      const Eigen::RowVector3d d = s.stiffness / 2 * s.rest_length * m_directions[i];
      right_hand_side.row(s.p) += d;
      right_hand_side.row(s.q) -= d;
    }
  }

  /// returns the energy at `points`, in the squared unit of the mesh.
  double energy(const Point_matrix& points) const
  {
    double sum = 0;
    for(const Spring_3& s : m_springs)
    {
      const double excess = (points.row(s.p) - points.row(s.q)).stableNorm() - s.rest_length;
      sum += s.stiffness / 2 * excess * excess;
    }
    return sum;
  }

  /// @}

private:
  static void check_rest_length(const std::string& name, const double rest_length)
  {
    if(!(rest_length >= 0) || !std::isfinite(rest_length))
      throw std::invalid_argument(name + " has a rest length that is negative or not finite");
  }

  std::size_t m_number_of_vertices;
  std::size_t m_matrix_revision = 0;
  std::vector<Spring_3> m_springs;
  std::vector<Eigen::RowVector3d> m_directions;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H
