// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command match.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "compute_pose.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"
#include "formats/Shortest_numbers.h"

#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/transfer_attributes.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace CP = CGAL::Canonical_pose_3;

// What of OTHER is transferred to INPUT, instead of the positions.
enum class Transfer { NONE, POSE, COLORS, TEXTURE, LABELS };

Transfer transfer_of(const Arguments& arguments)
{
  const std::string& name = arguments.transfer;
  return name.empty()        ? Transfer::NONE
         : name == "pose"    ? Transfer::POSE
         : name == "colors"  ? Transfer::COLORS
         : name == "texture" ? Transfer::TEXTURE
                             : Transfer::LABELS;
}

void add_match_options(Command_options& o)
{
  add_input(o, Shapes::SURFACES);
  add_path(o, "OTHER", o.arguments.other, "the surface with which it is matched")->required();
  add_output(
    o,
    "where the vertices of INPUT are on OTHER: a line each (.txt), or INPUT in the shape of OTHER",
    {"txt", "off", "obj", "ply", "stl", "glb"});
  add_path(o, "--map", o.arguments.map, "also writes where the vertices are, a line each");
  add_path(o, "--transfer", o.arguments.transfer,
           "instead, write INPUT in the posture of OTHER (pose), or with its colors or texture, or "
           "with the labels of its faces, a line each in FILE")
    ->type_name("pose|colors|texture|FILE");
  o.app.add_flag("--mirror", o.arguments.is_mirrored, "mirror OTHER first, from x to -x");
  add_given_pose(o);
  add_path(o, "--other-pose", o.arguments.other_pose, "the same for OTHER")->excludes("--mirror");
  o.app
    .add_option("--landmark", o.raw.landmarks,
                "I,J: vertex I of INPUT matches vertex J of OTHER; may be repeated")
    ->allow_extra_args(false);
  add_report(o);
  add_method_options_for_each_component(o);
}

// `name` stands before messages, if it is not that of INPUT.
CP::Matchable_surface_3 prepared(const Mesh_file& mesh, const std::string& pose,
                                 const std::string& name, const Arguments& arguments,
                                 std::vector<std::string>& warnings)
try
{
  check_is_surface(mesh);
  const Point_matrix points = matrix_of(points_of(mesh));
  if(!pose.empty())
    return {points, mesh.faces, matrix_of(points_of(read_other_mesh_file(pose)))};
  const Result result = compute_pose(mesh, watched_options(arguments));
  for(const std::string& warning : result.summary.warnings)
    warnings.push_back("the pose" + (name.empty() ? "" : " of " + name) + ": " + warning);
  return {points, mesh.faces, result.pose};
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument((name.empty() ? "" : name + ": ") + error.what());
}

// From x to -x; faces stay the right way round.
void mirror(Mesh_file& mesh)
{
  for(std::array<double, 3>& point : mesh.points)
    point[0] = -point[0];
  Face_list faces;
  for(const Face_list::Face face : mesh.faces)
  {
    std::vector<std::size_t> corners(face.begin(), face.end());
    std::reverse(corners.begin(), corners.end());
    faces.push_back(corners);
  }
  std::vector<std::array<float, 2>>& coordinates = mesh.appearance.texture_coordinates;
  auto corner = coordinates.begin();
  if(!coordinates.empty())
    for(const Face_list::Face face : mesh.faces)
    {
      const auto first = corner;
      corner += static_cast<std::ptrdiff_t>(face.size());
      std::reverse(first, corner);
    }
  mesh.faces = std::move(faces);
}

void write_locations(std::ostream& out, const CP::Surface_match_3& match)
{
  use_shortest_numbers(out);
  for(const auto& [face, vertices, weights] : match.locations)
  {
    out << face;
    for(const std::size_t v : vertices)
      out << ' ' << v;
    for(const double weight : weights)
      out << ' ' << weight;
    out << '\n';
  }
}

