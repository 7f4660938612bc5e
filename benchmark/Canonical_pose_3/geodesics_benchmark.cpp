// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times of the geodesic distances from many sources, from scratch: Heat_geodesics_3 and CGAL's
// Heat_method_3 (Intrinsic_Delaunay, its default solver), on the same mesh and sources.
//
// How to read: the first table has, for each mesh, medians over --runs of the seconds for setup and
// distances: this package on one thread and on all threads, CGAL, and the ratios of this package to
// CGAL, which are medians of the ratios of single runs. The three alternate in each run, so that
// other load on the machine slows down all of them. The second table compares the landmarks: the
// covering radius of the fronts divided by that of farthest point sampling, and the seconds of
// both.
//
// Usage: geodesics_benchmark [options] [mesh files]
//   --sources N   default 80     --runs N     default 5
// Without files: the sitting articulated figure, with 50 000 and with 200 000 vertices.

#include "Argument_list.h"
#include "median.h"
#include "setting.h"
#include "spread_sources.h"

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_benchmark::Argument_list;
using Canonical_pose_benchmark::median;
using Canonical_pose_benchmark::spread_sources;
using Canonical_pose_examples::Articulated_figure;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Heat = CP::Heat_geodesics_3<Mesh>;
using Heat_of_cgal
  = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

namespace {

struct Arguments
{
  std::size_t sources, runs;
  std::vector<std::string> files;
};

struct Seconds
{
  double set_up = 0, fields = 0;
  double total() const { return set_up + fields; }
};

template <class Function>
double median_of(const std::vector<Seconds>& runs, const Function& f)
{
  std::vector<double> values;
  for(const Seconds& s : runs)
    values.push_back(f(s));
  return median(values);
}

template <class Function>
double seconds(const Function& f)
{
  CGAL::Real_timer timer;
  timer.start();
  f();
  return timer.time();
}

Seconds run_ours(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sources)
{
  Seconds result;
  CGAL::Real_timer timer;
  timer.start();
  const Heat heat(mesh);
  result.set_up = timer.time();
  result.fields = seconds([&] { heat.distances(sources); });
  return result;
}

Seconds run_ours_on_one_thread(const Mesh& mesh, const std::vector<Mesh::Vertex_index>& sources)
{
  Seconds result;
  CGAL::Canonical_pose_3::call_with_threads(1, [&] { result = run_ours(mesh, sources); });
  return result;
}

Seconds run_cgal(const Mesh& input, const std::vector<Mesh::Vertex_index>& sources)
{
  Mesh mesh = input;
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0.).first;
  Seconds result;
  CGAL::Real_timer timer;
  timer.start();
  Heat_of_cgal heat(mesh);
  result.set_up = timer.time();
  result.fields = seconds([&] {
    for(const Mesh::Vertex_index source : sources)
    {
      heat.clear_sources();
      heat.add_source(source);
      heat.estimate_geodesic_distances(distance);
    }
  });
  return result;
}

// One line of the first table.
struct Comparison
{
  std::vector<Seconds> one_thread, all_threads, cgal;

  Comparison(const Mesh& mesh, const Arguments& arguments)
  {
    const auto sources = spread_sources(mesh, arguments.sources);
    for(std::size_t run = 0; run < arguments.runs; ++run)
    {
      one_thread.push_back(run_ours_on_one_thread(mesh, sources));
      all_threads.push_back(run_ours(mesh, sources));
      cgal.push_back(run_cgal(mesh, sources));
    }
  }

  double ratio(const std::vector<Seconds>& ours) const
  {
    std::vector<double> ratios;
    for(std::size_t run = 0; run < ours.size(); ++run)
      ratios.push_back(ours[run].total() / cgal[run].total());
    return median(ratios);
  }

  void print(const std::string& name, const Mesh& mesh) const
  {
    std::printf("%-28s%9zu", name.c_str(), std::size_t(mesh.number_of_vertices()));
    for(const auto& runs : {one_thread, all_threads, cgal})
      std::printf("%9.3f +%7.3f", median_of(runs, [](const Seconds& s) { return s.set_up; }),
                  median_of(runs, [](const Seconds& s) { return s.fields; }));
    std::printf("%9.3f%9.3f\n", ratio(one_thread), ratio(all_threads));
    std::fflush(stdout);
  }
};

void print_head()
{
  std::printf("%-28s%9s%18s%18s%18s%9s%9s\n", "set-up + fields, seconds", "vertices", "one thread",
              "all threads", "CGAL", "ratio 1", "ratio");
}

void print_landmarks(const std::string& name, const Mesh& mesh, const Arguments& arguments)
{
  const Heat heat(mesh);
  CP::Landmark_fields_3 farthest, front;
  const Mesh::Vertex_index first(0);
  const double seconds_of_farthest
    = seconds([&] { farthest = CP::farthest_point_landmarks(heat, arguments.sources, first); });
  const double seconds_of_front
    = seconds([&] { front = CP::front_landmarks(heat, arguments.sources, first); });
  std::printf("%-28s%20.3f%20.3f%20.3f\n", name.c_str(),
              front.covering_radius / farthest.covering_radius, seconds_of_front,
              seconds_of_farthest);
}

Arguments read(const int argc, char** argv)
{
  Argument_list list(argc, argv);
  Arguments arguments;
  arguments.sources = (std::max)(std::size_t(1), std::size_t(list.take_number("--sources", 80)));
  arguments.runs = (std::max)(std::size_t(1), std::size_t(list.take_number("--runs", 5)));
  arguments.files = list.rest();
  return arguments;
}

void run(const Arguments& arguments)
{
  std::vector<std::pair<std::string, Mesh>> meshes;
  for(const std::string& file : arguments.files)
  {
    meshes.emplace_back(file.substr(file.find_last_of('/') + 1), Mesh());
    if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, meshes.back().second))
      throw std::runtime_error("cannot read " + file);
  }
  if(meshes.empty())
    for(const std::size_t vertices : {50000, 200000})
      meshes.emplace_back("figure, sitting", Articulated_figure(vertices).make_mesh<Mesh>(
                                               Articulated_figure::named_poses()[1].angles));
  std::printf("%zu sources, medians of %zu runs\n", arguments.sources, arguments.runs);
  print_head();
  for(const auto& [name, mesh] : meshes)
    Comparison(mesh, arguments).print(name, mesh);
  std::printf("\n%-28s%20s%20s%20s\n", "landmarks", "covering radius", "fronts, seconds",
              "farthest, seconds");
  for(const auto& [name, mesh] : meshes)
    print_landmarks(name, mesh, arguments);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Arguments arguments = read(argc, argv);
    std::printf("%s\n", Canonical_pose_benchmark::setting().c_str());
    run(arguments);
  }
  catch(const std::exception& e)
  {
    std::cerr << "geodesics_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
