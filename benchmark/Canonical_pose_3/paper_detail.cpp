// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "paper_shapes.h"

#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

namespace {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;

constexpr std::array<double, 7> DETAIL_LENGTHS = {0.025, 0.035, 0.05, 0.07, 0.1, 0.2, 0.4};
constexpr std::array<const char*, 2> KINDS = {"without", "with"}; // rounds

// What poses of one mesh have in common.
struct Prepared_shape
{
  explicit Prepared_shape(const Mesh_file& mesh)
    : prepared(prepared_surface(mesh)), coarse(CP::coarse_surface(surface())),
      fields(CP::landmark_fields(coarse)), target(CP::mds_target(surface(), coarse, fields)),
      body(CP::surface_body(surface(), coarse, fields))
  {}

  const CP::Surface_component_3& surface() const { return prepared.components.front().surface; }

  CP::Prepared_surface_3 prepared;
  CP::Coarse_surface_3 coarse;
  CP::Landmark_fields_3 fields;
  CP::Target_3 target;
  CP::Surface_body_3 body;
};

struct Setting
{
  std::vector<Point_matrix> poses;
  double sum_of_strains = 0;
};

} // namespace

void print_detail_table(Argument_list& arguments)
{
  const auto vertices = static_cast<std::size_t>(arguments.take_number("--vertices", 10000));
  const std::vector<std::string> files = arguments.rest();
  std::vector<Mesh_file> meshes;
  for(const std::string& file : files)
    meshes.push_back(Canonical_pose_tool::read_mesh_file(file));
  if(files.empty())
  {
    const Articulated_figure figure(vertices);
    for(const auto& pose : Articulated_figure::named_poses())
      meshes.push_back(mesh_of_figure(figure, pose.angles));
  }

  std::array<std::array<Setting, DETAIL_LENGTHS.size()>, KINDS.size()> settings;
  for(const Mesh_file& mesh : meshes)
  {
    const Prepared_shape shape(mesh);
    for(std::size_t k = 0; k < KINDS.size(); ++k)
      for(std::size_t i = 0; i < DETAIL_LENGTHS.size(); ++i)
      {
        CP::Component_options options = shape.prepared.components.front().options;
        options.registration.detail_length = DETAIL_LENGTHS[i];
        if(k == 0)
          options.number_of_rounds = 0;
        const CP::Result result = CP::registered_pose(shape.surface(), shape.coarse, shape.fields,
                                                      shape.target, shape.body, options);
        settings[k][i].poses.push_back(CP::joined_result(shape.prepared, {result}).pose);
        settings[k][i].sum_of_strains += result.summary.median_edge_strain;
      }
  }
  std::printf("| rounds | detail length | mean difference of %zu poses | median edge strain |\n"
              "|---|---|---|---|\n",
              meshes.size());
  for(std::size_t k = 0; k < KINDS.size(); ++k)
    for(std::size_t i = 0; i < DETAIL_LENGTHS.size(); ++i)
      std::printf("| %s | %g | %.4f | %.4f |\n", KINDS[k], DETAIL_LENGTHS[i],
                  CP::mean_pose_difference(settings[k][i].poses, true),
                  settings[k][i].sum_of_strains / static_cast<double>(meshes.size()));
}

} // namespace Canonical_pose_benchmark