// INPUT in the posture of OTHER: registered, with its own size and details, to where its vertices are, around their center.
Point_matrix in_posture(const Mesh_file& input, const Mesh_file& other,
                        const CP::Surface_match_3& match, const Arguments& arguments)
{
  Options options = watched_options(arguments);
  options.target_mode = Options::Target_mode::MDS;
  options.frame = Options::Frame::INPUT;
  const Point_matrix places = match.interpolated(matrix_of(points_of(other)));
  const Eigen::RowVector3d center = places.colwise().mean();
  options.given.target = (match.scale * (places.rowwise() - center)).rowwise() + center;
  return compute_pose(input, options).pose;
}

Mesh_file colored(Mesh_file mesh, const Mesh_file& other, const CP::Surface_match_3& match)
{
  const Appearance& of_other = other.appearance;
  const bool has_opacities = !of_other.vertex_opacities.empty();
  Eigen::MatrixXd values(static_cast<Eigen::Index>(other.points.size()), has_opacities ? 4 : 3);
  for(std::size_t v = 0; v < other.points.size(); ++v)
    for(Eigen::Index k = 0; k < values.cols(); ++k)
      values(static_cast<Eigen::Index>(v), k)
        = k < 3 ? of_other.vertex_colors[v][static_cast<std::size_t>(k)]
                : of_other.vertex_opacities[v];
  values = match.interpolated(values);
  const auto byte = [&](const Eigen::Index v, const Eigen::Index k) {
    return static_cast<unsigned char>(std::lround(values(v, k)));
  };
  mesh.appearance = {};
  for(Eigen::Index v = 0; v < values.rows(); ++v)
  {
    mesh.appearance.vertex_colors.push_back({byte(v, 0), byte(v, 1), byte(v, 2)});
    if(has_opacities)
      mesh.appearance.vertex_opacities.push_back(byte(v, 3));
  }
  return mesh;
}

Mesh_file textured(Mesh_file mesh, const Mesh_file& other, const CP::Surface_match_3& match)
{
  const Appearance& of_other = other.appearance;
  mesh.appearance = {};
  mesh.appearance.texture_coordinates = CP::transferred_texture_coordinates(
    match, mesh.faces, matrix_of(points_of(other)), other.faces, of_other.texture_coordinates);
  mesh.appearance.materials = of_other.materials;
  if(of_other.has_materials())
    for(const std::size_t face :
        CP::matched_faces(match, mesh.faces, matrix_of(points_of(other)), other.faces))
      mesh.appearance.material_of_face.push_back(of_other.material_of_face[face]);
  return mesh;
}

std::vector<std::size_t> labels_of(const std::string& path, const Mesh_file& other)
{
  const std::vector<double> numbers = read_numbers(path);
  if(numbers.size() != other.faces.size())
    throw std::invalid_argument("'" + path + "' has " + std::to_string(numbers.size())
                                + " labels, but OTHER has " + std::to_string(other.faces.size())
                                + " faces");
  std::vector<std::size_t> result;
  for(std::size_t f = 0; f < numbers.size(); ++f)
  {
    constexpr double limit = 1e9;
    if(!(numbers[f] >= 0 && numbers[f] <= limit && numbers[f] == std::floor(numbers[f])))
      throw std::invalid_argument("'" + path + "': the label of face " + std::to_string(f)
                                  + " is not an integer from 0 to 1000000000");
    result.push_back(static_cast<std::size_t>(numbers[f]));
  }
  return result;
}

std::vector<std::size_t> transferred(const std::vector<std::size_t>& labels, const Mesh_file& mesh,
                                     const Mesh_file& other, const CP::Surface_match_3& match)
{
  std::vector<std::size_t> result;
  for(const std::size_t face :
      CP::matched_faces(match, mesh.faces, matrix_of(points_of(other)), other.faces))
    result.push_back(labels[face]);
  return result;
}

// Throws Usage_error if the output cannot hold what is written.
void check_output(const std::string& output, const Transfer transfer)
{
  static const std::map<Transfer, std::vector<std::string>> extensions
    = {{Transfer::NONE, {".txt", ".off", ".obj", ".ply", ".stl", ".glb"}},
       {Transfer::POSE, {".off", ".obj", ".ply", ".stl", ".glb"}},
       {Transfer::COLORS, {".off", ".obj", ".ply", ".glb"}},
       {Transfer::TEXTURE, {".obj", ".ply", ".glb"}},
       {Transfer::LABELS, {".txt", ".ply", ".glb"}}};
  const std::string extension = is_text(output) ? ".txt" : extension_of(output);
  const std::vector<std::string>& known = extensions.at(transfer);
  if(std::find(known.begin(), known.end(), extension) != known.end())
    return;
  throw Usage_error("'" + output + "' cannot be written: the result has one of the extensions "
                    + boost::algorithm::join(known, ", "));
}

