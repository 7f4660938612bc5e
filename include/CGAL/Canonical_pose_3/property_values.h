// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PROPERTY_VALUES_H
#define CGAL_CANONICAL_POSE_3_PROPERTY_VALUES_H

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <iterator>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief reads one number per element from a property map, in the order of a range, for
`Options::matching_weights` and `Options::stiffness`.

For a mesh, the range is `vertices(tmesh)`. For a tetrahedral complex, vertices and cells are in the
order of its `Tetrahedral_complex_traits_3`; for a complex of Mesh_3, for instance, the cells are in
the order of `c3t3.cells_in_complex()`.

\tparam Range a range of keys of the map, or of iterators that convert to them
\tparam PropertyMap a model of `ReadablePropertyMap` with numbers as values

<em>Complexity:</em> linear.
*/
template <class Range, class PropertyMap>
Eigen::VectorXd property_values(const Range& range, PropertyMap map)
{
  using Key = typename boost::property_traits<PropertyMap>::key_type;
  Eigen::VectorXd values(static_cast<Eigen::Index>(std::distance(range.begin(), range.end())));
  Eigen::Index i = 0;
  for(const auto& element : range)
    values[i++] = CGAL::to_double(get(map, Key(element)));
  return values;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_PROPERTY_VALUES_H
