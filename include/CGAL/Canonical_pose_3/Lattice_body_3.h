// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
#define CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H

#include <CGAL/Canonical_pose_3/internal/lattice/Edge_splitter.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Lattice_copies.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Side_of_nearest_face.h>
#include <CGAL/Canonical_pose_3/internal/lattice/surface_chords.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is an elastic body for any oriented surface, one that intersects itself or has holes included:
the cubes of a regular lattice that the solid passes through, each cut into six tetrahedra.

Where several parts of the solid pass through the same cube (two fingers, or limbs that overlap),
each has a copy of the cube with nodes of its own \cgalCite{cgal:canonical-mbf-vna-04}, so that the
parts come apart when the target says so. The solid is followed from the surface along *chords*, the
ways from points of the surface against the normal to the exit from the solid; parts are told apart
by geodesic distances: two pieces in a cube are of the same part if they lie about as near to one
another on the surface as through the solid.

A cube that the surface passes through weighs as much as is filled of it. A vertex of the surface
hangs on the tetrahedron that holds it, by barycentric coordinates. The lattice lies along the
principal axes of area, so that it follows rigid motions and scaling. The size of the body does not
depend on the resolution of the surface.

\cgalModels `ElasticBody_3`

\sa `canonical_pose_3()`
\sa `Conforming_body_3`
*/
class Lattice_body_3
{
public:
  /*!
  constructs the body.

  \param points \f$ n \times 3 \f$, vertices of the surface.
  \param triangles triples of rows of `points`, oriented so that the normals point outwards.
  \param distances \f$ n \times l \f$, geodesic distances to landmarks, see
         `farthest_point_landmarks()`. The largest is the length \f$ L \f$.
  \param spacing side of the cubes as a fraction of \f$ L \f$; 0: chosen from the lengths of the
         chords, so that thin limbs are about two cubes wide, within bounds.
  \param caps triangles over the vertices that close the holes of the surface.

  \pre `distances.rows() == points.rows()`, and there is a column.

  \throws std::invalid_argument if the spacing is negative or so small that there would be tens of
         millions of cubes, a vertex belongs to no triangle, the surface has no area, or a distance
         is not finite (several components, for instance).

  <em>Complexity:</em> linear in the numbers of triangles, cubes and cubes along the chords.
  */
  Lattice_body_3(const Point_matrix& points, std::vector<std::array<std::size_t, 3>> triangles,
                 const Eigen::MatrixXd& distances, const double spacing = 0,
                 const std::vector<std::array<std::size_t, 3>>& caps = {})
  {
    CGAL_precondition(distances.rows() == points.rows() && distances.cols() > 0);
    check(distances, spacing);
    m_unit = distances.maxCoeff();
    place(points, triangles);
    check_vertices(triangles);
    if(spacing > 0 && is_too_small(spacing, triangles))
      throw std::invalid_argument("the spacing of the lattice, " + std::to_string(spacing)
                                  + " of the largest distance, is too small");
    internal::Geodesic_bounds bounds(distances, m_unit);
    split_faces(spacing > 0 ? (std::min)(spacing, LARGEST_SPACING) : LARGEST_SPACING, triangles,
                bounds);
    const internal::Chord_finder find_chords(m_surface, triangles, caps, bounds);
    const auto chords_from_cubes = [&](double side) {
      while(internal::number_of_samples(m_surface, triangles, side) > LARGEST_NUMBER_OF_SAMPLES)
        side *= 2;
      return internal::thinned(find_chords(internal::sample_surface(m_surface, triangles, side)),
                               side * LARGEST_NUMBER_OF_SAMPLES);
    };
    m_spacing = spacing > 0 ? spacing
                            : suitable_spacing(chords_from_cubes(LARGEST_SPACING), triangles, caps);
    while(is_too_small(m_spacing, triangles))
      m_spacing *= 1.25;
    const std::vector<internal::Chord> chords = chords_from_cubes(m_spacing / 2);
    const internal::Lattice_pieces pieces(m_surface, triangles, chords, m_spacing);
    const internal::Lattice_copies copies(triangles, pieces, bounds);
    make_cells(pieces, copies);
    weigh_cells(pieces, copies, triangles);
    embed(pieces, copies, triangles, points.rows());
  }

  /// constructs the body of a triangle mesh.
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and
  ///         points of a kernel as values
  template <typename TriangleMesh, typename VertexPointMap>
  Lattice_body_3(const TriangleMesh& tmesh, VertexPointMap vertex_point_map,
                 const Eigen::MatrixXd& distances, const double spacing = 0)
    : Lattice_body_3(point_matrix(tmesh, vertex_point_map), internal::index_triangles(tmesh),
                     distances, spacing)
  {}

  /// returns the \f$ N \times 3 \f$ nodes, in the unit of the surface.
  const Point_matrix& points() const { return m_points; }

  /// returns the cells, four rows of `points()` each; six in a row are those of a cube.
  const std::vector<std::array<int, 4>>& cells() const { return m_cells; }

