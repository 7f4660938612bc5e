// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command compare.

#include "command_options.h"
#include "commands.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Writes the difference of each pair of poses, and their mean: without and with reflection.
// Throws std::invalid_argument, with the names of the files, if two of them cannot be compared.
void write_differences(std::ostream& out, const std::vector<std::string>& names,
                       const std::vector<Point_matrix>& poses)
{
  std::ostringstream text;
  text.precision(6);
  text << std::fixed << "proper    reflected\n";
  double sums[2] = {};
  std::size_t number = 0;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = i + 1; j < poses.size(); ++j, ++number)
    {
      double differences[2];
      for(const bool may_be_reflected : {false, true})
        try
        {
          differences[may_be_reflected]
            = CGAL::Canonical_pose_3::pose_difference(poses[i], poses[j], may_be_reflected);
        }
        catch(const std::invalid_argument& error)
        {
          throw std::invalid_argument(names[i] + ", " + names[j] + ": " + error.what());
        }
      sums[0] += differences[0];
      sums[1] += differences[1];
      text << differences[0] << "  " << differences[1] << "   " << names[i] << ' ' << names[j]
           << '\n';
    }
  text << sums[0] / double(number) << "  " << sums[1] / double(number) << "   mean of " << number
       << (number == 1 ? " pair\n" : " pairs\n");
  out << text.str();
}

void add_compare_options(Command_options& o)
{
  o.app.add_option("POSE", o.arguments.poses, "two or more meshes with corresponding vertices")
    ->required()
    ->expected(2, -1);
}

int run_compare(Arguments& arguments)
{
  std::vector<Point_matrix> poses;
  for(const std::string& path : arguments.poses)
    poses.push_back(matrix_of(points_of(read_other_mesh_file(path))));
  write_differences(std::cout, arguments.poses, poses);
  return EXIT_SUCCESS;
}

} // namespace

const Command COMPARE_COMMAND
  = {"compare",
     "measures how much poses differ, independent of position and scale",
     {"compare sitting.off standing.off", "compare poses/*.off"},
     add_compare_options,
     run_compare};

} // namespace Canonical_pose_tool
