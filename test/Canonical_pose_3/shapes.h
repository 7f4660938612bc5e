// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_SHAPES_H
#define CGAL_CANONICAL_POSE_3_TEST_SHAPES_H

// Procedural fixtures. Each shape exists as indexed arrays (`..._soup`, in double precision,
// without CGAL types) and as a mesh (`name<Mesh>(...)`, any model of MutableFaceGraph over any
// kernel, vertices in the order of the array).

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Canonical_pose_test {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;
using Cells = std::vector<std::array<std::size_t, 4>>;

struct Triangle_soup
{
  Points points;
  Triangles triangles;
};
struct Tetrahedral_soup
{
  Points points;
  Cells cells;
};

constexpr double pi = 3.14159265358979323846;

/// Mesh with the given vertices, in their order, and faces; throws if they are not a 2-manifold.
template <class Mesh>
Mesh to_mesh(const Points& points, const Triangles& triangles)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

  Mesh mesh;
  auto point_map = get(CGAL::vertex_point, mesh);
  std::vector<Vertex> vertices;
  vertices.reserve(points.size());
  for(const auto& p : points)
  {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  for(const auto& t : triangles)
  {
    const std::array<Vertex, 3> face = {{vertices[t[0]], vertices[t[1]], vertices[t[2]]}};
    if(CGAL::Euler::add_face(face, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::invalid_argument("the triangles are not a 2-manifold");
  }
  return mesh;
}

template <class Mesh>
Mesh to_mesh(const Triangle_soup& soup)
{
  return to_mesh<Mesh>(soup.points, soup.triangles);
}

/// The points under a function from `std::array<double, 3>` to the same.
template <class Function>
Points transformed(Points points, const Function& function)
{
  for(auto& p : points)
    p = function(p);
  return points;
}

/// `nx` x `ny` rectangles, each split by its rising diagonal, over [0,width] x [0,height], z = 0.
inline Triangle_soup plane_grid_soup(std::size_t nx, std::size_t ny, double width, double height)
{
  Triangle_soup soup;
  for(std::size_t j = 0; j <= ny; ++j)
    for(std::size_t i = 0; i <= nx; ++i)
      soup.points.push_back(
        {{width * double(i) / double(nx), height * double(j) / double(ny), 0.}});
  for(std::size_t j = 0; j < ny; ++j)
    for(std::size_t i = 0; i < nx; ++i)
    {
      const std::size_t a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      soup.triangles.push_back({{a, b, c}});
      soup.triangles.push_back({{a, c, d}});
    }
  return soup;
}

template <class Mesh>
Mesh plane_grid(std::size_t nx, std::size_t ny, double width, double height)
{
  return to_mesh<Mesh>(plane_grid_soup(nx, ny, width, height));
}

/// `nx` x `ny` unit squares, an open strip when `ny` is small.
template <class Mesh>
Mesh strip(std::size_t nx, std::size_t ny)
{
  return to_mesh<Mesh>(plane_grid_soup(nx, ny, double(nx), double(ny)));
}

/// `p` after bending the x axis from 0 to `length` to an arc of `angle` radians: an isometry of the
/// plane z = 0; z becomes the height above the arc, toward the center of the circle.
inline std::array<double, 3> bend(const std::array<double, 3>& p, double length, double angle)
{
  if(angle == 0.)
    return p;
  const double radius = length / angle, at = p[0] / radius;
  return {{(radius - p[2]) * std::sin(at), p[1], radius - (radius - p[2]) * std::cos(at)}};
}

/// The strip bent by `angle` radians: same geodesic distances up to faceting.
template <class Mesh>
Mesh curled_strip(std::size_t nx, std::size_t ny, double angle)
{
  Triangle_soup soup = plane_grid_soup(nx, ny, double(nx), double(ny));
  for(auto& p : soup.points)
    p = bend(p, double(nx), angle);
  return to_mesh<Mesh>(soup);
}

/// Icosahedron on the sphere, its faces repeatedly split into four: 10 * 4^subdivisions + 2
/// vertices.
inline Triangle_soup icosphere_soup(unsigned int subdivisions, double radius)
{
  const double g = (1. + std::sqrt(5.)) / 2.;
  Triangle_soup soup;
  soup.points
    = {{{-1, g, 0}},  {{1, g, 0}},  {{-1, -g, 0}}, {{1, -g, 0}}, {{0, -1, g}},  {{0, 1, g}},
       {{0, -1, -g}}, {{0, 1, -g}}, {{g, 0, -1}},  {{g, 0, 1}},  {{-g, 0, -1}}, {{-g, 0, 1}}};
  soup.triangles = {{{0, 11, 5}}, {{0, 5, 1}},  {{0, 1, 7}},   {{0, 7, 10}}, {{0, 10, 11}},
                    {{1, 5, 9}},  {{5, 11, 4}}, {{11, 10, 2}}, {{10, 7, 6}}, {{7, 1, 8}},
                    {{3, 9, 4}},  {{3, 4, 2}},  {{3, 2, 6}},   {{3, 6, 8}},  {{3, 8, 9}},
                    {{4, 9, 5}},  {{2, 4, 11}}, {{6, 2, 10}},  {{8, 6, 7}},  {{9, 8, 1}}};
  for(unsigned int round = 0; round < subdivisions; ++round)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
    auto midpoint = [&](std::size_t a, std::size_t b) {
      const auto inserted
        = middle.insert({{(std::min)(a, b), (std::max)(a, b)}, soup.points.size()});
      if(inserted.second)
      {
        const auto p = soup.points[a], q = soup.points[b];
        soup.points.push_back({{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}});
      }
      return inserted.first->second;
    };
    Triangles finer;
    for(const auto& t : soup.triangles)
    {
      const std::size_t a = t[0], b = t[1], c = t[2];
      const std::size_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.insert(finer.end(), {{{a, ab, ca}}, {{b, bc, ab}}, {{c, ca, bc}}, {{ab, bc, ca}}});
    }
    soup.triangles.swap(finer);
    for(auto& p : soup.points)
    {
      const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      p = {{p[0] / norm, p[1] / norm, p[2] / norm}};
    }
  }
  for(auto& p : soup.points)
  {
    const double factor = radius / std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = {{factor * p[0], factor * p[1], factor * p[2]}};
  }
  return soup;
}

template <class Mesh>
Mesh icosphere(unsigned int subdivisions, double radius)
{
  return to_mesh<Mesh>(icosphere_soup(subdivisions, radius));
}

/// Torus around the z axis: `around` x `across` vertices, radius `small` across, `large` around.
inline Triangle_soup torus_soup(std::size_t around, std::size_t across, double large, double small)
{
  Triangle_soup soup;
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < across; ++j)
    {
      const double u = 2 * pi * double(i) / double(around);
      const double v = 2 * pi * double(j) / double(across);
      const double distance = large + small * std::cos(v);
      soup.points.push_back(
        {{distance * std::cos(u), distance * std::sin(u), small * std::sin(v)}});
      const std::size_t k = (i + 1) % around, l = (j + 1) % across;
      soup.triangles.push_back({{i * across + j, k * across + j, k * across + l}});
      soup.triangles.push_back({{i * across + j, k * across + l, i * across + l}});
    }
  return soup;
}

template <class Mesh>
Mesh torus(std::size_t around, std::size_t across, double large, double small)
{
  return to_mesh<Mesh>(torus_soup(around, across, large, small));
}

/// Trefoil knot: a tube that winds twice around the z axis, and three times around a circle.
template <class Mesh>
Mesh trefoil(std::size_t around, std::size_t across, double radius)
{
  Triangle_soup soup = torus_soup(around, across, 1., radius);
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < across; ++j)
    {
      const double u = 2 * pi * double(i) / double(around);
      const double v = 2 * pi * double(j) / double(across);
      const double distance = 2 + std::cos(3 * u) + radius * std::cos(v);
      soup.points[i * across + j] = {{distance * std::cos(2 * u), distance * std::sin(2 * u),
                                      std::sin(3 * u) + radius * std::sin(v)}};
    }
  return to_mesh<Mesh>(soup);
}

