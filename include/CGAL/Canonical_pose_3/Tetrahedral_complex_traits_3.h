// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TETRAHEDRAL_COMPLEX_TRAITS_3_H
#define CGAL_CANONICAL_POSE_3_TETRAHEDRAL_COMPLEX_TRAITS_3_H

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>

#include <boost/range/irange.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

template <class...>
struct Make_void
{
  using type = void;
};

// Vertices of the cells in `cells`, each once, in the order of the triangulation's vertices.
template <class Triangulation, class CellRange>
std::vector<typename Triangulation::Vertex_handle> vertices_of_cells(const Triangulation& tr,
                                                                     const CellRange& cells)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  std::unordered_set<Vertex_handle> used;
  for(const auto& cell : cells)
    used.insert(cell.begin(), cell.end());
  std::vector<Vertex_handle> result;
  result.reserve(used.size());
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    if(used.count(v) != 0)
      result.push_back(v);
  return result;
}

template <class Cell_handle>
auto handles_of_cell(const Cell_handle c)
{
  return std::array{c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)};
}

// The handles of the finite cells whose subdomain index is not that of the exterior.
template <class Triangulation>
std::vector<typename Triangulation::Cell_handle> cells_inside(const Triangulation& tr)
{
  using Cell_handle = typename Triangulation::Cell_handle;
  using Subdomain_index = std::decay_t<decltype(Cell_handle()->subdomain_index())>;
  std::vector<Cell_handle> result;
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    if(c->subdomain_index() != Subdomain_index())
      result.push_back(Cell_handle(c));
  return result;
}

template <class Complex, class = void>
struct Is_triangulation_3 : std::false_type
{};

template <class Complex>
struct Is_triangulation_3<
  Complex, std::void_t<typename Complex::Triangulation_data_structure,
                       typename Complex::Geom_traits::Point_3,
                       decltype(std::declval<const Complex&>().finite_cells_begin())>>
  : std::true_type
{};

// The base of the traits of types that are not complexes. For a triangulation without subdomain
// index, all members of the traits are declared, so that the compiler reports a single error.
template <class Complex, bool = Is_triangulation_3<Complex>::value>
struct No_complex_traits
{};

template <class Triangulation>
struct No_complex_traits<Triangulation, true>
{
  using Vertex_descriptor = typename Triangulation::Vertex_handle;
  using Point_3 = typename Triangulation::Geom_traits::Point_3;

  static std::vector<Vertex_descriptor> vertices(const Triangulation&)
  {
    static_assert(
      !Is_triangulation_3<Triangulation>::value,
      "A triangulation is read as a complex only if its cells have a subdomain index, which "
      "tells those of the complex from the others: take Remeshing_triangulation_3 or "
      "Mesh_complex_3_in_triangulation_3, or copy the cells to Indexed_tetrahedra_3.");
    return {};
  }
  static std::vector<std::array<Vertex_descriptor, 4>> cells(const Triangulation&) { return {}; }
  static Point_3 point(const Triangulation&, Vertex_descriptor) { return {}; }
};

} // namespace internal

/*!
\struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3 Tetrahedral_complex_traits_3.h <CGAL/Canonical_pose_3/Tetrahedral_complex_traits_3.h>
\ingroup PkgCanonicalPose3Ref

\brief describes how to read a tetrahedral complex; specialize it for your own complex type.

The package specializes it for
- `CGAL::Mesh_complex_3_in_triangulation_3` (the result of `CGAL::make_mesh_3()`): its cells in the
  complex,
- `CGAL::Triangulation_3` and classes derived from it whose cells have a subdomain index (for
  instance `CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3`): the finite cells of nonzero
  index,
- `Indexed_tetrahedra_3`,
- `Labeled_cells_3`: the cells with given labels of any of these.

The label of a cell is its subdomain index, or its entry in `Indexed_tetrahedra_3::labels`.

The vertices are those of the cells. A complex is never modified: moving the vertices of a
triangulation in place would invalidate it.

\tparam Complex the type of the complex

\cgalModels `TetrahedralComplexTraits_3`
*/
template <class Complex, class Enable = void>
struct Tetrahedral_complex_traits_3;

