// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "Processor_clock.h"
#include "compute_pose.h" // of the tool
#include "paper_shapes.h"

#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace Canonical_pose_benchmark {

namespace {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;

// The figure with one number of vertices.
class Scalings
{
public:
  // `references`: number of landmarks from whose distances stress is computed. If they are all
  // vertices, classical and least squares scaling of all pairs are added.
  Scalings(const std::size_t vertices, const std::size_t references, const std::string& prefix)
    : m_mesh(
      mesh_of_figure(Articulated_figure(vertices), Articulated_figure::named_poses()[1].angles)),
      m_surface(prepared_surface(m_mesh).components.front().surface),
      m_prefix(prefix + std::to_string(vertices) + "_")
  {
    if(prefix.empty())
      m_prefix.clear();
    m_references = fields(references);
  }

  void print() const
  {
    const Processor_clock clock;
    CP::Landmark_mds_target_builder_3<> landmark;
    landmark.build(fields(80));
    print_row("landmark", "80", landmark.targets(), clock.seconds());
    if(m_references.landmarks.size() == static_cast<std::size_t>(m_surface.points.rows()))
      print_scalings_of_all_pairs();
    if(m_prefix.empty())
      return;
    write_picture_mesh(m_prefix, "input", m_mesh, m_surface.points);
    write_picture_mesh(m_prefix, "pose", m_mesh,
                       Canonical_pose_tool::compute_pose(m_mesh, CP::Options()).pose);
  }

private:
  CP::Landmark_fields_3 fields(const std::size_t number) const
  {
    CP::Options options;
    options.number_of_landmarks = number;
    return CP::landmark_fields(m_surface, options);
  }

  void print_scalings_of_all_pairs() const
  {
    const Processor_clock clock;
    CP::Landmark_mds_target_builder_3<> classical;
    const CP::Landmark_fields_3 all = fields(m_references.landmarks.size());
    classical.build(all);
    print_row("classical", "all", classical.targets(), clock.seconds());
    CP::Smacof_target_builder_3 least_squares(0); // from that, whose time is included
    least_squares.build(all, classical.targets(), Eigen::VectorXd::Ones(m_surface.points.rows()));
    print_row("least_squares", "all", least_squares.targets(), clock.seconds());
  }

  void print_row(const std::string& name, const std::string& landmarks, const Point_matrix& target,
                 const double seconds) const
  {
    std::printf("| %s | %zu | %s | %.3f | %.2f |\n", name.c_str(), m_mesh.points.size(),
                landmarks.c_str(), stress(target), seconds);
    std::fflush(stdout);
    const Eigen::VectorXd shares = CP::vertex_area_shares(m_surface.points, m_surface.triangles);
    const bool is_mirrored
      = CP::target_handedness(target, m_surface.points, m_surface.triangles, shares)
          .is_mirror_image();
    write_picture_mesh(m_prefix, name, m_mesh,
                       CP::align_target(target, m_surface.points, shares, is_mirrored));
  }

  // At the best scale.
  double stress(const Point_matrix& target) const
  {
    double dd = 0, dg = 0, gg = 0;
    for(Eigen::Index j = 0; j < m_references.distances.cols(); ++j)
    {
      const auto landmark
        = static_cast<Eigen::Index>(m_references.landmarks[static_cast<std::size_t>(j)]);
      const Eigen::VectorXd d = (target.rowwise() - target.row(landmark)).rowwise().norm();
      dd += d.squaredNorm();
      dg += d.dot(m_references.distances.col(j));
      gg += m_references.distances.col(j).squaredNorm();
    }
    return std::sqrt((gg - dg * dg / dd) / gg);
  }

  Mesh_file m_mesh;
  CP::Surface_component_3 m_surface;
  std::string m_prefix;
  CP::Landmark_fields_3 m_references;
};

} // namespace

void print_scalings_table(Argument_list& arguments)
{
  const auto low = static_cast<std::size_t>(arguments.take_number("--vertices", 2000));
  const auto high = static_cast<std::size_t>(arguments.take_number("--high", 53000));
  const std::string prefix = arguments.take_text("--prefix");
  arguments.rest();
  std::printf("| scaling | vertices | landmarks | stress | seconds |\n|---|---|---|---|---|\n");
  Scalings(low, low, prefix).print();
  Scalings(high, 500, prefix).print();
}

} // namespace Canonical_pose_benchmark
