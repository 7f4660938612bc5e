// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A target based on biharmonic distances, which are smooth and a metric.
// Usage: biharmonic_distances [input.off]

#include <CGAL/Canonical_pose_3/Biharmonic_distances_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace CP = CGAL::Canonical_pose_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    mesh = Canonical_pose_examples::Articulated_figure(2500).make_mesh<Mesh>();
  else if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;

  // Any model of GeodesicDistances_3 can be used for landmarks and target.
  const CP::Biharmonic_distances_3<Mesh> distances(mesh, 60); // 60 eigenfunctions
  const auto fields = CP::farthest_point_landmarks(distances, 40, *vertices(mesh).begin());
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(fields);
  std::cout << "stress of the target: " << builder.stress() << '\n';

  const Eigen::Index p = Eigen::Index(fields.landmarks[0]), q = Eigen::Index(fields.landmarks[1]);
  const double there = fields.distances(q, 0), back = fields.distances(p, 1);
  std::cout << "there " << there << ", back " << back << " (a metric)\n";
  return std::abs(there - back) < 1e-9 * there ? EXIT_SUCCESS : EXIT_FAILURE;
}
