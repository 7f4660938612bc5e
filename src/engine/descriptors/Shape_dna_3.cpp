// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shape_spectrum.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Shape_dna_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {

Eigen::VectorXd Shape_dna_3::operator()(const Point_matrix& points, const Face_list& polygons) const
{
  const internal::Shape_spectrum spectrum(points, polygons, EIGENVALUES);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(EIGENVALUES); // small meshes have fewer
  for(Eigen::Index k = 0; k < spectrum.eigenvalues().size(); ++k)
    result[k] = spectrum.eigenvalues()[k] / (4 * CGAL_PI * static_cast<double>(k + 1));
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