  /// returns the share of each cell in the volume, of cubes on the surface the filled part; the sum
  /// is 1.
  const Eigen::VectorXd& cell_weights() const { return m_cell_weights; }

  /// returns the filled volume.
  double volume() const { return m_volume; }

  /// returns the \f$ n \times N \f$ matrix \f$ B \f$ with four entries per row at most.
  const Eigen::SparseMatrix<double>& embedding() const { return m_embedding; }

  /// returns the side of the cubes as a fraction of \f$ L \f$.
  double spacing() const { return m_spacing; }

private:
  static constexpr double SMALLEST_SPACING = 1. / 120, LARGEST_SPACING = 1. / 60;
  static constexpr double LARGEST_NUMBER_OF_SAMPLES = 5e6, LARGEST_NUMBER_OF_PARTS = 1e6;
  static constexpr double LARGEST_NUMBER_OF_CUBES = 2e7; // in the box around the surface
  static constexpr double WANTED_CUBES = 7000;

  static void check(const Eigen::MatrixXd& distances, const double spacing)
  {
    if(!(spacing >= 0) || !std::isfinite(spacing))
      throw std::invalid_argument("the spacing of the lattice is negative or not finite");
    if(!distances.allFinite())
      throw std::invalid_argument("a geodesic distance is not finite");
  }

  bool is_too_small(const double spacing,
                    const std::vector<std::array<std::size_t, 3>>& triangles) const
  {
    const Eigen::Array3d extent
      = (m_surface.colwise().maxCoeff() - m_surface.colwise().minCoeff()).transpose().array();
    return !((extent / spacing + 1).prod() <= LARGEST_NUMBER_OF_CUBES)
           || internal::number_of_samples(m_surface, triangles, spacing)
                > LARGEST_NUMBER_OF_SAMPLES;
  }

  // The surface in its own frame, in units of L.
  void place(const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const Eigen::VectorXd shares = vertex_area_shares(points, triangles);
    const Point_matrix scaled = points / m_unit;
    internal::Principal_axes frame(scaled, shares);
    frame.orient(scaled, shares);
    m_centroid = frame.centroid;
    m_axes = frame.axes;
    m_surface = (scaled.rowwise() - m_centroid) * m_axes;
  }

  void check_vertices(const std::vector<std::array<std::size_t, 3>>& triangles) const
  {
    std::vector<bool> has_triangle(static_cast<std::size_t>(m_surface.rows()), false);
    for(const auto& t : triangles)
      for(const std::size_t v : t)
        has_triangle[v] = true;
    const auto found = std::find(has_triangle.begin(), has_triangle.end(), false);
    if(found != has_triangle.end())
      throw std::invalid_argument("vertex " + std::to_string(found - has_triangle.begin())
                                  + " belongs to no triangle");
  }

  // Parts of the solid are told apart by a corner of each face: it must not lie far from the rest.
  void split_faces(double longest_edge, std::vector<std::array<std::size_t, 3>>& triangles,
                   internal::Geodesic_bounds& bounds)
  {
    while(internal::number_of_samples(m_surface, triangles, longest_edge) > LARGEST_NUMBER_OF_PARTS)
      longest_edge *= 2;
    const internal::Edge_splitter splitter(m_surface, triangles, longest_edge);
    bounds.add_middles(splitter.edges(), m_surface);
  }