// Whether what is written is the file of INPUT with other positions.
bool is_input_rewritten(const Arguments& arguments)
{
  const Transfer transfer = transfer_of(arguments);
  return !is_text(arguments.output) && (transfer == Transfer::NONE || transfer == Transfer::POSE);
}

// What is transferred has to be there.
void check_other(const Mesh_file& other, const Arguments& arguments)
{
  const Transfer transfer = transfer_of(arguments);
  if(transfer == Transfer::COLORS && other.appearance.vertex_colors.empty())
    throw std::invalid_argument("'" + arguments.other + "' has no colors of vertices");
  if(transfer == Transfer::TEXTURE && other.appearance.texture_coordinates.empty())
    throw std::invalid_argument("'" + arguments.other + "' has no texture coordinates");
}

std::vector<std::string> warnings_of(const Mesh_file& input, const Mesh_file& other,
                                     const CP::Surface_match_3& match, const Arguments& arguments)
{
  constexpr double largest_round_trip = .05, largest_distance = .25, largest_strain = .25,
                   largest_strain_of_distance = 3, least_share = .9;
  const Transfer transfer = transfer_of(arguments);
  std::vector<std::string> result;
  if(is_input_rewritten(arguments))
    add_losses_of_file(result, "the surface", input, arguments.output);
  if(transfer == Transfer::COLORS || transfer == Transfer::TEXTURE)
    add_losses(result, "the surface lacks", losses(input, format_of(arguments.output), false));
  if(transfer == Transfer::LABELS && !is_text(arguments.output))
    add_losses_of_shown(result, "the surface lacks", input, arguments.output, false);
  if(transfer == Transfer::COLORS || transfer == Transfer::TEXTURE)
  {
    std::vector<std::string> lost
      = losses(other, format_of(arguments.output), false, has_files_beside(arguments.output));
    std::set<std::string> transferred = {OPACITY_OF_COLORS};
    if(transfer == Transfer::TEXTURE)
    {
      transferred = other.appearance.missing;
      transferred.insert(
        {"materials", "colors of materials", "names of materials", OTHER_MAPS, OTHER_PROPERTIES});
    }
    const auto is_other = [&](const std::string& name) { return transferred.count(name) == 0; };
    lost.erase(std::remove_if(lost.begin(), lost.end(), is_other), lost.end());
    add_losses(result, "the surface lacks", lost, "OTHER");
  }
  if(match.mean_round_trip > largest_round_trip)
    result.push_back(HARDLY_MATCH + std::string(": points return far from where they were"));
  else if(match.mean_distance > largest_distance)
    result.push_back(HARDLY_MATCH + std::string(": their poses are far from each other"));
  else if(match.edge_strain
          > (std::max)(largest_strain, largest_strain_of_distance * match.mean_distance))
    result.push_back(HARDLY_MATCH
                     + std::string(": lengths differ, although the poses are near each other"));
  if(!match.is_rotation_certain)
    result.push_back(OTHER_ROTATION + std::string(": front and back may be confused"));
  for(const auto& [share, path] : {std::make_pair(match.compared_share, arguments.input),
                                   std::make_pair(match.compared_share_of_other, arguments.other)})
    if(share < least_share)
      result.push_back(PARTLY_COMPARED + (' ' + name_of_input(path))
                       + " is compared: " + std::to_string(std::lround(100 * share))
                       + " percent of its area, the largest component and those near it");
  return result;
}

// Without its file, so that it is written anew.
Mesh_file without_source(Mesh_file mesh)
{
  mesh.source.reset();
  return mesh;
}

