// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paper_tables.h"

#include "Child_process.h"
#include "Processor_clock.h"
#include "compute_pose.h" // of the tool
#include "paper_shapes.h"

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

namespace {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;

struct Row_of_the_paper
{
  const char* mesh;
  std::size_t vertices;
  double seconds;
};

// Section 8; the last one is the method of Lian et al. on another computer.
constexpr Row_of_the_paper ROWS[] = {{"SCAPE", 12500, 20},
                                     {"TOSCA", 53000, 53},
                                     {"chair", 10000, 15},
                                     {"ant", 5000, 7},
                                     {"ant, Lian et al.", 5000, 243}};

void print_row(const std::string& name, const Mesh_file& mesh)
{
  std::printf("| %s | %zu |", name.c_str(), mesh.points.size());
  CP::Options paper, single;
  paper.kernel = CP::Options::Kernel::UNCENTERED_GAUSSIAN;
  paper.paper_weights = CP::Paper_weights();
  single.number_of_rounds = 0;
  for(const CP::Options& options : {paper, single, CP::Options()})
  {
    // A process of its own shows the memory of this mesh alone.
    Child_process child(
      [&] {
        const Processor_clock clock;
        Canonical_pose_tool::compute_pose(mesh, options);
        return std::to_string(clock.seconds());
      },
      Limits());
    child.wait();
    if(child.ending() == Child_process::RETURNED)
      std::printf(" %.2f | %.0f |", std::stod(child.output()), child.peak_megabytes());
    else
      std::printf(" %s | |", child.description().c_str());
    std::fflush(stdout);
  }
  std::printf("\n");
}

} // namespace

void print_times_table(Argument_list& arguments)
{
  const std::vector<std::string> files = arguments.rest();
  std::printf("| mesh of the paper | vertices | its seconds |\n|---|---|---|\n");
  for(const Row_of_the_paper& row : ROWS)
    std::printf("| %s | %zu | %.0f |\n", row.mesh, row.vertices, row.seconds);
  std::printf("\n| mesh | vertices | paper's weights: seconds | MB | without rounds: seconds | MB "
              "| default: seconds | MB |\n|---|---|---|---|---|---|---|---|\n");
  for(const std::size_t vertices : {12500, 53000, 10000, 5000})
    if(files.empty())
      print_row("figure, sitting", mesh_of_figure(Articulated_figure(vertices),
                                                  Articulated_figure::named_poses()[1].angles));
  for(const std::string& file : files)
    print_row(stem_of(file), Canonical_pose_tool::read_mesh_file(file));
}

} // namespace Canonical_pose_benchmark
