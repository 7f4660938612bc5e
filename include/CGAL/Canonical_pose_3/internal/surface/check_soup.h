// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CHECK_SOUP_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CHECK_SOUP_H

#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws `std::invalid_argument` if an element (a triangle, a polygon, a tetrahedron) names a vertex
// that is not one of n. `name`: what messages call the element.
template <class Elements>
void check_elements(const Elements& elements, const std::size_t n,
                    const std::string& name = "triangle")
{
  for(std::size_t i = 0; i < elements.size(); ++i)
    for(const std::size_t v : elements[i])
      if(v >= n)
        throw std::invalid_argument(name + ' ' + std::to_string(i) + " names vertex "
                                    + std::to_string(v) + ", but there are " + std::to_string(n));
}

// Throws `std::invalid_argument` if powers of lengths could overflow or underflow.
inline void check_unit(const Point_matrix& points)
{
  constexpr double smallest = 1 / LARGEST_LENGTH, largest = LARGEST_LENGTH;
  const double size = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  if(size > largest || (size > 0 && size < smallest))
  {
    std::ostringstream message;
    message << "the largest coordinate is " << size << ", but must be between " << smallest
            << " and " << largest << ": choose another unit";
    throw std::invalid_argument(message.str());
  }
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_CHECK_SOUP_H
