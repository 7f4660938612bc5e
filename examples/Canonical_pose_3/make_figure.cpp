// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Writes the articulated figure in one of its poses as an OFF file.
#include "Articulated_figure.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_examples::Joint_angles;

namespace {

int print_usage(bool was_asked_for)
{
  std::ostream& out = was_asked_for ? std::cout : std::cerr;
  out << "usage: make_figure [--vertices N] [--pose NAME] output.off\n"
         "N: 2000 to 2000000, default 10000. NAME: rest";
  for(const auto& pose : Articulated_figure::named_poses())
    out << ", " << pose.name;
  out << "; default standing.\n";
  return was_asked_for ? 0 : 2;
}

Joint_angles angles_of(const std::string& name)
{
  if(name == "rest")
    return Joint_angles();
  for(const auto& pose : Articulated_figure::named_poses())
    if(pose.name == name)
      return pose.angles;
  throw std::invalid_argument("there is no pose \"" + name + "\"");
}

void write(const std::string& path, const Articulated_figure& figure, const Joint_angles& angles)
{
  std::ofstream out(path);
  out.precision(17);
  const auto points = figure.points(angles);
  out << "OFF\n" << points.size() << ' ' << figure.triangles().size() << " 0\n";
  for(const auto& p : points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const auto& t : figure.triangles())
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if(!out.flush())
    throw std::runtime_error("cannot write " + path);
}

} // namespace

int main(int argc, char* argv[])
try
{
  std::string pose = "standing", vertices = "10000", output;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool has_value = argument == "--vertices" || argument == "--pose";
    std::string& value = argument == "--vertices" ? vertices : has_value ? pose : output;
    value = !has_value ? argument : ++i < argc ? argv[i] : "";
  }
  if(output.empty() || output[0] == '-')
    return print_usage(output == "--help");
  write(output, Articulated_figure(std::strtoul(vertices.c_str(), nullptr, 10)), angles_of(pose));
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::cerr << "make_figure: " << error.what() << '\n';
  return EXIT_FAILURE;
}
