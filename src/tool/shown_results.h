// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SHOWN_RESULTS_H
#define CGAL_CANONICAL_POSE_3_TOOL_SHOWN_RESULTS_H

#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

// What the commands show of their results.

namespace Canonical_pose_tool {

// Whether a file shows a surface, with values and colors (.ply, .glb).
bool is_shown(const std::string& path);

// Whether a path is that of a text: .txt, or the standard output.
bool is_text(const std::string& path);

// The format of an output. Throws Usage_error if its extension is unknown.
Format format_of_output(const std::string& path);

// Throws Usage_error unless the path has this extension.
void check_extension(const std::string& path, const std::string& extension);

// Throws Usage_error if the extension is neither that of a mesh that shows values nor that of a text. None is that of a text.
void check_format_of_values(const std::string& path);

// Writes PLY or glTF.
void write_shown(std::ostream& out, Format format, const Shown_surface& surface);

// The distances from each source, a column each; -1 where there is no path. Colors show the distance
// from the nearest source.
Shown_surface shown_distances(const Mesh_file& input, const Eigen::MatrixXd& distances);

Shown_surface shown_parts(const Mesh_file& input, const std::vector<std::size_t>& part_of_face);

// INPUT, or its boundary, with target and pose, which has the stance of this name, in the frame of the pose. Colors show the strain.
Shown_surface shown_pose(const Mesh_file& input, const CGAL::Canonical_pose_3::Result& result,
                         const std::string& stance);

// Adds a warning that tells what `owner` has, and `result` has not ("the parts lack"); none if that is nothing.
void add_losses(std::vector<std::string>& warnings, const std::string& result,
                const std::vector<std::string>& losses, const std::string& owner = "the input");

// In warnings about files that a pose names.
inline constexpr const char* NOT_COPIED = "not copied";

// How warnings about a match begin.
inline constexpr const char *HARDLY_MATCH = "the surfaces hardly match",
                            *OTHER_ROTATION = "another rotation of the pose matches nearly as well",
                            *PARTLY_COMPARED = "only a part of";

// The same for what write_pose() or, if `is_new`, write_mesh() writes to a path.
void add_losses_of_file(std::vector<std::string>& warnings, const std::string& result,
                        const Mesh_file& input, const std::string& path, bool is_new = false);

// The same for what write_shown() writes to a path; colors of vertices may be those of results.
void add_losses_of_shown(std::vector<std::string>& warnings, const std::string& result,
                         const Mesh_file& input, const std::string& path, bool has_vertex_colors);

// Writes a pose; with the strain of its vertices if the format has values. With a skeleton, which glTF has, it is a new
// file, not that of INPUT.
void write_pose(std::ostream& out, Format format, const Mesh_file& input,
                const CGAL::Canonical_pose_3::Point_matrix& pose, Companion_files* beside,
                const std::optional<CGAL::Canonical_pose_3::Skeleton_3>& skeleton = std::nullopt);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SHOWN_RESULTS_H
