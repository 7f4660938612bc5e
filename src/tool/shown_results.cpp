// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shown_results.h"
#include "Command_line.h"
#include "formats/Cgal_types.h"

#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/triangulate_polygons.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace CP = CGAL::Canonical_pose_3;

const double LARGEST_SHOWN_STRAIN = 0.5; // edges of 0.6 or 1.65 times their length

Eigen::VectorXd strains(const Mesh_file& input, const Point_matrix& pose)
{
  const Point_matrix rest = matrix_of(points_of(input));
  return input.is_tetrahedral
           ? CP::vertex_strains(rest, pose, input.cells)
           : CP::vertex_strains(rest, pose, CP::triangulate_polygons(rest, input.faces).triangles);
}

std::vector<Figure> figures_of(const Mesh_file& mesh)
{
  return {{"vertices", static_cast<double>(mesh.points.size())},
          {"faces", static_cast<double>(mesh.faces.size())}};
}

std::vector<std::size_t> all_vertices(const Mesh_file& mesh)
{
  std::vector<std::size_t> result(mesh.points.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

void color_by(Shown_surface& surface, const std::string& name, const Eigen::VectorXd& values,
              const double maximum)
{
  surface.vertex_colors = colors_of_values(values, 0, maximum);
  surface.legend = Legend{name, 0, maximum};
}

} // namespace

bool is_shown(const std::string& path)
{
  const std::string extension = extension_of(path);
  return extension == ".ply" || (extension == ".glb" && format_of(path) == Format::GLB);
}

bool is_text(const std::string& path) { return path == "-" || extension_of(path) == ".txt"; }

Format format_of_output(const std::string& path)
try
{
  const Format format = format_of(path, Use::WRITE);
  check_format_holds(format, Mesh_file());
  return format;
}
catch(const std::invalid_argument& error)
{
  throw Usage_error(error.what());
}

void check_extension(const std::string& path, const std::string& extension)
{
  if(path != "-" && extension_of(path) != extension)
    throw Usage_error("'" + path + "' is not a " + extension + " file");
}

void check_format_of_values(const std::string& path)
{
  if(!is_shown(path) && !is_text(path) && !extension_of(path).empty())
    throw Usage_error("'" + path + "' is neither a .txt nor a .ply nor a .glb file");
}

void write_shown(std::ostream& out, const Format format, const Shown_surface& surface)
{
  if(format == Format::GLB)
    write_glb(out, surface);
  else
    write_ply(out, surface);
}

Shown_surface shown_distances(const Mesh_file& input, const Eigen::MatrixXd& distances)
{
  Shown_surface surface;
  surface.mesh = input;
  surface.origins = all_vertices(input);
  const auto finite = [](const double x) { return std::isfinite(x) ? x : -1; };
  for(Eigen::Index k = 0; k < distances.cols(); ++k)
    surface.values.push_back({distances.cols() == 1 ? "distance" : "distance_" + std::to_string(k),
                              distances.col(k).unaryExpr(finite)});
  const Eigen::VectorXd nearest = distances.rowwise().minCoeff().unaryExpr(finite);
  surface.figures = figures_of(input);
  color_by(surface, "distance", nearest, nearest.maxCoeff());
  return surface;
}

Shown_surface shown_parts(const Mesh_file& input, const std::vector<std::size_t>& part_of_face)
{
  Shown_surface surface;
  surface.mesh = input;
  surface.origins = all_vertices(input);
  surface.part_of_face = part_of_face;
  surface.figures = figures_of(input);
  const std::size_t parts
    = part_of_face.empty() ? 0 : *std::max_element(part_of_face.begin(), part_of_face.end()) + 1;
  surface.figures.push_back({"parts", static_cast<double>(parts)});
  return surface;
}

Shown_surface shown_pose(const Mesh_file& input, const CP::Result& result,
                         const std::string& stance)
{
  Shown_surface surface;
  if(input.is_tetrahedral)
    surface.mesh = boundary_of(input, surface.origins);
  else
  {
    surface.mesh = input;
    surface.origins = all_vertices(input);
  }
  Point_matrix pose_of_surface(static_cast<Eigen::Index>(surface.origins.size()), 3);
  Eigen::VectorXd strain(pose_of_surface.rows());
  const Eigen::VectorXd strain_of_input = strains(input, result.pose);
  for(Eigen::Index v = 0; v < pose_of_surface.rows(); ++v)
  {
    const Eigen::Index origin
      = static_cast<Eigen::Index>(surface.origins[static_cast<std::size_t>(v)]);
    pose_of_surface.row(v) = result.pose.row(origin);
    strain[v] = strain_of_input[origin];
  }
  const Point_matrix target = (result.motion * result.target->transpose()).transpose();
  surface.other_shapes = {{"target", target}, {"pose", pose_of_surface}};
  surface.skeleton = result.skeleton;
  surface.stance = stance;
  surface.values = {{"strain", strain}};
  surface.figures = figures_of(surface.mesh);
  surface.figures.push_back({"stress", result.summary.target.stress});
  surface.figures.push_back({"energy", result.summary.energy});
  surface.figures.push_back({"median_edge_strain", result.summary.median_edge_strain});
  surface.figures.push_back({"inverted", static_cast<double>(result.summary.inverted)});
  color_by(surface, "strain", strain, LARGEST_SHOWN_STRAIN);
  return surface;
}

void add_losses(std::vector<std::string>& warnings, const std::string& result,
                const std::vector<std::string>& losses, const std::string& owner)
{
  if(!losses.empty())
    warnings.push_back(result + ' ' + boost::algorithm::join(losses, ", ") + " of " + owner);
}

void add_losses_of_file(std::vector<std::string>& warnings, const std::string& result,
                        const Mesh_file& input, const std::string& path, const bool is_new)
{
  const Format format = format_of(path);
  const bool is_rewritten = !is_new && is_rewritable(input, format);
  add_losses(warnings,
             result + " in "
               + (is_standard_stream(path) ? "the standard output" : '\'' + path + '\'') + " lacks",
             losses(input, format, is_rewritten, has_files_beside(path)));
  if(!is_rewritten || is_standard_stream(path))
    return;
  for(const std::string& name : names_not_beside(input, path))
    warnings.push_back(result + " names '" + name + "', which is not beside it");
  for(const File_beside& file : files_beside(input))
    if(!is_copied(input, file, path))
      warnings.push_back(
        result + " names '" + file.name + "', which is beside the input, but " + NOT_COPIED
        + (is_another_there(input, file, path) ? ": a different file of this name is there" : ""));
}

void add_losses_of_shown(std::vector<std::string>& warnings, const std::string& result,
                         const Mesh_file& input, const std::string& path,
                         const bool has_vertex_colors)
{
  const Format format = format_of(path);
  std::vector<std::string> names = losses(input, format, false, false);
  names.erase(std::remove(names.begin(), names.end(), COMMENTS), names.end()); // of another file
  if(format == Format::PLY && has_vertex_colors && !input.appearance.vertex_colors.empty())
    names.insert(names.begin(), "colors");
  add_losses(warnings, result, names);
}

void write_pose(std::ostream& out, const Format format, const Mesh_file& input,
                const Point_matrix& pose, Companion_files* const beside,
                const std::optional<CP::Skeleton_3>& skeleton)
{
  if(skeleton && format == Format::GLB)
  {
    Shown_surface surface;
    surface.mesh = with_points(input, pose);
    surface.origins = all_vertices(input);
    surface.skeleton = skeleton;
    write_glb(out, surface);
  }
  else if(is_rewritable(input, format))
    rewrite_mesh(out, input, with_points(input, pose).points, {{"strain", strains(input, pose)}},
                 beside);
  else if(format == Format::VTU)
    write_vtu(out, with_points(input, pose), {{"strain", strains(input, pose)}});
  else if(format == Format::PLY)
  {
    Shown_surface surface;
    surface.mesh = with_points(input, pose);
    surface.values = {{"strain", strains(input, pose)}};
    write_ply(out, surface, beside);
  }
  else
    write_mesh(out, format, with_points(input, pose), beside);
}

} // namespace Canonical_pose_tool
