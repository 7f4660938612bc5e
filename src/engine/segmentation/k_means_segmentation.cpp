// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "K_means.h"
#include "Random_numbers.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

struct Weighted_centroids
{
  Eigen::MatrixXd centroids; // of the polygons
  Eigen::VectorXd areas;
};

inline Weighted_centroids weighted_centroids(const Point_matrix& points, const Face_list& polygons)
{
  const auto n = static_cast<Eigen::Index>(polygons.size());
  Weighted_centroids result{Eigen::MatrixXd::Zero(n, 3), Eigen::VectorXd::Zero(n)};
  for(Eigen::Index f = 0; f < n; ++f)
  {
    const Face_list::Face polygon = polygons[static_cast<std::size_t>(f)];
    if(polygon.empty())
      throw std::invalid_argument("face " + std::to_string(f) + " has no vertex");
    for(const std::size_t v : polygon)
    {
      if(v >= static_cast<std::size_t>(points.rows()))
        throw std::invalid_argument("face " + std::to_string(f) + " has the invalid vertex "
                                    + std::to_string(v));
      result.centroids.row(f)
        += points.row(static_cast<Eigen::Index>(v)) / static_cast<double>(polygon.size());
    }
  }
  const Triangle_soup soup = triangle_soup(points, polygons);
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
    result.areas[static_cast<Eigen::Index>(soup.face_of_triangle[t])]
      += twice_area(points, soup.triangles[t]);
  return result;
}

} // namespace internal

std::vector<std::size_t> k_means_parts(const Point_matrix& points, const Face_list& polygons,
                                       const Segmentation_options& options,
                                       const K_means_weights weights)
{
  using namespace internal;
  constexpr int number_of_runs = 10;
  if(options.number_of_parts == 0)
    throw std::invalid_argument(
      "option number_of_parts is 0, but k-means cannot determine the number of parts");
  if(polygons.empty())
    throw std::invalid_argument("the surface has no face");
  require_enumerator("weights", weights, K_means_weights::AREAS);
  require_option(options.number_of_threads >= 0, "number_of_threads", options.number_of_threads,
                 ">= 0");
  check_finite(points);
  Point_matrix scaled = points;
  normalize(scaled);
  const Weighted_centroids faces = weighted_centroids(scaled, polygons);
  const bool by_area = weights == K_means_weights::AREAS && faces.areas.sum() > 0;
  K_means k_means(
    by_area ? faces.centroids : Eigen::MatrixXd(scaled),
    by_area ? faces.areas : Eigen::VectorXd::Ones(scaled.rows()).eval(),
    (std::min)(options.number_of_parts,
               static_cast<std::size_t>(by_area ? faces.areas.size() : scaled.rows())));
  Random_numbers random(options.random_seed);
  k_means.run(random, number_of_runs);
  std::map<std::size_t, std::size_t> number_of_cluster;
  std::vector<std::size_t> result;
  for(Eigen::Index f = 0; f < faces.centroids.rows(); ++f)
    result.push_back(number_of_cluster
                       .emplace(k_means.nearest_cluster(faces.centroids.row(f).transpose()),
                                number_of_cluster.size())
                       .first->second);
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
