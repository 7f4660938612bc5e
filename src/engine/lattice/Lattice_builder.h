// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_BUILDER_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_BUILDER_H

#include "Edge_splitter.h"
#include "Lattice_copies.h"
#include "Lattice_pieces.h"
#include "Side_of_nearest_face.h"
#include "surface_chords.h"
#include "../surface/signed_volume.h"

#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/lattice/Lattice_body_data.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Creates the lattice of a surface, in the frame of its principal axes and in units of L.
class Lattice_builder
{
public:
  // `share_of_cells`: of those that a lattice would have otherwise, if no spacing is requested.
  Lattice_builder(const Point_matrix& points, std::vector<std::array<std::size_t, 3>> triangles,
                  Geodesic_bounds bounds, const double spacing,
                  const std::vector<std::array<std::size_t, 3>>& caps,
                  const double share_of_cells = 1)
    : m_coarsening(spacing > 0 ? 1 : 1 / std::sqrt(share_of_cells)),
      m_number_of_cubes(share_of_cells * SUITABLE_NUMBER_OF_CUBES)
  {
    check(bounds, spacing);
    m_unit = bounds.unit();
    place(points, triangles);
    check_vertices(triangles);
    m_number_of_samples = Sample_bound(m_surface, triangles);
    if(spacing > 0 && is_too_small(spacing))
      throw std::invalid_argument("the spacing of the lattice, " + shortest_number(spacing)
                                  + " of the largest distance, is too small for this surface");
    split_faces(spacing > 0 ? (std::min)(spacing, largest_spacing()) : largest_spacing(), triangles,
                bounds);
    const Chord_finder find_chords(m_surface, triangles, caps, bounds);
    const auto chords_from_cubes = [&](double side) {
      while(m_number_of_samples(side) > LARGEST_NUMBER_OF_SAMPLES)
        side *= 2;
      return thinned(find_chords(sample_surface(m_surface, triangles, side)),
                     side * LARGEST_NUMBER_OF_SAMPLES);
    };
    m_data.spacing = spacing > 0
                       ? spacing
                       : suitable_spacing(chords_from_cubes(largest_spacing()), triangles, caps);
    while(is_too_small(m_data.spacing))
      m_data.spacing *= 1.25;
    const std::vector<Chord> chords = chords_from_cubes(m_data.spacing / 2);
    const Lattice_pieces pieces(m_surface, triangles, chords, m_data.spacing);
    const Lattice_copies copies(triangles, pieces, bounds);
    make_cells(pieces, copies);
    weigh_cells(pieces, copies, triangles);
    embed(pieces, copies, triangles, points.rows());
  }

  Lattice_body_data take() { return std::move(m_data); }

private:
  static constexpr double SMALLEST_SPACING = 1. / 120, LARGEST_SPACING = 1. / 60;
  static constexpr double LARGEST_NUMBER_OF_SAMPLES = 5e6, LARGEST_NUMBER_OF_PARTS = 1e6;
  static constexpr double LARGEST_NUMBER_OF_CUBES = 2e7; // in the bounding box of the surface
  static constexpr double SUITABLE_NUMBER_OF_CUBES = 4000;

  double largest_spacing() const { return m_coarsening * LARGEST_SPACING; }

  static void check(const Geodesic_bounds& bounds, const double spacing)
  {
    require_lattice_spacing(spacing);
    if(!bounds.are_finite())
      throw std::invalid_argument("a geodesic distance is not finite");
  }

  bool is_too_small(const double spacing) const
  {
    const Eigen::Array3d extent
      = (m_surface.colwise().maxCoeff() - m_surface.colwise().minCoeff()).transpose().array();
    return !((extent / spacing + 1).prod() <= LARGEST_NUMBER_OF_CUBES)
           || m_number_of_samples(spacing) > LARGEST_NUMBER_OF_SAMPLES;
  }