/// \cond SKIP_IN_MANUAL

template <class Complex, class Enable>
struct Tetrahedral_complex_traits_3 : internal::No_complex_traits<Complex>
{};

// Complexes of Mesh_3.
template <class C3t3>
struct Tetrahedral_complex_traits_3<
  C3t3, typename internal::Make_void<typename C3t3::Triangulation,
                                     typename C3t3::Cells_in_complex_iterator>::type>
{
  using Vertex_descriptor = typename C3t3::Triangulation::Vertex_handle;
  using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;

  static std::vector<std::array<Vertex_descriptor, 4>> cells(const C3t3& c3t3)
  {
    std::vector<std::array<Vertex_descriptor, 4>> result;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      result.push_back(internal::handles_of_cell(typename C3t3::Triangulation::Cell_handle(c)));
    return result;
  }

  static std::vector<typename C3t3::Subdomain_index> labels(const C3t3& c3t3)
  {
    std::vector<typename C3t3::Subdomain_index> result;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      result.push_back(c3t3.subdomain_index(typename C3t3::Triangulation::Cell_handle(c)));
    return result;
  }

  static std::vector<Vertex_descriptor> vertices(const C3t3& c3t3)
  {
    return internal::vertices_of_cells(c3t3.triangulation(), cells(c3t3));
  }

  // Points may have a weight.
  static Point_3 point(const C3t3& c3t3, const Vertex_descriptor v)
  {
    return c3t3.triangulation().geom_traits().construct_point_3_object()(v->point());
  }
};

// Triangulations whose cells have a subdomain index.
template <class Triangulation>
struct Tetrahedral_complex_traits_3<
  Triangulation, typename internal::Make_void<
                   typename Triangulation::Triangulation_data_structure,
                   decltype(typename Triangulation::Cell_handle()->subdomain_index())>::type>
{
  using Vertex_descriptor = typename Triangulation::Vertex_handle;
  using Point_3 = typename Triangulation::Geom_traits::Point_3;

  static std::vector<std::array<Vertex_descriptor, 4>> cells(const Triangulation& tr)
  {
    std::vector<std::array<Vertex_descriptor, 4>> result;
    for(const auto c : internal::cells_inside(tr))
      result.push_back(internal::handles_of_cell(c));
    return result;
  }

  static auto labels(const Triangulation& tr)
  {
    std::vector<std::decay_t<decltype(typename Triangulation::Cell_handle()->subdomain_index())>>
      result;
    for(const auto c : internal::cells_inside(tr))
      result.push_back(c->subdomain_index());
    return result;
  }

  static std::vector<Vertex_descriptor> vertices(const Triangulation& tr)
  {
    return internal::vertices_of_cells(tr, cells(tr));
  }

  static Point_3 point(const Triangulation& tr, const Vertex_descriptor v)
  {
    return tr.geom_traits().construct_point_3_object()(v->point());
  }
};

template <class Point>
struct Tetrahedral_complex_traits_3<Indexed_tetrahedra_3<Point>>
{
  using Vertex_descriptor = std::size_t;
  using Point_3 = Point;

  static auto vertices(const Indexed_tetrahedra_3<Point>& complex)
  {
    return boost::irange(std::size_t(0), complex.points.size());
  }

  static const std::vector<std::array<std::size_t, 4>>&
  cells(const Indexed_tetrahedra_3<Point>& complex)
  {
    return complex.cells;
  }

  static const std::vector<int>& labels(const Indexed_tetrahedra_3<Point>& complex)
  {
    return complex.labels;
  }

  static const Point& point(const Indexed_tetrahedra_3<Point>& complex, const std::size_t v)
  {
    return complex.points[v];
  }
};

/// \endcond

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TETRAHEDRAL_COMPLEX_TRAITS_3_H
