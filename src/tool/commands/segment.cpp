// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command segment.

#include "Output_files.h"
#include "Report.h"
#include "command_options.h"
#include "commands.h"
#include "compute_parts.h"
#include "shown_results.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

std::vector<std::size_t> parts_of(const Mesh_file& input, const Arguments& arguments,
                                  Segmentation_report& report, Stage_clock& clock)
{
  Segmentation_input segmentation{input, arguments.method, std::nullopt, watched_options(arguments),
                                  arguments.number_of_parts};
  if(!arguments.pose.empty())
    segmentation.pose = matrix_of(points_of(read_other_mesh_file(arguments.pose)));
  return compute_parts(segmentation, report, clock);
}

// The faces of a part, with their vertices.
Mesh_file part_of(const Mesh_file& input, const std::vector<std::size_t>& parts,
                  const std::size_t part)
{
  const Appearance& appearance = input.appearance;
  Mesh_file result;
  std::vector<std::size_t> index(input.points.size(), input.points.size());
  std::size_t corner = 0;
  for(std::size_t f = 0; f < parts.size(); corner += input.faces[f++].size())
    if(parts[f] == part)
    {
      std::vector<std::size_t> face;
      for(const std::size_t v : input.faces[f])
      {
        if(!appearance.texture_coordinates.empty())
          result.appearance.texture_coordinates.push_back(
            appearance.texture_coordinates[corner + face.size()]);
        if(!appearance.normals.empty())
          result.appearance.normals.push_back(appearance.normals[corner + face.size()]);
        if(index[v] == input.points.size())
        {
          index[v] = result.points.size();
          result.points.push_back(input.points[v]);
          if(!appearance.vertex_colors.empty())
            result.appearance.vertex_colors.push_back(appearance.vertex_colors[v]);
          if(!appearance.vertex_opacities.empty())
            result.appearance.vertex_opacities.push_back(appearance.vertex_opacities[v]);
        }
        face.push_back(index[v]);
      }
      result.faces.push_back(face);
      if(appearance.has_materials())
        result.appearance.material_of_face.push_back(appearance.material_of_face[f]);
    }
  result.appearance.materials = appearance.materials;
  return result;
}

// A folder that is removed again unless it is kept, or was there before.
class Output_folder
{
public:
  explicit Output_folder(const std::string& path)
  {
    std::error_code error;
    if(!path.empty() && std::filesystem::create_directory(path, error))
      add_unfinished_file(m_created.emplace(path));
    else if(error)
      throw std::invalid_argument("'" + path + "' cannot be created: " + error.message());
  }
  ~Output_folder()
  {
    std::error_code error;
    if(m_created)
      std::filesystem::remove(*m_created, error);
    keep();
  }
  Output_folder(const Output_folder&) = delete;
  Output_folder& operator=(const Output_folder&) = delete;
  void keep()
  {
    if(m_created)
      drop_unfinished_file(*m_created);
    m_created.reset();
  }

private:
  std::optional<std::string> m_created;
};

bool is_folder(const std::string& path) { return path.back() == '/'; }

std::vector<std::string> inputs_of(const Arguments& arguments)
{
  return {arguments.input, arguments.pose};
}