  // Transforms the surface to the frame of its principal axes, in units of L.
  void place(const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const Eigen::VectorXd shares = vertex_area_shares(points, triangles);
    const Point_matrix scaled = points / m_unit;
    Principal_axes frame(scaled, shares);
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

  // Parts of the solid are distinguished by one corner of each face, which must represent the
  // entire face.
  void split_faces(double longest_edge, std::vector<std::array<std::size_t, 3>>& triangles,
                   Geodesic_bounds& bounds)
  {
    while(m_number_of_samples(longest_edge) > LARGEST_NUMBER_OF_PARTS)
      longest_edge *= 2;
    const Edge_splitter splitter(m_surface, triangles, longest_edge);
    if(splitter.edges().empty())
      return;
    bounds.add_middles(splitter.edges(), m_surface);
    m_number_of_samples = Sample_bound(m_surface, triangles);
  }

  // Half the length that nine tenths of the chords exceed, within bounds, and without too many
  // cubes.
  double suitable_spacing(const std::vector<Chord>& chords,
                          const std::vector<std::array<std::size_t, 3>>& triangles,
                          const std::vector<std::array<std::size_t, 3>>& caps) const
  {
    double thin = 0;
    if(!chords.empty())
    {
      std::vector<double> lengths;
      for(const Chord& chord : chords)
        lengths.push_back(chord.length);
      const auto tenth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 10);
      std::nth_element(lengths.begin(), tenth, lengths.end());
      thin = *tenth;
    }
    const double volume
      = std::abs(signed_volume(m_surface, triangles) + signed_volume(m_surface, caps)) / 6;
    const double total_area = area(m_surface, triangles);
    double result
      = (std::max)((std::min)(thin / 2, largest_spacing()), m_coarsening * SMALLEST_SPACING);
    while(volume / (result * result * result) + total_area / (result * result) > m_number_of_cubes)
      result *= 1.05;
    return result;
  }

