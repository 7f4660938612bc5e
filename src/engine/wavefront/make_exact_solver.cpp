// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_unfoldable.h"
#include "find_shortest_paths.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Surface_mesh_shortest_path.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

class Exact_solver final : public Distance_solver
{
  using Vertex = Indexed_mesh::Vertex_index;
  using Shortest_path = Surface_mesh_shortest_path<
    Surface_mesh_shortest_path_traits<Indexed_mesh_kernel, Indexed_mesh>>;
  using Way = std::pair<double, Vertex>;

public:
  Exact_solver(const Face_corners& corners, Point_matrix points)
  {
    constexpr double far = 1e3; // by the size: there, the difference of two points is exact
    if(points.rows() > 0)
    {
      const Eigen::RowVector3d first = points.row(0);
      if(first.norm() > far * (points.rowwise() - first).rowwise().norm().maxCoeff())
        points.rowwise() -= first;
    }
    m_exponent = normalize(points);
    if(corners.origins.empty())
      throw std::invalid_argument("the mesh is empty: it has no face");
    std::vector<Index_triangle> triangles;
    for(std::size_t h = 0; h < corners.origins.size(); h += 3)
      triangles.push_back({static_cast<std::size_t>(corners.origins[h]),
                           static_cast<std::size_t>(corners.origins[h + 1]),
                           static_cast<std::size_t>(corners.origins[h + 2])});
    check_faces(triangles, points);
    check_unfoldable(corners, points);
    m_mesh = indexed_mesh(points, triangles);
  }

  Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(m_mesh.num_vertices()),
                           static_cast<Eigen::Index>(sources.size()));
    for_each_index(sources.size(), [&](const std::size_t k) {
      result.col(static_cast<Eigen::Index>(k)) = distance_to_nearest({sources[k]});
    });
    return result;
  }

  Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(
      static_cast<Eigen::Index>(m_mesh.num_vertices()), (std::numeric_limits<double>::infinity)());
    std::vector<Vertex> own_sources;
    for(const Eigen::Index row : sources)
    {
      if(result[row] != 0 && !m_mesh.is_isolated(vertex(row)))
        own_sources.push_back(vertex(row));
      result[row] = 0;
    }
    if(!own_sources.empty())
    {
      find_shortest_paths([&] { find_distances(own_sources, result); });
      go_by_neighbors(result);
    }
    multiply_by_power_of_two(result, m_exponent);
    return result;
  }

private:
  static Vertex vertex(const Eigen::Index row)
  {
    return Vertex(static_cast<Indexed_mesh::size_type>(row));
  }

  // The unfolding divides by the heights of the faces.
  static void check_faces(const std::vector<Index_triangle>& triangles, const Point_matrix& points)
  {
    const auto point = [&](const std::size_t v) {
      const auto row = static_cast<Eigen::Index>(v);
      return Indexed_mesh::Point(points(row, 0), points(row, 1), points(row, 2));
    };
    for(std::size_t f = 0; f < triangles.size(); ++f)
      if(collinear(point(triangles[f][0]), point(triangles[f][1]), point(triangles[f][2])))
        throw Face_defect(f, "is degenerate");
  }

  // Writes the distances found, in the unit of the copy.
  void find_distances(const std::vector<Vertex>& sources, Eigen::VectorXd& distances) const
  {
    Shortest_path paths(m_mesh);
    for(const Vertex source : sources)
      paths.add_source_point(source);
    for(Eigen::Index i = 0; i < distances.size(); ++i)
      if(distances[i] != 0 && !m_mesh.is_isolated(vertex(i)))
      {
        const double distance = paths.shortest_distance_to_source_points(vertex(i)).first;
        if(distance >= 0) // negative: not reached
          distances[i] = distance;
      }
  }

  // Replaces distances that exceed those through a neighbor by more than rounding errors.
  void go_by_neighbors(Eigen::VectorXd& distances) const
  {
    constexpr double most_rounding = 1e-12;
    std::priority_queue<Way, std::vector<Way>, std::greater<Way>> shortened;
    const auto go_on = [&](const Vertex v) {
      for(const auto h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        const Vertex neighbor = m_mesh.source(h);
        const double way = distances[v.idx()] + length(h);
        double& distance = distances[neighbor.idx()];
        if(way < (1 - most_rounding) * distance)
        {
          distance = way;
          shortened.emplace(way, neighbor);
        }
      }
    };
    for(const Vertex v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        go_on(v);
    while(!shortened.empty())
    {
      const auto [way, v] = shortened.top();
      shortened.pop();
      if(way == distances[v.idx()])
        go_on(v);
    }
  }

  double length(const Indexed_mesh::Halfedge_index h) const
  {
    return std::sqrt(
      squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
  }

  int m_exponent = 0; // distances are multiplied by 2 to this power
  Indexed_mesh m_mesh;
};

std::unique_ptr<Distance_solver> make_exact_solver(const Face_corners& corners,
                                                   const Point_matrix& points)
{
  return std::make_unique<Exact_solver>(corners, points);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
