// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "Processor_clock.h"
#include "compute_pose.h" // of the tool
#include "paper_shapes.h"

#include <CGAL/Canonical_pose_3/Biharmonic_distances_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

namespace {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;

// Biharmonic distances, scaled such that they fit geodesic distances best.
CP::Landmark_fields_3 biharmonic_fields(const Point_matrix& points,
                                        const std::vector<std::array<std::size_t, 3>>& triangles,
                                        const std::size_t number, const std::size_t first,
                                        const std::vector<std::size_t>& given_landmarks)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const Mesh mesh = CP::make_triangle_mesh<Mesh>(points, triangles);
  CP::Landmark_fields_3 fields = CP::landmark_fields_function<CP::Biharmonic_distances_3<Mesh>>()(
    points, triangles, number, first, given_landmarks);
  std::vector<Mesh::Vertex_index> landmarks;
  for(const std::size_t v : fields.landmarks)
    landmarks.emplace_back(static_cast<Mesh::size_type>(v));
  const Eigen::MatrixXd geodesic = CP::Heat_geodesics_3<Mesh>(mesh).distances(landmarks);
  const double scale
    = geodesic.cwiseProduct(fields.distances).sum() / fields.distances.squaredNorm();
  fields.distances *= scale;
  fields.covering_radius *= scale;
  return fields;
}

struct Method
{
  std::string key, name;
  CP::Options options;
};

std::vector<Method> methods()
{
  std::vector<Method> result = {{"heat", "heat distances, without rounds", {}},
                                {"rounds", "heat distances, rounds (default)", {}},
                                {"biharmonic", "biharmonic distances, without rounds", {}},
                                {"biharmonic_rounds", "biharmonic distances, rounds", {}},
                                {"unfolding", "unfolding", {}},
                                {"cut", "heat distances, rounds, contacts cut", {}}};
  result[0].options.number_of_rounds = result[2].options.number_of_rounds = 0;
  result[2].options.target_fields_function = result[3].options.target_fields_function
    = biharmonic_fields;
  result[4].options.target_mode = CP::Options::Target_mode::UNFOLDING;
  result[5].options.contacts = CP::Options::Contacts::CUT;
  return result;
}

class Contact
{
public:
  Contact(const std::size_t vertices, std::string prefix)
    : m_figure(vertices), m_apart(mesh_of_figure(m_figure, Articulated_figure::hand_on_knee())),
      m_merged(m_apart), m_prefix(std::move(prefix))
  {
    m_merged.faces = m_figure.merged_triangles();
    const auto& vertices_of_faces = m_merged.faces.vertices();
    const std::set<Eigen::Index> used(vertices_of_faces.begin(), vertices_of_faces.end());
    m_used.assign(used.begin(), used.end());
    write_picture_mesh(m_prefix, "apart", m_apart, points_of_file(m_apart));
    write_picture_mesh(m_prefix, "merged", m_merged, points_of_file(m_merged));
  }

  void print_row(const Method& method) const
  {
    const CP::Result apart = Canonical_pose_tool::compute_pose(m_apart, method.options);
    const Processor_clock clock;
    const CP::Result merged = Canonical_pose_tool::compute_pose(m_merged, method.options);
    const double seconds = clock.seconds();
    std::vector<Point_matrix> poses;
    for(const auto& pose : Articulated_figure::named_poses())
      poses.push_back(
        Canonical_pose_tool::compute_pose(mesh_of_figure(m_figure, pose.angles), method.options)
          .pose);
    std::printf("| %s | %.3f | %.3f | %.3f | %.3f | %.2f |\n", method.name.c_str(),
                difference(*apart.target, *merged.target), difference(apart.pose, merged.pose),
                CP::mean_pose_difference(poses, true), merged.summary.median_edge_strain, seconds);
    std::fflush(stdout);
    write_picture_mesh(m_prefix, "apart_" + method.key, m_apart, apart.pose);
    write_picture_mesh(m_prefix, "merged_" + method.key, m_merged, merged.pose);
    write_picture_mesh(m_prefix, "merged_target_" + method.key, m_merged, *merged.target);
  }

private:
  // Vertices within the contact do not count.
  double difference(const Point_matrix& a, const Point_matrix& b) const
  {
    return CP::pose_difference(a(m_used, Eigen::all), b(m_used, Eigen::all), true);
  }

  Articulated_figure m_figure;
  Mesh_file m_apart, m_merged;
  std::string m_prefix;
  std::vector<Eigen::Index> m_used;
};

} // namespace

void print_contact_table(Argument_list& arguments)
{
  const Contact contact(static_cast<std::size_t>(arguments.take_number("--vertices", 10000)),
                        arguments.take_text("--prefix"));
  arguments.rest();
  std::printf(
    "| | target: merged or apart | pose: merged or apart | poses of five postures | median "
    "edge strain | seconds |\n|---|---|---|---|---|---|\n");
  for(const Method& method : methods())
    contact.print_row(method);
}

} // namespace Canonical_pose_benchmark
