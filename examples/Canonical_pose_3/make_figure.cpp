// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the articulated figure, a person or an animal, in one of its poses as an OFF file.
#include "Articulated_animal.h"
#include "Articulated_figure.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;

namespace {

template <class Shape>
void print_names(std::ostream& out)
{
  out << "rest";
  for(const auto& pose : Shape::named_poses())
    out << ", " << pose.name;
  out << ".\n";
}

int print_usage(bool was_asked_for)
{
  std::ostream& out = was_asked_for ? std::cout : std::cerr;
  out << "usage: make_figure [--shape person|animal] [--vertices N] [--pose NAME] output.off\n"
         "Default: person, 10000, standing. N: 2000 to 2000000.\n"
         "NAME of a person can also be hand-on-knee, or merged: the same with a false contact.\n"
         "NAME of a person: ";
  print_names<Articulated_figure>(out);
  out << "NAME of an animal: ";
  print_names<Articulated_animal>(out);
  return was_asked_for ? 0 : 2;
}

template <class Shape>
typename Shape::Joint_angles angles_of(const std::string& name)
{
  if(name == "rest")
    return {};
  for(const auto& pose : Shape::named_poses())
    if(pose.name == name)
      return pose.angles;
  throw std::invalid_argument("there is no pose \"" + name + "\"");
}

template <class Shape>
void write(const std::string& path, const typename Shape::Points& points,
           const typename Shape::Triangles& triangles)
{
  std::ofstream out(path);
  out.precision(17);
  out << "OFF\n" << points.size() << ' ' << triangles.size() << " 0\n";
  for(const auto& p : points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(const auto& t : triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if(!out.flush())
    throw std::runtime_error("cannot write " + path);
}

template <class Shape>
void write(const std::string& path, std::size_t number_of_vertices, const std::string& pose)
{
  const auto angles = angles_of<Shape>(pose);
  const Shape shape(number_of_vertices);
  write<Shape>(path, shape.points(angles), shape.triangles());
}

void write_person(const std::string& path, std::size_t number_of_vertices, const std::string& pose)
{
  if(pose != "hand-on-knee" && pose != "merged")
    return write<Articulated_figure>(path, number_of_vertices, pose);
  const Articulated_figure figure(number_of_vertices);
  write<Articulated_figure>(path, figure.points(Articulated_figure::hand_on_knee()),
                            pose == "merged" ? figure.merged_triangles() : figure.triangles());
}

} // namespace

int main(int argc, char* argv[])
try
{
  std::map<std::string, std::string> options{
    {"--shape", "person"}, {"--vertices", "10000"}, {"--pose", "standing"}};
  std::string output;
  for(int i = 1; i < argc; ++i)
  {
    const auto option = options.find(argv[i]);
    if(option == options.end())
      output = argv[i];
    else
      option->second = ++i < argc ? argv[i] : "";
  }
  if(output.empty() || output[0] == '-')
    return print_usage(output == "--help");
  const std::size_t number_of_vertices = std::strtoul(options["--vertices"].c_str(), nullptr, 10);
  if(options["--shape"] == "person")
    write_person(output, number_of_vertices, options["--pose"]);
  else if(options["--shape"] == "animal")
    write<Articulated_animal>(output, number_of_vertices, options["--pose"]);
  else
    throw std::invalid_argument("there is no shape \"" + options["--shape"] + "\"");
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::cerr << "make_figure: " << error.what() << '\n';
  return EXIT_FAILURE;
}