  // The tetrahedra correspond to the six paths along edges from corner 0 of a cube to corner 7
  // (Kuhn).
  static const std::array<std::array<int, 4>, 6>& corners_of_tetrahedra()
  {
    static const std::array<std::array<int, 4>, 6> corners
      = {{{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
    return corners;
  }

  void make_cells(const Lattice_pieces& pieces, const Lattice_copies& copies)
  {
    m_data.points.resize(static_cast<Eigen::Index>(copies.number_of_nodes()), 3);
    m_data.cells.reserve(6 * copies.held().size());
    for(const std::size_t i : copies.held())
    {
      const std::array<int, 3> cell = pieces.coordinates(copies.cells()[i]);
      const std::array<int, 8>& nodes = copies.nodes()[i];
      for(int corner = 0; corner < 8; ++corner)
      {
        const Eigen::Vector3d place(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                                    cell[2] + (corner >> 2));
        const Eigen::RowVector3d point = (pieces.low() + m_data.spacing * place).transpose();
        m_data.points.row(nodes[static_cast<std::size_t>(corner)])
          = m_unit * (m_centroid + point * m_axes.transpose());
      }
      for(const std::array<int, 4>& t : corners_of_tetrahedra())
        m_data.cells.push_back(
          {nodes[static_cast<std::size_t>(t[0])], nodes[static_cast<std::size_t>(t[1])],
           nodes[static_cast<std::size_t>(t[2])], nodes[static_cast<std::size_t>(t[3])]});
    }
  }

  // Returns the share of a cube that is inside, estimated by the points behind the nearest face.
  double filled_share(const Lattice_pieces& pieces, const int cell, const std::vector<int>& faces,
                      const std::vector<std::array<std::size_t, 3>>& triangles) const
  {
    if(faces.empty())
      return 1;
    const std::array<int, 3> coordinates = pieces.coordinates(cell);
    Side_of_nearest_face side(m_surface, triangles, faces, 1e-9 * m_data.spacing);
    constexpr int n = 3;
    int inside = 0;
    for(int i = 0; i < n * n * n; ++i)
    {
      const Eigen::Vector3d place((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
      const Eigen::Vector3d point
        = pieces.low()
          + m_data.spacing
              * (Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]) + place);
      inside += side.is_behind(point) ? 1 : 0;
    }
    return (std::max)(inside, 1) / double(n * n * n);
  }

  void weigh_cells(const Lattice_pieces& pieces, const Lattice_copies& copies,
                   const std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const std::size_t n = copies.held().size();
    m_data.cell_weights.resize(static_cast<Eigen::Index>(6 * n));
    for_each_block(n, [&](std::size_t, const std::size_t begin, const std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        const std::size_t copy = copies.held()[i];
        m_data.cell_weights.segment<6>(static_cast<Eigen::Index>(6 * i))
          .setConstant(filled_share(pieces, copies.cells()[copy], copies.faces(copy), triangles)
                       / 6);
      }
    });
    const double filled_cubes = m_data.cell_weights.sum();
    m_data.cell_weights /= filled_cubes;
    const double side = m_data.spacing * m_unit;
    m_data.volume = filled_cubes * side * side * side;
  }

  void embed(const Lattice_pieces& pieces, const Lattice_copies& copies,
             const std::vector<std::array<std::size_t, 3>>& triangles, const Eigen::Index n)
  {
    std::vector<std::size_t> face_of_vertex(static_cast<std::size_t>(m_surface.rows()));
    for(std::size_t f = triangles.size(); f-- > 0;)
      for(const std::size_t v : triangles[f])
        face_of_vertex[v] = f;
    const auto for_each_entry = [&](const std::size_t v, const auto& put) {
      const Eigen::Vector3d point = m_surface.row(static_cast<Eigen::Index>(v));
      const int cell = pieces.cell_of(point);
      const std::array<int, 3> coordinates = pieces.coordinates(cell);
      const std::array<int, 8>& nodes
        = copies.nodes()[copies.copy_of(static_cast<std::size_t>(cell), face_of_vertex[v])];
      const Eigen::Vector3d place
        = pieces.in_cells(point) - Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]);
      std::array<int, 3> axes = {0, 1, 2}; // by decreasing coordinate: the path to corner 7
      std::sort(axes.begin(), axes.end(), [&](const int a, const int b) {
        return place[a] != place[b] ? place[a] > place[b] : a < b;
      });
      std::size_t corner = 0;
      double last = 1;
      for(std::size_t k = 0; k <= 3; ++k)
      {
        const double next = k < 3 ? place[axes[k]] : 0;
        if(last != next)
          put(static_cast<std::size_t>(nodes[corner]),
              std::make_pair(static_cast<int>(v), last - next));
        last = next;
        if(k < 3)
          corner |= std::size_t(1) << axes[k];
      }
    };
    const auto columns = Buckets<std::pair<int, double>>::sorted(
      copies.number_of_nodes(), static_cast<std::size_t>(n), for_each_entry);
    m_data.embedding.resize(n, m_data.points.rows());
    m_data.embedding.reserve(static_cast<Eigen::Index>(columns.values().size()));
    for(std::size_t node = 0; node < columns.number_of_buckets(); ++node)
    {
      m_data.embedding.startVec(static_cast<Eigen::Index>(node));
      for(const auto& [v, weight] : columns[node])
        m_data.embedding.insertBack(v, static_cast<Eigen::Index>(node)) = weight;
    }
    m_data.embedding.finalize();
  }

  double m_coarsening; // of the spacing, where there are fewer cubes
  double m_number_of_cubes;
  double m_unit;
  Eigen::RowVector3d m_centroid;
  Eigen::Matrix3d m_axes;
  Row_points m_surface;
  Sample_bound m_number_of_samples;
  Lattice_body_data m_data;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_LATTICE_BUILDER_H
