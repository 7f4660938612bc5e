// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H
#define CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H

#include <CGAL/Canonical_pose_3/Constraint_list_3.h>
#include <CGAL/Canonical_pose_3/internal/registration/difference_terms.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <Eigen/SparseCore>

#include <cstddef>
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
  std::size_t q = 0;      ///< row of the second vertex, different from the first.
  double rest_length = 0; ///< prescribed distance, in the unit of the mesh. Not negative.
  double stiffness = 1;   ///< \f$ \kappa \f$, dimensionless. Positive.
};

namespace internal {

template <>
struct Constraint_element_traits<Spring_3> : Vertex_pair_traits
{
  static constexpr const char* name = "spring";

  struct State
  {
    Eigen::RowVector3d direction = Eigen::RowVector3d::UnitX(); // of the last iteration
  };

  static std::string defect(const Spring_3& spring)
  {
    return spring.rest_length >= 0 && spring.rest_length <= LARGEST_LENGTH
             ? coincidence_of_vertices(spring)
             : "has a rest length that is negative, not finite or too large";
  }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief adds springs between pairs of vertices to a registration, as in Section 7 of
\cgalCite{cgal:canonical-s-sdacm-15}, using the splitting of
\cgalCite{cgal:canonical-lbok-fsmss-13}.

The energy of spring \f$ s \f$ is \f$ \frac{1}{2} \kappa_s (|p_s - q_s| - r_s)^2 \f$. Each iteration
replaces the square by \f$ |p - q - d|^2 \f$, where \f$ d \f$ has the length \f$ r \f$ and the
direction of \f$ p - q \f$ before the iteration. If \f$ p \f$ and \f$ q \f$ coincide, the last
direction is used (the first axis if there is none, for instance after the vertices of a spring have
been replaced). With \f$ n \f$ vertices, the stiffness of Equation 16 of the paper is \f$ n \kappa
\f$ if all matching weights are \f$ 1/n \f$.

\cgalModels `RegistrationConstraint_3`

\sa `Tetrahedral_arap_registrar_3::add_constraint()`
*/
class Spring_constraint_adaptor_3 : public Constraint_list_3<Spring_3>
{
public:
  using Constraint_list_3<Spring_3>::Constraint_list_3;

  /// changes the rest length of a spring. The matrix does not change.
  /// \pre `index < elements().size()`
  /// \throws std::invalid_argument if `rest_length` is negative or not finite.
  void set_rest_length(const std::size_t index, const double rest_length)
  {
    Spring_3 spring = element(index);
    spring.rest_length = rest_length;
    replace(index, spring);
  }

  /// \name Requirements of `RegistrationConstraint_3`
  /// @{

  /// appends the entries of \f$ \frac{1}{2} \sum_s \kappa_s b_s b_s^t \f$, where
  /// \f$ b_s^t x = p_s - q_s \f$.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    internal::add_difference_matrix(elements(), matrix);
  }

  /// adds \f$ \frac{1}{2} \sum_s \kappa_s b_s d_s^t \f$ for the directions at `points` (\f$ n
  /// \times 3 \f$).
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side)
  {
    const auto prescribed = [&](const std::size_t i, const Eigen::RowVector3d& difference) {
      state(i).direction = direction(difference, state(i).direction);
      return Eigen::RowVector3d(element(i).rest_length * state(i).direction);
    };
    internal::add_difference_right_hand_side(elements(), prescribed, points, right_hand_side);
  }

  /// returns the energy at `points`, in the squared unit of the mesh.
  double energy(const Point_matrix& points) const
  {
    const auto prescribed = [&](const std::size_t i, const Eigen::RowVector3d& difference) {
      return Eigen::RowVector3d(element(i).rest_length
                                * direction(difference, Eigen::RowVector3d::UnitX()));
    };
    return internal::difference_energy(elements(), prescribed, points);
  }

  /// @}

private:
  // `otherwise`, if the difference is zero.
  static Eigen::RowVector3d direction(const Eigen::RowVector3d& difference,
                                      const Eigen::RowVector3d& otherwise)
  {
    const double length = difference.stableNorm();
    return length > 0 ? Eigen::RowVector3d(difference / length) : otherwise;
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SPRING_CONSTRAINT_ADAPTOR_3_H
