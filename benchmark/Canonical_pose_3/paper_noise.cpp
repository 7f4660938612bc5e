// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "Processor_clock.h"
#include "paper_shapes.h"

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

namespace {

namespace CP = CGAL::Canonical_pose_3;

constexpr std::array<double, 5> LEVELS = {1, 5, 10, 20, 50}; // rho
constexpr std::array<double, 5> OF_THE_PAPER = {0.09, 0.12, 0.17, 0.70, 1.96};

// The standard does not specify its distributions to the bit.
class Uniform_numbers
{
public:
  explicit Uniform_numbers(const std::uint64_t seed) : m_generator(seed) {}
  double operator()() { return std::ldexp(static_cast<double>(m_generator() >> 11), -53); }

  Eigen::RowVector3d direction()
  {
    const double z = 2 * (*this)() - 1, angle = 2 * CGAL_PI * (*this)();
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

private:
  std::mt19937_64 m_generator;
};

double mean_edge_length(const CP::Surface_component_3& surface)
{
  double sum = 0; // each edge counts once per triangle
  for(const auto& t : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      sum += (surface.points.row(static_cast<Eigen::Index>(t[k]))
              - surface.points.row(static_cast<Eigen::Index>(t[(k + 1) % 3])))
               .norm();
  return sum / (3 * static_cast<double>(surface.triangles.size()));
}

// Noise along the normals, and shot noise in random directions; both displacements of each vertex are
// random numbers between 0 and `bound`.
CP::Surface_component_3 with_noise(CP::Surface_component_3 surface, const double bound,
                                   const std::uint64_t seed)
{
  const Point_matrix normals = CP::vertex_normals(surface.points, surface.triangles);
  Uniform_numbers random(seed);
  for(Eigen::Index v = 0; v < surface.points.rows(); ++v)
  {
    surface.points.row(v) += bound * random() * normals.row(v);
    surface.points.row(v) += bound * random() * random.direction();
  }
  return surface;
}

double hausdorff_distance(const Point_matrix& a, const Point_matrix& b,
                          const std::vector<std::array<std::size_t, 3>>& triangles)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Mesh meshes[2]
    = {CP::make_triangle_mesh<Mesh>(a, triangles), CP::make_triangle_mesh<Mesh>(b, triangles)};
  double result = 0;
  for(const int k : {0, 1})
    result = (std::max)(result, PMP::max_distance_to_triangle_mesh<CGAL::Parallel_if_available_tag>(
                                  meshes[k].points(), meshes[1 - k]));
  return result;
}

struct Method
{
  std::string name;
  CP::Options options;
};

std::vector<Method> methods()
{
  Method paper{"paper's weights", {}};
  paper.options.kernel = CP::Options::Kernel::UNCENTERED_GAUSSIAN;
  paper.options.paper_weights = CP::Paper_weights();
  Method single{"without rounds", {}};
  single.options.number_of_rounds = 0;
  return {paper, single, {"default", {}}};
}

// One shape by one method.
class Unfolding
{
public:
  Unfolding(const Mesh_file& mesh, const CP::Options& options)
    : m_component(prepared_surface(mesh, options).components.front()),
      m_coarse(CP::coarse_surface(surface(), this->options())),
      m_fields(CP::landmark_fields(m_coarse, this->options())),
      m_body(CP::surface_body(surface(), m_coarse, m_fields, this->options())),
      m_pose(pose_for(m_coarse, m_fields))
  {}

  const CP::Surface_component_3& surface() const { return m_component.surface; }
  const CP::Component_options& options() const { return m_component.options; }

  // By the largest distance.
  double distance_with(const CP::Surface_component_3& noisy) const
  {
    const CP::Coarse_surface_3 coarse = CP::coarse_surface(noisy, options());
    return hausdorff_distance(m_pose, pose_for(coarse, CP::landmark_fields(coarse, options())),
                              surface().triangles)
           / length_scale();
  }

private:
  double length_scale() const { return m_fields.distances.maxCoeff(); }

  // Distances are scaled such that the largest one is that of the surface.
  Point_matrix pose_for(const CP::Coarse_surface_3& coarse, CP::Landmark_fields_3 fields) const
  {
    fields.distances *= length_scale() / fields.distances.maxCoeff();
    const CP::Target_3 target = CP::mds_target(surface(), coarse, fields, options());
    const CP::Result result
      = CP::registered_pose(surface(), m_coarse, m_fields, target, m_body, options());
    if(!result.is_usable())
      throw std::runtime_error("the registration met numbers that are not finite");
    Point_matrix pose(surface().points.rows(), 3);
    for(std::size_t v = 0; v < m_body.surface_vertices.size(); ++v)
      pose.row(static_cast<Eigen::Index>(v))
        = result.pose.row(static_cast<Eigen::Index>(m_body.surface_vertices[v]));
    return pose;
  }

  CP::Prepared_surface_3::Component m_component;
  CP::Coarse_surface_3 m_coarse;
  CP::Landmark_fields_3 m_fields;
  CP::Surface_body_3 m_body;
  Point_matrix m_pose;
};

} // namespace

void print_noise_table(Argument_list& arguments)
{
  const bool verbose = arguments.take_flag("--verbose");
  if(arguments.rest().empty())
    throw std::invalid_argument("noise needs mesh files");
  std::printf("| poses of %zu shapes |", arguments.rest().size());
  for(const double rho : LEVELS)
    std::printf(" rho = %.0f |", rho);
  std::printf(" seconds |\n|---|---|---|---|---|---|---|\n| paper |");
  for(const double distance : OF_THE_PAPER)
    std::printf(" %.2f |", distance);
  std::printf(" |\n");
  for(const Method& method : methods())
  {
    const Processor_clock clock;
    std::array<double, LEVELS.size()> sum{}, largest{};
    for(const std::string& file : arguments.rest())
    {
      const Unfolding unfolding(Canonical_pose_tool::read_mesh_file(file), method.options);
      const double edge = mean_edge_length(unfolding.surface());
      for(std::size_t i = 0; i < LEVELS.size(); ++i)
      {
        const double distance
          = unfolding.distance_with(with_noise(unfolding.surface(), LEVELS[i] * edge, 1 + i));
        if(verbose)
          std::fprintf(stderr, "%s, %s, rho = %.0f: %.4f\n", method.name.c_str(),
                       stem_of(file).c_str(), LEVELS[i], distance);
        sum[i] += distance;
        largest[i] = (std::max)(largest[i], distance);
      }
    }
    std::printf("| %s, mean |", method.name.c_str());
    for(const double s : sum)
      std::printf(" %.3f |", s / static_cast<double>(arguments.rest().size()));
    std::printf(" %.0f |\n| %s, largest |", clock.seconds(), method.name.c_str());
    for(const double d : largest)
      std::printf(" %.3f |", d);
    std::printf(" |\n");
    std::fflush(stdout);
  }
}

} // namespace Canonical_pose_benchmark