int run_match(Arguments& arguments)
{
  Stage_clock clock;
  const std::string& output = arguments.output;
  const Transfer transfer = transfer_of(arguments);
  check_output(output, transfer);
  const std::vector<std::string> outputs = {output, arguments.map, arguments.report};
  Output_files files(outputs,
                     {arguments.input, arguments.other, arguments.pose, arguments.other_pose,
                      transfer == Transfer::LABELS ? arguments.transfer : std::string()});
  const bool is_dressed = transfer == Transfer::COLORS || transfer == Transfer::TEXTURE;
  Mesh_file input
    = read_mesh_file(arguments.input, is_text(output) ? Source::DROPPED : Source::KEPT);
  if(is_input_rewritten(arguments))
    load_appearance_for(input, format_of(output));
  else if(!is_text(output) && !is_dressed)
    load_appearance(input);
  if(!is_text(output))
    check_format_holds(format_of(output), input);
  Mesh_file other
    = read_other_mesh_file(arguments.other, is_dressed ? Source::KEPT : Source::DROPPED);
  if(is_dressed)
    load_appearance(other);
  arguments.match.check(input.points.size(), other.points.size());
  check_other(other, arguments);
  if(arguments.is_mirrored)
    mirror(other);
  const std::vector<std::size_t> labels = transfer == Transfer::LABELS
                                            ? labels_of(arguments.transfer, other)
                                            : std::vector<std::size_t>();
  std::vector<CP::Registration_summary::Stage> stages = {{"read", clock.lap()}};
  arguments.say("computing the poses");
  std::vector<std::string> warnings;
  const CP::Matchable_surface_3 surface
    = prepared(input, arguments.pose, std::string(), arguments, warnings);
  const CP::Matchable_surface_3 surface_of_other
    = prepared(other, arguments.other_pose, name_of_input(arguments.other), arguments, warnings);
  stages.emplace_back("poses", clock.lap());
  arguments.say("matching");
  arguments.match.number_of_threads = arguments.options.number_of_threads;
  const CP::Surface_match_3 match = CP::match_surfaces(surface, surface_of_other, arguments.match);
  stages.emplace_back("match", clock.lap());
  for(std::string& warning : warnings_of(input, other, match, arguments))
    warnings.push_back(std::move(warning));
  Point_matrix positions;
  if(is_input_rewritten(arguments))
    positions = transfer == Transfer::POSE ? in_posture(input, other, match, arguments)
                                           : match.interpolated(matrix_of(points_of(other)));
  if(transfer == Transfer::POSE)
    stages.emplace_back("transfer", clock.lap());
  files.write_with_files(output, [&](std::ostream& out, Companion_files* const beside) {
    if(is_input_rewritten(arguments))
      return write_pose(out, format_of(output), input, positions, beside);
    if(transfer == Transfer::NONE)
      return write_locations(out, match);
    if(transfer == Transfer::COLORS)
      return write_mesh(out, format_of(output), colored(without_source(input), other, match),
                        beside);
    if(transfer == Transfer::TEXTURE)
      return write_mesh(out, format_of(output), textured(without_source(input), other, match),
                        beside);
    const std::vector<std::size_t> labels_of_input = transferred(labels, input, other, match);
    if(is_shown(output))
      return write_shown(out, format_of(output), shown_parts(input, labels_of_input));
    for(const std::size_t label : labels_of_input)
      out << label << '\n';
  });
  files.write(arguments.map, [&](std::ostream& out) { write_locations(out, match); });
  stages.emplace_back("write", clock.lap());
  files.write(arguments.report, [&](std::ostream& out) {
    write_report(out, match, warnings, stages, clock.total());
  });
  files.commit();
  arguments.say("");
  if(arguments.quiet)
    return EXIT_SUCCESS;
  std::ostream& out = messages_beside(outputs);
  out << "mean round trip " << match.mean_round_trip << ", mean distance of the poses "
      << match.mean_distance << " (of their radius)\n";
  for(const std::string& warning : warnings)
    out << "warning: " << warning << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command MATCH_COMMAND = {
  "match",
  "finds where the vertices of a surface are on another one",
  {"match man.obj woman.ply -o map.txt", "match man.obj woman.ply -o man.glb --transfer texture"},
  add_match_options,
  run_match};

} // namespace Canonical_pose_tool
