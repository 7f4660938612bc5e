// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Growth: time and memory of the geodesic distances and of the entire pipeline as a function of the
// size of the mesh, the sitting articulated figure, repeatedly refined by Loop subdivision. Each
// measurement is a separate process; memory is its peak minus that of a process that only creates
// the mesh.
//
// How to read: one line per size. `heat`: setup of Heat_geodesics_3 and distances from --sources
// sources on all threads; `front`: Wavefront_geodesics_3 and one source; `pose`:
// canonical_pose_3() with default options, and the seconds of body and registration included
// therein; `1 thr.`: the same with one thread. Bytes are per vertex. The last line contains slopes
// of the logarithm of the time over that of the number of vertices, by least squares.
//
// Usage: growth_benchmark [--vertices 3300] [--levels 4] [--sources 80] [--runs 3]

#include "Argument_list.h"
#include "Child_process.h"
#include "median.h"
#include "setting.h"
#include "spread_sources.h"

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_benchmark;
using Canonical_pose_examples::Articulated_figure;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

using Seconds = std::array<double, 2>; // of two parts

// Medians over the runs.
struct Measurement
{
  Seconds seconds = {0, 0};
  double bytes = 0;
};

Mesh figure(const std::size_t vertices, const std::size_t level)
{
  Mesh mesh
    = Articulated_figure(vertices).make_mesh<Mesh>(Articulated_figure::named_poses()[1].angles);
  CGAL::Subdivision_method_3::Loop_subdivision(
    mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned int>(level)));
  return mesh;
}

Measurement measure(const std::function<Seconds()>& work, const std::size_t runs)
{
  std::array<std::vector<double>, 2> seconds;
  std::vector<double> bytes;
  for(std::size_t run = 0; run < runs; ++run)
  {
    Child_process child(
      [&] {
        const Seconds here = work();
        return std::string(reinterpret_cast<const char*>(here.data()), sizeof(here));
      },
      Limits());
    child.wait();
    if(child.ending() != Child_process::RETURNED)
      throw std::runtime_error(child.description());
    Seconds here;
    std::memcpy(here.data(), child.output().data(), sizeof(here));
    for(int k = 0; k < 2; ++k)
      seconds[k].push_back(here[k]);
    bytes.push_back(child.peak_megabytes() * 1048576);
  }
  return {{median(seconds[0]), median(seconds[1])}, median(bytes)};
}

Seconds heat(const Mesh& mesh, const std::size_t number_of_sources)
{
  const std::vector<Mesh::Vertex_index> sources = spread_sources(mesh, number_of_sources);
  CGAL::Real_timer timer;
  timer.start();
  const CP::Heat_geodesics_3<Mesh> geodesics(mesh);
  const double set_up = timer.time();
  geodesics.distances(sources);
  return {set_up, timer.time() - set_up};
}

Seconds wavefront(const Mesh& mesh)
{
  CGAL::Real_timer timer;
  timer.start();
  const CP::Wavefront_geodesics_3<Mesh> geodesics(mesh);
  const double set_up = timer.time();
  geodesics.distances(Mesh::Vertex_index(0));
  return {set_up, timer.time() - set_up};
}

Seconds pose(Mesh mesh, const int number_of_threads)
{
  CP::Options options;
  options.number_of_threads = number_of_threads;
  CGAL::Real_timer timer;
  timer.start();
  const CP::Registration_summary summary
    = CGAL::canonical_pose_3(mesh, mesh.points(), options).summary;
  const double total = timer.time();
  double body_and_registration = 0;
  for(const auto& [name, seconds] : summary.stages)
    for(const char* stage : {"body", "factorization", "local_steps", "global_steps"})
      if(name == stage)
        body_and_registration += seconds;
  return {total, body_and_registration};
}

// Slope of log y over log x.
double slope(const std::vector<double>& x, const std::vector<double>& y)
{
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u;
    sy += v;
    sxx += u * u;
    sxy += u * v;
  }
  const double n = double(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void run(const std::size_t vertices, const std::size_t levels, const std::size_t sources,
         const std::size_t runs)
{
  std::printf("%9s | %6s%8s%6s | %6s%8s%6s | %6s%8s%6s | %6s%8s%6s\n", "vertices", "heat", "fields",
              "bytes", "front", "field", "bytes", "pose", "body+r.", "bytes", "1 thr.", "body+r.",
              "bytes");
  std::vector<double> sizes;
  std::array<std::vector<double>, 8> columns;
  for(std::size_t level = 0; level <= levels; ++level)
  {
    Mesh mesh; // created in the parent, so that each child has it from the start
    mesh = figure(vertices, level);
    const double n = double(mesh.number_of_vertices());
    const Measurement none = measure([] { return Seconds{0, 0}; }, 1);
    sizes.push_back(n);
    std::printf("%9.0f", n);
    const std::function<Seconds()> works[]
      = {[&] { return heat(mesh, sources); }, [&] { return wavefront(mesh); },
         [&] { return pose(mesh, 0); }, [&] { return pose(mesh, 1); }};
    for(std::size_t k = 0; k < 4; ++k)
    {
      const Measurement m = measure(works[k], runs);
      std::printf(" | %6.2f%8.2f%6.0f", m.seconds[0], m.seconds[1], (m.bytes - none.bytes) / n);
      std::fflush(stdout);
      columns[2 * k].push_back(m.seconds[0]);
      columns[2 * k + 1].push_back(m.seconds[1]);
    }
    std::printf("\n");
  }
  std::printf("%9s", "slope");
  for(std::size_t k = 0; k < 4; ++k)
    std::printf(" | %6.2f%8.2f%6s", slope(sizes, columns[2 * k]), slope(sizes, columns[2 * k + 1]),
                "");
  std::printf("\n");
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto at_least_one = [&](const char* const name, const double otherwise) {
      return (std::max)(std::size_t(1), std::size_t(arguments.take_number(name, otherwise)));
    };
    const std::size_t vertices = at_least_one("--vertices", 3300);
    const std::size_t sources = at_least_one("--sources", 80);
    const std::size_t runs = at_least_one("--runs", 3);
    const auto levels = std::size_t(arguments.take_number("--levels", 4));
    if(!arguments.rest().empty())
      throw std::invalid_argument("there is no argument " + arguments.rest().front());
    std::printf("%s\n%zu sources, medians of %zu runs\n", setting().c_str(), sources, runs);
    run(vertices, levels, sources, runs);
  }
  catch(const std::exception& e)
  {
    std::cerr << "growth_benchmark: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
