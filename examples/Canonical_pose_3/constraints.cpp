// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A running figure in its canonical pose, and in a Vitruvian pose: arms sideways, legs apart.
// Usage: constraints [prefix of the poses to write, as OFF]

#include <CGAL/Canonical_pose_3/Vertex_constraints_3.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include "Articulated_figure.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Examples = Canonical_pose_examples;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Eigen::Vector3d;

using Vertices = std::vector<Mesh::Vertex_index>;

Vector3d point(const Mesh& mesh, const Mesh::Vertex_index v)
{
  const auto& p = mesh.point(v);
  return {p.x(), p.y(), p.z()};
}

// Every third of the vertices for which `is_inside(point)` holds.
template <class Predicate>
Vertices sample(const Mesh& mesh, const Predicate& is_inside)
{
  Vertices result;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(v % 3 == 0 && is_inside(point(mesh, v)))
      result.push_back(v);
  return result;
}

Vector3d center(const Mesh& mesh, const Vertices& vertices)
{
  Vector3d sum = Vector3d::Zero();
  for(const Mesh::Vertex_index v : vertices)
    sum += point(mesh, v);
  return sum / double(vertices.size());
}

struct Limb
{
  Vertices vertices, joint; // joint: around its inner end
  Vector3d direction;       // in which the limb should point
};

int main(int argc, char* argv[])
{
  const Examples::Articulated_figure figure(5000);
  const Mesh rest = figure.make_mesh<Mesh>(); // the vertices are found on it by their place
  const Mesh running = figure.make_mesh<Mesh>(figure.named_poses()[2].angles);
  const auto trunk = sample(
    rest, [](const Vector3d& p) { return std::abs(p.x()) < 0.15 && p.y() > 0.95 && p.y() < 1.4; });
  std::vector<Limb> limbs;
  for(const double side : {1., -1.})
  {
    const auto near = [&](const Vector3d& c) {
      return sample(rest, [=](const Vector3d& p) { return (p - c).norm() < 0.1; });
    };
    limbs.push_back({sample(rest, [=](const Vector3d& p) { return side * p.x() > 0.3; }),
                     near({0.2 * side, 1.41, 0}), Vector3d(side, 0, 0)});
    limbs.push_back(
      {sample(rest, [=](const Vector3d& p) { return side * p.x() > 0 && p.y() < 0.7; }),
       near({0.12 * side, 0.9, 0}), Vector3d(0.5 * side, -1, 0)});
  }

  CP::Options options;
  options.return_landmark_fields = true;
  Mesh canonical = running;
  const auto first = CGAL::canonical_pose_3(running, canonical.points(), options);
  if(!first.is_usable())
    return EXIT_FAILURE;
  options.given = first; // distances and target are used for both poses

  // Limbs are straight in the canonical pose; each should be as it is there, rotated about
  // its joint.
  CP::Vertex_constraints_3<Mesh> constraints(running);
  for(const Limb& limb : limbs)
  {
    const Vector3d joint = center(canonical, limb.joint);
    const auto turn = Eigen::Quaterniond::FromTwoVectors(center(canonical, limb.vertices) - joint,
                                                         limb.direction);
    for(std::size_t i = 0; i < limb.vertices.size(); ++i)
    {
      const Mesh::Vertex_index p = limb.vertices[i], q = trunk[i % trunk.size()];
      const Vector3d prescribed
        = joint + turn * (point(canonical, p) - joint) - point(canonical, q);
      constraints.add_direction(p, q,
                                Kernel::Vector_3(prescribed.x(), prescribed.y(), prescribed.z()),
                                1 / double(limb.vertices.size()));
    }
  }
  options.constraints = constraints.constraints();
  Mesh vitruvian = running;
  const auto summary = CGAL::canonical_pose_3(running, vitruvian.points(), options).summary;
  std::cout << summary << '\n';
  if(!summary.is_usable())
    return EXIT_FAILURE;

  bool points_there = true;
  for(const Limb& limb : limbs)
  {
    const Vector3d way = center(vitruvian, limb.vertices) - center(vitruvian, limb.joint);
    const double cosine = way.normalized().dot(limb.direction.normalized());
    std::cout << "cosine of the angle to the prescribed direction: " << cosine << '\n';
    points_there = points_there && cosine > 0.9;
  }
  if(argc > 1
     && (!CGAL::IO::write_polygon_mesh(std::string(argv[1]) + "input.off", running)
         || !CGAL::IO::write_polygon_mesh(std::string(argv[1]) + "canonical.off", canonical)
         || !CGAL::IO::write_polygon_mesh(std::string(argv[1]) + "vitruvian.off", vitruvian)))
    return EXIT_FAILURE;
  return points_there ? EXIT_SUCCESS : EXIT_FAILURE;
}
