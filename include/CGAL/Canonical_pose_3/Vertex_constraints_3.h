// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_VERTEX_CONSTRAINTS_3_H
#define CGAL_CANONICAL_POSE_3_VERTEX_CONSTRAINTS_3_H

#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_complex_traits_3.h>
#include <CGAL/Canonical_pose_3/internal/body/Indexed_complex.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// Vertices and points of a mesh or a complex.
template <class Graph, bool is_complex = Is_tetrahedral_complex<Graph>::value>
struct Constrained_graph
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Point = typename boost::property_traits<
    typename boost::property_map<Graph, vertex_point_t>::const_type>::value_type;
  static auto range(const Graph& graph) { return vertices(graph); }
};

template <class Complex>
struct Constrained_graph<Complex, true>
{
  using Vertex = typename Tetrahedral_complex_traits_3<Complex>::Vertex_descriptor;
  using Point = Complex_point<Complex>;
  static decltype(auto) range(const Complex& complex)
  {
    return Tetrahedral_complex_traits_3<Complex>::vertices(complex);
  }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief collects constraints on the vertices of a mesh or a tetrahedral complex, for `Options::constraints`.

The object must be constructed again if vertices are added to the mesh or removed from it.

\tparam Graph a model of `VertexListGraph` with an internal point property map, or a type for which
       `Tetrahedral_complex_traits_3` is specialized. `std::hash` must be specialized for its vertex descriptors.
\tparam Traits a model of `CanonicalPoseTraits_3`, by default the kernel of the points

\sa `Constraints_3`
*/
template <class Graph,
          class Traits =
            typename Kernel_traits<typename internal::Constrained_graph<Graph>::Point>::Kernel>
class Vertex_constraints_3
{
public:
  /// the vertex descriptors.
  using vertex_descriptor = typename internal::Constrained_graph<Graph>::Vertex;

  /// the point type.
  using Point_3 = typename Traits::Point_3;

  /// constructs an object without constraints.
  explicit Vertex_constraints_3(const Graph& graph, Traits traits = Traits())
    : m_traits(std::move(traits))
  {
    for(const vertex_descriptor v : internal::Constrained_graph<Graph>::range(graph))
      m_indices.emplace(v, m_indices.size());
  }

  /// adds a spring, see `Spring_3`.
  /// \throws std::invalid_argument if a vertex does not belong to the mesh; so do all functions below.
  void add_spring(const vertex_descriptor p, const vertex_descriptor q, const double rest_length,
                  const double stiffness = 1)
  {
    m_constraints.springs.push_back({index(p), index(q), rest_length, stiffness});
  }

  /// prescribes the vector from `q` to `p`, see `Directed_pair_3`.
  /// \tparam Vector a vector type of a \cgal kernel
  template <class Vector>
  void add_direction(const vertex_descriptor p, const vertex_descriptor q, const Vector& vector,
                     const double stiffness = 1)
  {
    const Eigen::RowVector3d row(CGAL::to_double(vector.x()), CGAL::to_double(vector.y()),
                                 CGAL::to_double(vector.z()));
    m_constraints.directions.push_back({index(p), index(q), row, stiffness});
  }

  /// prescribes the position of a vertex, see `Handle_3`.
  void add_handle(const vertex_descriptor p, const Point_3& position, const double stiffness = 1)
  {
    m_constraints.handles.push_back(
      {index(p), internal::to_row(m_traits, position).transpose(), stiffness});
  }

  /// makes two vertices mirror images of each other, see `Symmetric_pair_3`.
  void add_symmetric_pair(const vertex_descriptor p, const vertex_descriptor q,
                          const double stiffness = 1)
  {
    m_constraints.symmetric_pairs.push_back({index(p), index(q), stiffness});
  }

  /// returns the constraints with vertex indices.
  const Constraints_3& constraints() const { return m_constraints; }

private:
  std::size_t index(const vertex_descriptor v) const
  {
    const auto found = m_indices.find(v);
    if(found == m_indices.end())
      throw std::invalid_argument("a constraint names a vertex that the mesh does not have");
    return found->second;
  }

  Traits m_traits;
  std::unordered_map<vertex_descriptor, std::size_t> m_indices;
  Constraints_3 m_constraints;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_VERTEX_CONSTRAINTS_3_H