/// Closed straight tube along x: `rings` circles of `sides` vertices over [0,length], and the
/// center of each flat end.
inline Triangle_soup tube_soup(std::size_t rings, std::size_t sides, double length, double radius)
{
  Triangle_soup soup;
  const std::size_t first = rings * sides, last = first + 1;
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t j = 0; j < sides; ++j)
    {
      const double u = 2 * pi * double(j) / double(sides);
      const double x = length * double(i) / double(rings - 1);
      soup.points.push_back({{x, radius * std::cos(u), radius * std::sin(u)}});
    }
  soup.points.push_back({{0., 0., 0.}});
  soup.points.push_back({{length, 0., 0.}});
  for(std::size_t j = 0; j < sides; ++j)
  {
    const std::size_t k = (j + 1) % sides, end = (rings - 1) * sides;
    soup.triangles.push_back({{first, k, j}});
    soup.triangles.push_back({{last, end + j, end + k}});
    for(std::size_t i = 0; i + 1 < rings; ++i)
    {
      soup.triangles.push_back({{i * sides + j, i * sides + k, (i + 1) * sides + k}});
      soup.triangles.push_back({{i * sides + j, (i + 1) * sides + k, (i + 1) * sides + j}});
    }
  }
  return soup;
}

/// The closed tube, bent to an arc of `angle` radians (0: straight); thin: a wire.
template <class Mesh>
Mesh tube(std::size_t rings, std::size_t sides, double length, double radius, double angle = 0.)
{
  Triangle_soup soup = tube_soup(rings, sides, length, radius);
  for(auto& p : soup.points)
    p = bend(p, length, angle);
  return to_mesh<Mesh>(soup);
}

