// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_CORRESPONDENCE_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_CORRESPONDENCE_H

#include "Nearest_points.h"

#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;

/// The correspondence between vertices of the meshes of one class.
class Correspondence
{
public:
  using Path = std::filesystem::path;

  /// `vertex_lists`: a file with one vertex per line (the first word; the rest of the line is
  /// ignored), used for all meshes, or a folder with such a file `<name>.vts` per mesh.
  /// `references`: a folder with meshes of the same names and positions that have the same vertices
  /// throughout the class. Without either, vertices correspond by index.
  explicit Correspondence(const Path& vertex_lists = Path(), const Path& references = Path())
    : m_vertex_lists(vertex_lists), m_references(references)
  {}

  /// Returns the vertices of the mesh in `file`, with the given positions, that correspond to those
  /// of the other meshes.
  std::vector<std::size_t> vertices(const Path& file, const Point_matrix& points) const
  {
    if(!m_vertex_lists.empty())
      return listed(std::filesystem::is_directory(m_vertex_lists)
                      ? m_vertex_lists / file.stem().concat(".vts")
                      : m_vertex_lists,
                    static_cast<std::size_t>(points.rows()));
    if(!m_references.empty())
      return nearest(
        points, Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(
                  Canonical_pose_tool::read_mesh_file((m_references / file.filename()).string()))));
    std::vector<std::size_t> all(static_cast<std::size_t>(points.rows()));
    std::iota(all.begin(), all.end(), std::size_t(0));
    return all;
  }

private:
  static std::vector<std::size_t> listed(const Path& file, const std::size_t number_of_vertices)
  {
    std::ifstream in(file);
    if(!in)
      throw std::invalid_argument("cannot read " + file.string());
    std::vector<std::size_t> result;
    for(std::string line; std::getline(in, line);)
    {
      std::istringstream words(line);
      std::size_t vertex;
      if(!(words >> vertex))
        continue;
      if(vertex >= number_of_vertices)
        throw std::invalid_argument(file.string() + " names vertex " + std::to_string(vertex)
                                    + ", but there are " + std::to_string(number_of_vertices));
      result.push_back(vertex);
    }
    return result;
  }

  // The vertex nearest to each of `references`.
  static std::vector<std::size_t> nearest(const Point_matrix& points,
                                          const Point_matrix& references)
  {
    const std::vector<std::size_t> result = Nearest_points(points).find(references);
    const double squared
      = (rows_of(points, result) - references).rowwise().squaredNorm().mean();
    const double extent
      = std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean());
    if(!(std::sqrt(squared) < 0.05 * extent))
      throw std::invalid_argument("the mesh does not lie where its reference lies");
    return result;
  }

  Path m_vertex_lists, m_references;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_CORRESPONDENCE_H
