// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command pose.

#include "Output_files.h"
#include "Report.h"
#include "Stance_file.h"
#include "command_options.h"
#include "commands.h"
#include "compute_pose.h"
#include "method_options.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <Eigen/Core>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// The numbers in a file; none if there is no file.
Eigen::VectorXd numbers_of(const std::string& path)
{
  const std::vector<double> numbers = path.empty() ? std::vector<double>() : read_numbers(path);
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

// The vertices to which rows of fields and targets correspond: those of a surface, or of the
// boundary of a tetrahedral mesh.
std::size_t number_of_rows(const Mesh_file& input)
{
  return (input.is_tetrahedral ? boundary_of(input) : input).points.size();
}

Point_matrix given_target(const std::string& path, const Mesh_file& input)
{
  const Mesh_file target = read_other_mesh_file(path);
  const std::size_t n = number_of_rows(input);
  if(target.points.size() != n)
    throw std::invalid_argument("'" + path + "' has " + std::to_string(target.points.size())
                                + " vertices, but a target has " + std::to_string(n));
  return matrix_of(points_of(target));
}

CGAL::Canonical_pose_3::Landmark_fields_3 given_fields(const std::string& path,
                                                       const Mesh_file& input)
{
  const std::vector<double> numbers = read_numbers(path);
  const std::size_t n = number_of_rows(input);
  if(n == 0 || numbers.size() % n != 0)
    throw std::invalid_argument("'" + path + "' has " + std::to_string(numbers.size())
                                + " numbers, which is no multiple of the " + std::to_string(n)
                                + " vertices");
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  try
  {
    return CGAL::Canonical_pose_3::landmark_fields(Rows::Map(
      numbers.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(numbers.size() / n)));
  }
  catch(const std::invalid_argument& error)
  {
    throw std::invalid_argument("'" + path + "': " + error.what());
  }
}

// The pose. What is wrong with a direction of a limb is told by its line.
Result pose_in(const std::optional<Stance_file>& stance, const Mesh_file& input,
               const Options& options)
try
{
  return compute_pose(input, options);
}
catch(const CGAL::Canonical_pose_3::Limb_direction_error& error)
{
  throw stance->error(error);
}

void add_pose_options(Command_options& o)
{
  add_input(o);
  add_output(o, "the pose: INPUT's vertices and faces or cells",
             {"off", "obj", "ply", "stl", "glb", "mesh", "vtu"});
  add_path(o, "--target", o.arguments.target, "also write the target of the registration");
  add_path(o, "--scene", o.arguments.scene,
           "also write input, target and pose in one file, with an animation (.glb)");
  add_path(o, "--matching-weights", o.arguments.matching_weights,
           "file of factors of the matching weights, one per vertex");
  add_path(o, "--stiffness", o.arguments.stiffness,
           "file of factors of the stiffness, one per vertex of a surface, or per tetrahedron");
  add_path(o, "--given-target", o.arguments.given_target,
           "take this target, as --target writes it, instead of computing one");
  add_path(o, "--given-distances", o.arguments.given_distances,
           "take these geodesic distances, as geodesics writes them, for the first target");
  add_constraints(o);
  add_stance(o);
  add_method_option(o, "frame");
  add_report(o);
  add_method_options(o);
}

// Throws Usage_error if the outputs cannot have the formats of their extensions.
void check_formats(const Arguments& arguments)
{
  const bool is_tetrahedral = format_of(arguments.input) == Format::MEDIT;
  const auto holds_tetrahedra = [](const std::string& path) {
    const Format format = format_of_output(path);
    return format == Format::MEDIT || format == Format::VTU;
  };
  if(is_tetrahedral != holds_tetrahedra(arguments.output))
    throw Usage_error(
      is_tetrahedral
        ? "the pose of a tetrahedral mesh (.mesh) must also be tetrahedral (.mesh, .vtu)"
        : "the pose of a surface cannot be a tetrahedral mesh (.mesh, .vtu)");
  if(!arguments.target.empty() && holds_tetrahedra(arguments.target))
    throw Usage_error("the target is a surface and cannot be a tetrahedral mesh (.mesh, .vtu)");
  if(!arguments.scene.empty()
     && (extension_of(arguments.scene) != ".glb"
         || format_of_output(arguments.scene) != Format::GLB))
    throw Usage_error("'" + arguments.scene + "' is not a .glb file");
  if(is_tetrahedral && arguments.options.body != Options::Body::AUTOMATIC)
    throw Usage_error("--body: a tetrahedral mesh is its own body");
}

int run_pose(Arguments& arguments)
{
  Stage_clock clock;
  if(arguments.output == "-")
    arguments.output += extension_of_format(written_format(format_of(arguments.input)));
  check_formats(arguments);
  std::vector<std::string> inputs
    = {arguments.stance_file, arguments.matching_weights, arguments.stiffness,
       arguments.given_target, arguments.given_distances};
  const bool is_replaced = is_same_file(arguments.input, arguments.output);
  if(!is_replaced)
    inputs.push_back(arguments.input);
  const std::vector<std::string> outputs
    = {arguments.output, arguments.target, arguments.scene, arguments.report};
  Output_files files(outputs, inputs, is_replaced ? arguments.input : std::string());
  std::optional<Stance_file> stance;
  if(!arguments.stance_file.empty())
    stance.emplace(arguments.stance_file).set(arguments.options);
  Mesh_file input = read_mesh_file(arguments.input, Source::KEPT);
  const bool is_shown = !arguments.target.empty() || !arguments.scene.empty()
                        || !is_rewritable(input, format_of(arguments.output));
  if(is_shown)
    load_appearance(input);
  check_format_holds(format_of(arguments.output), input);
  if(!arguments.target.empty())
    check_format_holds(format_of(arguments.target), input);
  arguments.options.matching_weights = numbers_of(arguments.matching_weights);
  arguments.options.stiffness = numbers_of(arguments.stiffness);
  if(!arguments.given_target.empty())
    arguments.options.given.target = given_target(arguments.given_target, input);
  if(!arguments.given_distances.empty())
    arguments.options.given.landmark_fields = given_fields(arguments.given_distances, input);
  const double seconds_to_read = clock.lap();

  arguments.say("computing the pose");
  Result result = pose_in(stance, input, watched_options(arguments));
  CGAL::Canonical_pose_3::Registration_summary& summary = result.summary;
  summary.stages.insert(summary.stages.begin(), {"read", seconds_to_read});
  const bool has_skin = result.skeleton && format_of(arguments.output) == Format::GLB;
  if(has_skin && !is_shown) // the output is a new file
    load_appearance(input);
  clock.lap();

  arguments.say("writing " + arguments.output);
  files.write_with_files(arguments.output, [&](std::ostream& out, Companion_files* const beside) {
    write_pose(out, format_of(arguments.output), input, result.pose, beside, result.skeleton);
  });
  files.write_with_files(arguments.target, [&](std::ostream& out, Companion_files* const beside) {
    const Mesh_file surface = input.is_tetrahedral ? boundary_of(input) : input;
    write_mesh(out, format_of(arguments.target), with_points(surface, *result.target), beside);
  });
  add_losses_of_file(summary.warnings, "the pose", input, arguments.output, has_skin);
  if(!arguments.target.empty())
    add_losses_of_file(summary.warnings, "the target", input, arguments.target, true);
  if(!arguments.scene.empty())
    add_losses_of_shown(summary.warnings, "the scene lacks", input, arguments.scene, true);
  files.write(arguments.scene, [&](std::ostream& out) {
    write_glb(
      out, shown_pose(input, result,
                      stance ? stance->name() : method_option("stance").value(arguments.options)));
  });
  summary.add_seconds("write", clock.lap());
  files.write(arguments.report, [&](std::ostream& out) {
    write_report(out, summary, clock.total(), result.skeleton);
  });
  files.commit();
  arguments.say("");
  if(!arguments.quiet)
    write_outcome(messages_beside(outputs), summary);
  return EXIT_SUCCESS;
}

} // namespace

const Command POSE_COMMAND
  = {"pose",
     "brings a shape into its canonical pose",
     {"pose man.obj -o pose.obj", "pose man.ply -o pose.ply --scene man.glb --report man.json"},
     add_pose_options,
     run_pose};

} // namespace Canonical_pose_tool