/// `nx` x `ny` x `nz` boxes of six Kuhn tetrahedra over [0,lengths], all positively oriented.
inline Tetrahedral_soup tetrahedral_box(std::size_t nx, std::size_t ny, std::size_t nz,
                                        const std::array<double, 3>& lengths = {{1., 1., 1.}})
{
  Tetrahedral_soup soup;
  for(std::size_t k = 0; k <= nz; ++k)
    for(std::size_t j = 0; j <= ny; ++j)
      for(std::size_t i = 0; i <= nx; ++i)
        soup.points.push_back(
          {{lengths[0] * double(i) / double(nx), lengths[1] * double(j) / double(ny),
            lengths[2] * double(k) / double(nz)}});
  const std::array<std::size_t, 3> step = {{1, nx + 1, (nx + 1) * (ny + 1)}};
  for(std::size_t k = 0; k < nz; ++k)
    for(std::size_t j = 0; j < ny; ++j)
      for(std::size_t i = 0; i < nx; ++i)
      {
        const std::size_t low = i + step[1] * j + step[2] * k;
        const std::size_t high = low + step[0] + step[1] + step[2];
        for(std::size_t a = 0; a < 3; ++a)
        {
          // The path along the axes a, b, c is even, its tetrahedron positive; a, c, b is odd.
          const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
          soup.cells.push_back({{low, low + step[a], low + step[a] + step[b], high}});
          soup.cells.push_back({{low, low + step[a] + step[c], low + step[a], high}});
        }
      }
  return soup;
}

/// A box of nx x ny x nz cells with the given lengths, bent in the xz plane by `angle` radians.
inline Tetrahedral_soup tetrahedral_bent_bar(std::size_t nx, std::size_t ny, std::size_t nz,
                                             double angle,
                                             const std::array<double, 3>& lengths = {{8., 1., 1.}})
{
  Tetrahedral_soup soup = tetrahedral_box(nx, ny, nz, lengths);
  for(auto& p : soup.points)
  {
    p[2] -= lengths[2] / 2; // the middle fiber preserves its length
    p = bend(p, lengths[0], angle);
  }
  return soup;
}

/// The boundary of tetrahedra, outward, its vertices in the order of the body; `origin`, if given,
/// receives their indices in the body.
inline Triangle_soup boundary(const Tetrahedral_soup& body,
                              std::vector<std::size_t>* origin = nullptr)
{
  using Triangle = std::array<std::size_t, 3>;
  std::map<Triangle, Triangle> open; // sorted -> oriented
  for(const auto& c : body.cells)
    for(const auto& f : {Triangle{{c[1], c[2], c[3]}}, Triangle{{c[0], c[3], c[2]}},
                         Triangle{{c[0], c[1], c[3]}}, Triangle{{c[0], c[2], c[1]}}})
    {
      auto key = f;
      std::sort(key.begin(), key.end());
      if(!open.insert({key, f}).second)
        open.erase(key);
    }
  std::vector<std::size_t> number(body.points.size(), 0), vertices;
  for(const auto& f : open)
    for(std::size_t v : f.first)
      number[v] = 1;
  Triangle_soup soup;
  for(std::size_t v = 0; v < number.size(); ++v)
    if(number[v] == 1)
    {
      number[v] = vertices.size();
      vertices.push_back(v);
      soup.points.push_back(body.points[v]);
    }
  for(const auto& f : open)
    soup.triangles.push_back({{number[f.second[0]], number[f.second[1]], number[f.second[2]]}});
  if(origin != nullptr)
    origin->swap(vertices);
  return soup;
}

/// Closed box, nx x ny x nz rectangles split into triangles: the boundary of
/// `tetrahedral_bent_bar(nx, ny, nz, 0)`.
template <class Mesh>
Mesh bar(std::size_t nx, std::size_t ny, std::size_t nz,
         const std::array<double, 3>& lengths = {{8., 1., 1.}})
{
  return to_mesh<Mesh>(boundary(tetrahedral_bent_bar(nx, ny, nz, 0., lengths)));
}

/// The bar bent by `angle` radians: same connectivity and order of the vertices.
template <class Mesh>
Mesh bent_bar(std::size_t nx, std::size_t ny, std::size_t nz, double angle,
              const std::array<double, 3>& lengths = {{8., 1., 1.}})
{
  return to_mesh<Mesh>(boundary(tetrahedral_bent_bar(nx, ny, nz, angle, lengths)));
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_SHAPES_H
