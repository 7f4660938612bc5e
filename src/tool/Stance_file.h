// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_STANCE_FILE_H
#define CGAL_CANONICAL_POSE_3_TOOL_STANCE_FILE_H

#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// Where limbs go, a line each: `left arm 1 -1 0`, `vertex 123 0 1 0 as-is`; and where the others go: `stance a`. '#' starts a
// comment.
class Stance_file
{
public:
  // Throws std::invalid_argument, which names the file and the line.
  explicit Stance_file(const std::string& path);

  void set(CGAL::Canonical_pose_3::Options& options) const
  {
    options.stance = m_stance;
    options.limb_directions = m_directions;
  }

  // The error of a line for that of a direction.
  std::invalid_argument error(const CGAL::Canonical_pose_3::Limb_direction_error& e) const
  {
    return error(m_lines[e.index()], e.defect());
  }

  // The name of the stance: that of the file, without folder and extension.
  std::string name() const;

private:
  void read_line(const std::vector<std::string>& words, std::size_t line);
  void read_stance(const std::vector<std::string>& words, std::size_t line);
  std::invalid_argument error(std::size_t line, const std::string& defect) const;

  std::string m_path;
  CGAL::Canonical_pose_3::Options::Stance m_stance
    = CGAL::Canonical_pose_3::Options::Stance::CANONICAL;
  std::size_t m_line_of_stance = 0; // 0: none
  std::vector<CGAL::Canonical_pose_3::Limb_direction_3> m_directions;
  std::vector<std::size_t> m_lines; // of the directions
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_STANCE_FILE_H
