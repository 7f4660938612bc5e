// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_HANDLE_CONSTRAINT_ADAPTOR_3_H
#define CGAL_CANONICAL_POSE_3_HANDLE_CONSTRAINT_ADAPTOR_3_H

#include <CGAL/Canonical_pose_3/Constraint_list_3.h>
#include <CGAL/Canonical_pose_3/internal/registration/difference_terms.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a vertex of the surface with a prescribed position.
*/
struct Handle_3
{
  std::size_t p = 0; ///< row of the vertex.
  /// prescribed position, in the unit of the mesh.
  Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
  double stiffness = 1; ///< \f$ \kappa \f$, dimensionless. Positive.
};

namespace internal {

template <>
struct Constraint_element_traits<Handle_3>
{
  static constexpr const char* name = "handle";

  static std::array<std::size_t*, 1> pointers_to_vertices(Handle_3& handle)
  {
    return {{&handle.p}};
  }

  static std::string defect(const Handle_3& handle)
  {
    return (handle.position.cwiseAbs().array() <= LARGEST_LENGTH).all()
             ? ""
             : "has a position that is not finite or too large";
  }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief pulls vertices toward prescribed positions during a registration.

The energy of handle \f$ s \f$ with the position \f$ x_s \f$ is \f$ \frac{1}{2} \kappa_s |p_s -
x_s|^2 \f$. Since it is quadratic, each iteration finds its minimum for given rotations of the
cells.

\cgalModels `RegistrationConstraint_3`

\sa `Tetrahedral_arap_registrar_3::add_constraint()`
*/
class Handle_constraint_adaptor_3 : public Constraint_list_3<Handle_3>
{
public:
  using Constraint_list_3<Handle_3>::Constraint_list_3;

  /// changes the position of a handle. The matrix does not change.
  /// \pre `index < elements().size()`
  /// \throws std::invalid_argument if `position` is not finite.
  void set_position(const std::size_t index, const Eigen::RowVector3d& position)
  {
    Handle_3 handle = element(index);
    handle.position = position;
    replace(index, handle);
  }

  /// \name Requirements of `RegistrationConstraint_3`
  /// @{

  /// appends \f$ \frac{1}{2} \kappa_s \f$ to the diagonal.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    internal::add_difference_matrix(elements(), matrix);
  }

  /// adds \f$ \frac{1}{2} \kappa_s x_s \f$ to row \f$ p_s \f$.
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side) const
  {
    internal::add_difference_right_hand_side(
      elements(), internal::given(elements(), &Handle_3::position), points, right_hand_side);
  }

  /// returns the energy at `points`, in the squared unit of the mesh.
  double energy(const Point_matrix& points) const
  {
    return internal::difference_energy(elements(), internal::given(elements(), &Handle_3::position),
                                       points);
  }

  /// @}
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_HANDLE_CONSTRAINT_ADAPTOR_3_H
