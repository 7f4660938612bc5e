// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_METHODS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_METHODS_H

#include "Segmentation_errors.h"

#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"
#include "compute_pose.h"

#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;
using CGAL::Canonical_pose_3::Segmentation_options;

/// A mesh with its canonical pose.
struct Posed_mesh
{
  explicit Posed_mesh(Canonical_pose_tool::Mesh_file file, const bool needs_pose)
    : mesh(std::move(file)),
      points(Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(mesh)))
  {
    if(!needs_pose)
      return;
    const CGAL::Canonical_pose_3::Result result
      = Canonical_pose_tool::compute_pose(mesh, CGAL::Canonical_pose_3::Options());
    pose = result.pose;
    target = *result.target;
  }

  Canonical_pose_tool::Mesh_file mesh;
  Point_matrix points, pose, target;
};

inline Segmentation_options with_parts(const std::size_t number_of_parts)
{
  Segmentation_options options;
  options.number_of_parts = number_of_parts;
  return options;
}

/// Clusters vertices by geodesic distances: k-medoids, as in S. Shlafman et al., "Metamorphosis of
/// polyhedral surfaces using decomposition", 2002, but with distances along the surface only, and
/// with medoids among 300 of the vertices. A face belongs to the cluster of its first vertex.
inline Parts geodesic_k_means(const Posed_mesh& shape, const std::size_t k)
{
  constexpr Eigen::Index most_candidates = 300;
  constexpr int most_iterations = 50;
  const Eigen::Index n = shape.points.rows(), m = (std::min)(n, most_candidates);
  std::vector<std::size_t> candidates;
  for(Eigen::Index i = 0; i < m; ++i)
    candidates.push_back(static_cast<std::size_t>(i * n / m));
  const Eigen::MatrixXd distances
    = CGAL::Canonical_pose_3::geodesic_distances(shape.points, shape.mesh.faces, candidates);
  std::vector<Eigen::Index> medoids(1, 0); // columns of distances
  Eigen::VectorXd nearest = distances.col(0);
  while(medoids.size() < (std::min)(k, candidates.size()))
  {
    Eigen::Index farthest = 0;
    for(Eigen::Index c = 0; c < m; ++c)
      if(nearest[static_cast<Eigen::Index>(candidates[static_cast<std::size_t>(c)])]
         > nearest[static_cast<Eigen::Index>(candidates[static_cast<std::size_t>(farthest)])])
        farthest = c;
    medoids.push_back(farthest);
    nearest = nearest.cwiseMin(distances.col(farthest));
  }
  std::vector<Eigen::Index> cluster(static_cast<std::size_t>(n));
  for(int iteration = 0; iteration < most_iterations; ++iteration)
  {
    std::vector<std::vector<Eigen::Index>> members(medoids.size());
    for(Eigen::Index v = 0; v < n; ++v)
    {
      std::size_t best = 0;
      for(std::size_t c = 1; c < medoids.size(); ++c)
        if(distances(v, medoids[c]) < distances(v, medoids[best]))
          best = c;
      cluster[static_cast<std::size_t>(v)] = static_cast<Eigen::Index>(best);
      members[best].push_back(v);
    }
    std::vector<Eigen::Index> moved;
    for(std::size_t c = 0; c < medoids.size(); ++c)
    {
      Eigen::Index best;
      distances(members[c], Eigen::all).colwise().sum().minCoeff(&best);
      moved.push_back(members[c].empty() ? medoids[c] : best);
    }
    if(moved == medoids)
      break;
    medoids = std::move(moved);
  }
  Parts result;
  for(const CGAL::Canonical_pose_3::Face_list::Face face : shape.mesh.faces)
    result.push_back(static_cast<std::size_t>(cluster[face[0]]));
  return result;
}

