// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_HEAT_GRADIENT_FIELD_H
#define CANONICAL_POSE_3_ENGINE_HEAT_GRADIENT_FIELD_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A face in the plane with corners at (0,0), (base,0), (x,y).
struct Face_in_plane
{
  std::array<int, 3> corners;
  double base, x, y;
};

// Adds to `result` the integrals over all faces of the products of the gradients of the hat
// functions and the field -grad u / |grad u|. Faces with constant u contribute nothing.
struct Unit_descent
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const Face_in_plane* faces, std::size_t size,
                                                const double* u, double* result)
  {
    using Numbers = typename Vector::Numbers;
    for(const Face_in_plane* face = faces; face != faces + size; ++face)
      for(std::size_t p = 0; p < NUMBER_OF_PARTS<Vector>; ++p)
      {
        std::array<std::size_t, 3> at;
        for(std::size_t i = 0; i < 3; ++i)
          at[i] = static_cast<std::size_t>(face->corners[i]);
        const Numbers origin = part<Vector>(u, at[0], p).numbers;
        const Numbers a = part<Vector>(u, at[1], p).numbers - origin;
        const Numbers b = part<Vector>(u, at[2], p).numbers - origin;
        // twice the area times the gradient
        Numbers along = a * face->y, across = b * face->base - a * face->x;
        normalize<Vector>(along, across);
        const Numbers second = across * face->x - along * face->y, third = across * -face->base;
        part<Vector>(result, at[0], p).numbers -= second + third;
        part<Vector>(result, at[1], p).numbers += second;
        part<Vector>(result, at[2], p).numbers += third;
      }
  }

private:
  // Scales a vector to length 1/2, unless it is 0.
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void normalize(typename Vector::Numbers& x,
                                                      typename Vector::Numbers& y)
  {
    using Numbers = typename Vector::Numbers;
    using Bits = typename Vector::Bits;
    // Far from the source, squares underflow, but the numbers do not: scale by a power of two
    // first.
    const Numbers size_x = x < 0 ? -x : x, size_y = y < 0 ? -y : y;
    const Numbers largest = size_x < size_y ? size_y : size_x;
    Bits bits;
    std::memcpy(&bits, &largest, sizeof(bits));
    bits = (2046ULL << 52) - (bits & (2047ULL << 52));
    Numbers scale;
    std::memcpy(&scale, &bits, sizeof(bits));
    x *= scale;
    y *= scale;
    // The inverse square root: half the exponent, and four Newton steps from an error of 4 percent.
    const Numbers square = x * x + y * y, half = 0.5 * square;
    std::memcpy(&bits, &square, sizeof(bits));
    bits = 0x5fe6eb50c7b537a9ULL - (bits >> 1);
    Numbers root;
    std::memcpy(&root, &bits, sizeof(bits));
    for(int step = 0; step < 4; ++step)
      root *= 1.5 - half * root * root;
    root *= 0.5;
    x *= root;
    y *= root;
  }
};

// The descent direction of functions on the faces, and its divergence.
class Gradient_field
{
public:
  Gradient_field() = default;

  explicit Gradient_field(const Intrinsic_triangulation& triangulation)
  {
    m_faces.reserve(static_cast<std::size_t>(triangulation.number_of_faces()));
    for(const int h : first_halfedges(triangulation))
    {
      const auto [x, y] = triangulation.apex(h);
      m_faces.push_back(
        {{triangulation.origin(h), triangulation.origin(h + 1), triangulation.origin(h + 2)},
         triangulation.length(h),
         x,
         y});
    }
  }

  // Turns functions u into the right-hand sides L phi = b of the functions phi whose gradients are
  // closest to -grad u / |grad u|, L being the cotangent Laplacian. b is minus the integrated
  // divergence, and sums to 0 over each component. `result` must be 0.
  void divergence_of_unit_descent(const Lane_rows& u, Lane_rows& result) const
  {
    run_routine<Unit_descent>(m_faces.data(), m_faces.size(), u.data(), result.data());
  }

private:
  // Faces in the order of their smallest vertices, for locality of memory access.
  static std::vector<int> first_halfedges(const Intrinsic_triangulation& triangulation)
  {
    const auto smallest = [&](int h) {
      return static_cast<std::size_t>((std::min)(
        {triangulation.origin(h), triangulation.origin(h + 1), triangulation.origin(h + 2)}));
    };
    return Buckets<int>(triangulation.number_of_vertices(),
                        [&](const auto& put) {
                          for(int h = 0; h < triangulation.number_of_halfedges(); h += 3)
                            put(smallest(h), h);
                        })
      .values();
  }

  std::vector<Face_in_plane> m_faces;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_HEAT_GRADIENT_FIELD_H
