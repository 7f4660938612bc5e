// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_DIRECTION_CONSTRAINT_ADAPTOR_3_H
#define CGAL_CANONICAL_POSE_3_DIRECTION_CONSTRAINT_ADAPTOR_3_H

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

\brief is a pair of vertices of the surface with a prescribed vector from the second to the first.
*/
struct Directed_pair_3
{
  std::size_t p = 0; ///< row of the first vertex.
  std::size_t q = 0; ///< row of the second vertex, different from the first.
  /// prescribed \f$ p - q \f$, in the unit of the mesh.
  Eigen::RowVector3d vector = Eigen::RowVector3d::Zero();
  double stiffness = 1; ///< \f$ \kappa \f$, dimensionless. Positive.
};

namespace internal {

template <>
struct Constraint_element_traits<Directed_pair_3> : Vertex_pair_traits
{
  static constexpr const char* name = "direction";

  static std::string defect(const Directed_pair_3& pair)
  {
    return (pair.vector.cwiseAbs().array() <= LARGEST_LENGTH).all()
             ? coincidence_of_vertices(pair)
             : "has a vector that is not finite or too large";
  }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief prescribes the differences, both length and direction, of pairs of vertices during a
registration.

Limbs that point in given directions create a Vitruvian pose, the future work of
\cgalCite{cgal:canonical-s-sdacm-15}. The energy of pair \f$ s \f$ with the vector
\f$ d_s \f$ is \f$ \frac{1}{2} \kappa_s |p_s - q_s - d_s|^2 \f$. Since it is quadratic, each
iteration finds its minimum for given rotations of the cells.

\cgalModels `RegistrationConstraint_3`

\sa `Tetrahedral_arap_registrar_3::add_constraint()`
*/
class Direction_constraint_adaptor_3 : public Constraint_list_3<Directed_pair_3>
{
public:
  using Constraint_list_3<Directed_pair_3>::Constraint_list_3;

  /// changes the vector of a pair. The matrix does not change.
  /// \pre `index < elements().size()`
  /// \throws std::invalid_argument if `vector` is not finite.
  void set_vector(const std::size_t index, const Eigen::RowVector3d& vector)
  {
    Directed_pair_3 pair = element(index);
    pair.vector = vector;
    replace(index, pair);
  }

  /// \name Requirements of `RegistrationConstraint_3`
  /// @{

  /// appends the entries of \f$ \frac{1}{2} \sum_s \kappa_s b_s b_s^t \f$, where
  /// \f$ b_s^t x = p_s - q_s \f$.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    internal::add_difference_matrix(elements(), matrix);
  }

  /// adds \f$ \frac{1}{2} \sum_s \kappa_s b_s d_s^t \f$.
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side) const
  {
    internal::add_difference_right_hand_side(
      elements(), internal::given(elements(), &Directed_pair_3::vector), points, right_hand_side);
  }

  /// returns the energy at `points`, in the squared unit of the mesh.
  double energy(const Point_matrix& points) const
  {
    return internal::difference_energy(
      elements(), internal::given(elements(), &Directed_pair_3::vector), points);
  }

  /// @}
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIRECTION_CONSTRAINT_ADAPTOR_3_H