/// CGAL's segmentation by shape diameters, with its default options, of the repaired mesh; faces that
/// the repair removes belong to the first part. Of its numbers of clusters, from 2 to 10, the one is
/// chosen whose number of parts is nearest to `k`; 5 if k is 0.
inline Parts diameter_segmentation(const Posed_mesh& shape, const std::size_t k)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const CGAL::Canonical_pose_3::Repaired_surface_3 surface
    = CGAL::Canonical_pose_3::repair_surface(shape.points, shape.mesh.faces);
  Mesh mesh;
  for(Eigen::Index v = 0; v < surface.points.rows(); ++v)
    mesh.add_vertex({surface.points(v, 0), surface.points(v, 1), surface.points(v, 2)});
  for(const std::array<std::size_t, 3>& t : surface.triangles)
    mesh.add_face(Mesh::Vertex_index(static_cast<Mesh::size_type>(t[0])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(t[1])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(t[2])));
  auto diameters = mesh.add_property_map<Mesh::Face_index, double>("f:diameter").first;
  auto ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  CGAL::sdf_values(mesh, diameters);
  const auto segmentation = [&](const std::size_t number_of_clusters) {
    CGAL::segmentation_from_sdf_values(mesh, diameters, ids, number_of_clusters);
    Parts parts(shape.mesh.faces.size(), 0);
    for(const Mesh::Face_index f : mesh.faces()) // in the order of the triangles
      parts[surface.face_of_triangle[f]] = ids[f];
    return parts;
  };
  Parts best = segmentation(5);
  const auto distance = [k](const Parts& parts) {
    const std::size_t number = *std::max_element(parts.begin(), parts.end()) + 1;
    return number > k ? number - k : k - number;
  };
  for(std::size_t clusters = 2; k > 0 && clusters <= 10; ++clusters)
  {
    Parts parts = segmentation(clusters);
    if(distance(parts) < distance(best))
      best = std::move(parts);
  }
  return best;
}

struct Segmentation_method
{
  std::string name;
  bool needs_pose;
  bool can_choose_number; ///< of parts
  /// Arguments: the mesh and the number of parts, or 0.
  std::function<Parts(const Posed_mesh&, std::size_t)> segmentation;
};

inline std::vector<Segmentation_method> segmentation_methods()
{
  namespace CP = CGAL::Canonical_pose_3;
  const auto consensus = [](const Point_matrix& points, const Posed_mesh& shape,
                            const Point_matrix& pose, const std::size_t k) {
    return CP::consensus_segmentation_tree(points, shape.mesh.faces, pose, with_parts(k)).parts();
  };
  const auto k_means
    = [](const Posed_mesh& shape, const Point_matrix& points, const std::size_t k) {
        return CP::k_means_parts(points, shape.mesh.faces, with_parts(k));
      };
  const Point_matrix none(0, 3);
  return {
    {"consensus", true, true,
     [=](const Posed_mesh& s, const std::size_t k) { return consensus(s.points, s, s.pose, k); }},
    {"consensus, input only", false, true,
     [=](const Posed_mesh& s, const std::size_t k) { return consensus(s.points, s, none, k); }},
    {"consensus, pose only", true, true,
     [=](const Posed_mesh& s, const std::size_t k) { return consensus(s.pose, s, none, k); }},
    {"sweep", false, true,
     [](const Posed_mesh& s, const std::size_t k) {
       return CP::sweep_segmentation_tree(s.points, s.mesh.faces, Point_matrix(0, 3), with_parts(k))
         .parts();
     }},
    {"shape diameter (CGAL)", false, true, diameter_segmentation},
    {"k-means, geodesic", false, false, geodesic_k_means},
    {"k-means, input", false, false,
     [=](const Posed_mesh& s, const std::size_t k) { return k_means(s, s.points, k); }},
    {"k-means, target", true, false,
     [=](const Posed_mesh& s, const std::size_t k) { return k_means(s, s.target, k); }},
    {"k-means, pose", true, false,
     [=](const Posed_mesh& s, const std::size_t k) { return k_means(s, s.pose, k); }}};
}

/// Those with the given names, separated by semicolons, or all of them if there are none.
inline std::vector<Segmentation_method> chosen_methods(const std::string& names,
                                                       const bool is_number_given)
{
  std::vector<Segmentation_method> result;
  for(Segmentation_method& method : segmentation_methods())
    if((is_number_given || method.can_choose_number)
       && (names.empty() || (';' + names + ';').find(';' + method.name + ';') != names.npos))
      result.push_back(std::move(method));
  if(result.empty())
    throw std::invalid_argument("--methods names none");
  return result;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_METHODS_H
