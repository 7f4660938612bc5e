// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SPREAD_SOURCES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SPREAD_SOURCES_H

#include <cstddef>
#include <vector>

namespace Canonical_pose_benchmark {

/// Vertices of a surface mesh with evenly spaced indices; the first is vertex 0.
template <class Mesh>
std::vector<typename Mesh::Vertex_index> spread_sources(const Mesh& mesh, const std::size_t number)
{
  std::vector<typename Mesh::Vertex_index> sources;
  for(std::size_t k = 0; k < number; ++k)
    sources.emplace_back(typename Mesh::size_type(k * mesh.number_of_vertices() / number));
  return sources;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SPREAD_SOURCES_H