  // Half of what only a tenth of the chords is shorter than, in bounds, but no more cubes than wanted.
  double suitable_spacing(const std::vector<internal::Chord>& chords,
                          const std::vector<std::array<std::size_t, 3>>& triangles,
                          const std::vector<std::array<std::size_t, 3>>& caps) const
  {
    double thin = 0;
    if(!chords.empty())
    {
      std::vector<double> lengths;
      for(const internal::Chord& chord : chords)
        lengths.push_back(chord.length);
      const auto tenth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 10);
      std::nth_element(lengths.begin(), tenth, lengths.end());
      thin = *tenth;
    }
    const double volume = std::abs(internal::signed_volume(m_surface, triangles)
                                   + internal::signed_volume(m_surface, caps))
                          / 6;
    double area = 0;
    for(const auto& t : triangles)
      area += internal::twice_area(m_surface, t) / 2;
    double result = (std::max)((std::min)(thin / 2, LARGEST_SPACING), SMALLEST_SPACING);
    while(volume / (result * result * result) + area / (result * result) > WANTED_CUBES)
      result *= 1.05;
    return result;
  }

  // The six ways from corner 0 of a cube along its sides to corner 7 are the tetrahedra (Kuhn).
  static const std::array<std::array<int, 4>, 6>& corners_of_tetrahedra()
  {
    static const std::array<std::array<int, 4>, 6> corners
      = {{{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
    return corners;
  }

  void make_cells(const internal::Lattice_pieces& pieces, const internal::Lattice_copies& copies)
  {
    m_points.resize(static_cast<Eigen::Index>(copies.number_of_nodes()), 3);
    m_cells.reserve(6 * copies.held().size());
    for(const std::size_t i : copies.held())
    {
      const std::array<int, 3> cell = pieces.coordinates(copies.cells()[i]);
      const std::array<int, 8>& nodes = copies.nodes()[i];
      for(int corner = 0; corner < 8; ++corner)
      {
        const Eigen::Vector3d place(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                                    cell[2] + (corner >> 2));
        const Eigen::RowVector3d point = (pieces.low() + m_spacing * place).transpose();
        m_points.row(nodes[static_cast<std::size_t>(corner)])
          = m_unit * (m_centroid + point * m_axes.transpose());
      }
      for(const std::array<int, 4>& t : corners_of_tetrahedra())
        m_cells.push_back(
          {nodes[static_cast<std::size_t>(t[0])], nodes[static_cast<std::size_t>(t[1])],
           nodes[static_cast<std::size_t>(t[2])], nodes[static_cast<std::size_t>(t[3])]});
    }
  }

  // The share of a cube that lies inside: of a few points, those behind the nearest face.
  double filled_share(const internal::Lattice_pieces& pieces, const int cell,
                      const std::vector<int>& faces,
                      const std::vector<std::array<std::size_t, 3>>& triangles) const
  {
    if(faces.empty())
      return 1;
    const std::array<int, 3> coordinates = pieces.coordinates(cell);
    internal::Side_of_nearest_face side(m_surface, triangles, faces, 1e-9 * m_spacing);
    constexpr int n = 3;
    int inside = 0;
    for(int i = 0; i < n * n * n; ++i)
    {
      const Eigen::Vector3d place((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
      const Eigen::Vector3d point
        = pieces.low()
          + m_spacing * (Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]) + place);
      inside += side.is_behind(point) ? 1 : 0;
    }
    return (std::max)(inside, 1) / double(n * n * n);
  }

  void weigh_cells(const internal::Lattice_pieces& pieces, const internal::Lattice_copies& copies,
                   const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const std::size_t n = copies.held().size();
    m_cell_weights.resize(static_cast<Eigen::Index>(6 * n));
    internal::for_each_block(n, [&](std::size_t, const std::size_t begin, const std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        const std::size_t copy = copies.held()[i];
        m_cell_weights.segment<6>(static_cast<Eigen::Index>(6 * i))
          .setConstant(filled_share(pieces, copies.cells()[copy], copies.faces(copy), triangles)
                       / 6);
      }
    });
    const double filled_cubes = m_cell_weights.sum();
    m_cell_weights /= filled_cubes;
    const double side = m_spacing * m_unit;
    m_volume = filled_cubes * side * side * side;
  }

  void embed(const internal::Lattice_pieces& pieces, const internal::Lattice_copies& copies,
             const std::vector<std::array<std::size_t, 3>>& triangles, const Eigen::Index n)
  {
    std::vector<std::size_t> face_of_vertex(static_cast<std::size_t>(m_surface.rows()));
    for(std::size_t f = triangles.size(); f-- > 0;)
      for(const std::size_t v : triangles[f])
        face_of_vertex[v] = f;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * static_cast<std::size_t>(n));
    for(std::size_t v = 0; v < static_cast<std::size_t>(n); ++v)
    {
      const Eigen::Vector3d point = m_surface.row(static_cast<Eigen::Index>(v));
      const int cell = pieces.cell_of(point);
      const std::array<int, 3> coordinates = pieces.coordinates(cell);
      const std::array<int, 8>& nodes
        = copies.nodes()[copies.copy_of(static_cast<std::size_t>(cell), face_of_vertex[v])];
      const Eigen::Vector3d place
        = pieces.in_cells(point) - Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]);
      std::array<int, 3> axes = {0, 1, 2}; // by falling coordinate: the way to corner 7
      std::sort(axes.begin(), axes.end(), [&](const int a, const int b) {
        return place[a] != place[b] ? place[a] > place[b] : a < b;
      });
      std::size_t corner = 0;
      double last = 1;
      for(std::size_t k = 0; k <= 3; ++k)
      {
        const double next = k < 3 ? place[axes[k]] : 0;
        if(last != next)
          entries.emplace_back(static_cast<int>(v), nodes[corner], last - next);
        last = next;
        if(k < 3)
          corner |= std::size_t(1) << axes[k];
      }
    }
    m_embedding.resize(n, m_points.rows());
    m_embedding.setFromTriplets(entries.begin(), entries.end());
  }

  double m_unit = 0, m_spacing = 0, m_volume = 0;
  Eigen::RowVector3d m_centroid;
  Eigen::Matrix3d m_axes;
  internal::Row_points m_surface;
  Point_matrix m_points;
  std::vector<std::array<int, 4>> m_cells;
  Eigen::VectorXd m_cell_weights;
  Eigen::SparseMatrix<double> m_embedding;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LATTICE_BODY_3_H