void write_parts(const Mesh_file& input, const std::vector<std::size_t>& parts,
                 const std::size_t number_of_parts, const Arguments& arguments,
                 const Segmentation_report& report, Stage_clock& clock)
{
  const bool has_folder = is_folder(arguments.output);
  std::vector<std::string> outputs = {arguments.output}, removed; // those of a run before
  if(has_folder)
  {
    const std::string extension = extension_of_format(written_format(format_of(arguments.input)));
    const auto part_path = [&](const std::size_t part) {
      return arguments.output + "part_" + std::to_string(part) + extension;
    };
    outputs.clear();
    for(std::size_t part = 0; part < number_of_parts; ++part)
      outputs.push_back(part_path(part));
    std::error_code error;
    for(std::size_t part = number_of_parts; std::filesystem::exists(part_path(part), error); ++part)
    {
      removed.push_back(part_path(part));
      if(extension == ".obj")
        removed.push_back(arguments.output + "part_" + std::to_string(part) + ".mtl");
    }
  }
  std::vector<std::string> paths = outputs;
  paths.push_back(arguments.report);
  paths.insert(paths.end(), removed.begin(), removed.end()); // are neither an input nor an output
  Output_files files(paths, inputs_of(arguments));
  for(std::size_t i = 0; i < outputs.size(); ++i)
    files.write_with_files(outputs[i], [&](std::ostream& out, Companion_files* const beside) {
      if(has_folder)
        write_mesh(out, written_format(format_of(arguments.input)), part_of(input, parts, i),
                   beside);
      else if(is_shown(outputs[i]))
        write_shown(out, format_of(outputs[i]), shown_parts(input, parts));
      else
        for(const std::size_t part : parts)
          out << part << '\n';
    });
  files.write(arguments.report,
              [&](std::ostream& out) { write_report(out, report, clock.lap(), clock.total()); });
  files.commit();
  std::error_code error;
  for(const std::string& path : removed)
    std::filesystem::remove(path, error);
}

void add_segment_options(Command_options& o)
{
  add_input(o, Shapes::SURFACES);
  add_output(
    o, "the parts: numbers of the faces (.txt), colors (.ply, .glb), or a file each (folder/)",
    {"txt", "ply", "glb"});
  o.app.add_option("--parts", o.raw.parts, "number of parts: a positive number, or auto")
    ->capture_default_str();
  o.app
    .add_option("--method", o.arguments.method, "consensus, sweep (fast), kmeans (of the paper)")
    ->check(CLI::IsMember({"consensus", "sweep", "kmeans"}))
    ->capture_default_str();
  add_given_pose(o);
  add_report(o);
  add_method_options_for_each_component(o);
}

int run_segment(Arguments& arguments)
{
  Stage_clock clock;
  if(is_folder(arguments.output))
    check_format_holds(written_format(format_of(arguments.input)), Mesh_file());
  else if(!is_text(arguments.output) && !is_shown(arguments.output))
    throw Usage_error("'" + arguments.output
                      + "' is neither a .txt nor a .ply nor a .glb file, nor a folder ending in /");
  // What cannot be written fails early.
  Output_folder folder(is_folder(arguments.output) ? arguments.output : std::string());
  Output_files({is_folder(arguments.output) ? std::string() : arguments.output, arguments.report},
               inputs_of(arguments));
  const Mesh_file input = is_text(arguments.output) ? read_mesh_file(arguments.input)
                                                    : read_shown_mesh_file(arguments.input);
  check_is_surface(input);
  Segmentation_report report;
  report.stages.emplace_back("read", clock.lap());
  arguments.say("dividing the surface into parts");
  const std::vector<std::size_t> parts = parts_of(input, arguments, report, clock);
  if(is_folder(arguments.output))
    add_losses(report.warnings, "the parts lack",
               losses(input, written_format(format_of(arguments.input)), false));
  else if(!is_text(arguments.output))
    add_losses_of_shown(report.warnings, "the parts lack", input, arguments.output, false);
  write_parts(input, parts, report.parts.size(), arguments, report, clock);
  folder.keep();
  arguments.say("");
  if(arguments.quiet)
    return EXIT_SUCCESS;
  std::ostream& out = messages_beside({arguments.output, arguments.report});
  out << report.parts.size() << (report.parts.size() == 1 ? " part\n" : " parts\n");
  for(const std::string& warning : report.warnings)
    out << "warning: " << warning << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command SEGMENT_COMMAND
  = {"segment",
     "divides a surface into parts",
     {"segment man.off -o parts.glb", "segment man.off -o parts.txt --parts 6 --pose pose.off"},
     add_segment_options,
     run_segment};

} // namespace Canonical_pose_tool
