// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches: how far from the right place vertices of a shape are found on the same or a similar shape.
//
// Vertices correspond by index among the files. The first one is matched with each other one, and each
// other one with the first; with --all, each one with each. So that equal faces cannot help, the second shape of a match is
// triangulated anew (CGAL's isotropic remeshing); its right places are those of the vertices of the
// file. Each mesh is repaired first; of several components the largest is taken.
//
// How to read: one line per method. Errors are distances along the surface from the right place, for
// vertices that are spread over the first shape by area, in units of the root of the area of the
// second one: their mean (times 100), and the shares of errors up to 0.05 and 0.1. `failed` is the
// number of matches with a mean error above 0.1. Seconds are those of a match, median, without what is
// computed once for each surface: its pose, and eigenfunctions.
// `nearest` are the nearest vertices of inputs, targets or poses, after the best of four rotations of
// their principal axes. `functional map` knows lengths on the surface only, see Functional_map.h.
//
// Usage: match_benchmark [options] mesh files
//   --methods A;B            their names; default: all
//   --samples N              the number of vertices, default 200
//   --csv FILE               the shares of errors up to 0, 0.005 .. 0.25
//   --all                    matches all pairs
//   --each                   prints the mean error of each match
//   --geodesics, --body, --components, --rounds   of the poses, as for invariance_benchmark

#include "Argument_list.h"
#include "Matching_methods.h"
#include "Nearest_points.h"
#include "median.h"
#include "setting.h"
#include "take_options.h"

#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
namespace Tool = Canonical_pose_tool;
using namespace Canonical_pose_benchmark;
using Tool::Surface;

namespace {

class Clock
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  }

private:
  const std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

std::pair<Point_matrix, Triangles> triangulated_anew(const CP::Repaired_surface_3& surface)
{
  constexpr double factor = 1.15; // by which edges get longer
  constexpr unsigned iterations = 2;
  Surface mesh = CP::make_triangle_mesh<Surface>(surface.points, surface.triangles);
  double length = 0;
  for(const Surface::Edge_index e : mesh.edges())
    length += std::sqrt(
      CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
    mesh.faces(), factor * length / static_cast<double>(mesh.number_of_edges()), mesh,
    CGAL::parameters::number_of_iterations(iterations));
  mesh.collect_garbage();
  std::vector<Tool::Point_3> points;
  for(const Surface::Vertex_index v : mesh.vertices())
    points.push_back(mesh.point(v));
  Triangles triangles;
  for(const Surface::Face_index f : mesh.faces())
  {
    const Surface::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back({std::size_t(mesh.source(h)), std::size_t(mesh.target(h)),
                         std::size_t(mesh.target(mesh.next(h)))});
  }
  return {Tool::matrix_of(points), triangles};
}

// A shape as first and as second one of a match.
class Shape
{
public:
  Shape(const std::string& file_name, const std::vector<Matching_method>& methods,
        const CP::Options& options)
    : name(file_name.substr(file_name.find_last_of('/') + 1)),
      m_file(Tool::read_mesh_file(file_name)),
      m_surface(CP::component_of_surface(CP::repair_surface(points_of_file(), m_file.faces), 0)),
      m_search(m_surface.points)
  {
    const auto prepared = [&](Point_matrix points, Triangles triangles) {
      auto result
        = std::make_unique<Surface_to_match>(std::move(points), std::move(triangles), options);
      for(const Matching_method& method : methods)
        method.prepare(*result);
      return result;
    };
    m_first = prepared(m_surface.points, m_surface.triangles);
    auto [points, triangles] = triangulated_anew(m_surface);
    m_second = prepared(std::move(points), std::move(triangles));
  }

  const std::string name;

  // Vertices of the file at even steps of area.
  std::vector<std::size_t> spread_vertices(const std::size_t number) const
  {
    std::vector<std::size_t> result;
    double sum = 0;
    for(std::size_t i = 0; i < m_surface.origins.size(); ++i)
    {
      sum += m_first->shares[static_cast<Eigen::Index>(i)];
      if(sum * static_cast<double>(number) > static_cast<double>(result.size()) + .5)
        result.push_back(m_surface.origins[i]);
    }
    return result;
  }

  std::size_t number_of_vertices() const { return m_file.points.size(); } // of the file

  // Sets the vertices of the file whose errors are measured.
  void set_vertices(const std::vector<std::size_t>& vertices)
  {
    m_rows = m_search.find(rows_of(points_of_file(), vertices));
    std::vector<Surface::Vertex_index> sources;
    for(const std::size_t row : m_rows)
      sources.emplace_back(static_cast<Surface::size_type>(row));
    const auto mesh = CP::make_triangle_mesh<Surface>(m_surface.points, m_surface.triangles);
    m_root_of_area = std::sqrt(CGAL::Polygon_mesh_processing::area(mesh));
    m_distances = CP::Wavefront_geodesics_3<Surface>(mesh).distances(sources);
  }

  const Surface_to_match& first() const { return *m_first; }
  const Surface_to_match& second() const { return *m_second; }

  // Of positions on this shape, one for each vertex of another one as the first of a match.
  std::vector<double> errors(const Point_matrix& positions, const Shape& other) const
  {
    std::vector<double> result;
    for(std::size_t k = 0; k < m_rows.size(); ++k)
      result.push_back(error(k, positions.row(static_cast<Eigen::Index>(other.m_rows[k]))));
    return result;
  }

private:
  Point_matrix points_of_file() const { return Tool::matrix_of(Tool::points_of(m_file)); }

  // The length of the path that reaches the position from one of the vertices around it.
  double error(const std::size_t k, const Eigen::RowVector3d& position) const
  {
    constexpr unsigned number_of_vertices = 8;
    double least = (std::numeric_limits<double>::infinity)();
    for(const std::size_t v : m_search.find(position, number_of_vertices))
    {
      const auto row = static_cast<Eigen::Index>(v);
      least = (std::min)(least, m_distances(row, static_cast<Eigen::Index>(k))
                                  + (m_surface.points.row(row) - position).norm());
    }
    return least / m_root_of_area;
  }

  const Tool::Mesh_file m_file;
  const CP::Repaired_surface_3 m_surface;
  const Nearest_points m_search; // of the surface
  std::unique_ptr<Surface_to_match> m_first, m_second;
  std::vector<std::size_t> m_rows; // of vertices whose errors are measured
  Eigen::MatrixXd m_distances;     // from them, a column each
  double m_root_of_area = 0;
};

// The matches of one method.
struct Trials
{
  std::vector<double> errors, means, seconds;

  double share_up_to(const double error) const
  {
    const auto number
      = std::count_if(errors.begin(), errors.end(), [=](const double e) { return e <= error; });
    return static_cast<double>(number)
           / static_cast<double>((std::max)(errors.size(), std::size_t(1)));
  }
};

double mean(const std::vector<double>& values)
{
  double sum = 0;
  for(const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

class Match_benchmark
{
public:
  Match_benchmark(std::vector<Matching_method> methods, const bool prints_each)
    : m_methods(std::move(methods)), m_trials(m_methods.size()), m_prints_each(prints_each)
  {}

  const std::vector<Matching_method>& methods() const { return m_methods; }

  void match(const Shape& a, const Shape& b)
  {
    for(std::size_t m = 0; m < m_methods.size(); ++m)
    {
      Trials& trials = m_trials[m];
      const Clock clock;
      const Point_matrix positions = m_methods[m].match(a.first(), b.second());
      trials.seconds.push_back(clock.seconds());
      const std::vector<double> errors = b.errors(positions, a);
      trials.errors.insert(trials.errors.end(), errors.begin(), errors.end());
      trials.means.push_back(mean(errors));
      if(m_prints_each)
        std::printf("%-44s%-20s%8.2f%8.2f\n", (a.name + ' ' + b.name).c_str(),
                    m_methods[m].name.c_str(), 100 * trials.means.back(), trials.seconds.back());
    }
    std::fflush(stdout);
  }

  void print() const
  {
    std::printf("%-20s%8s%8s%8s%8s%8s%8s\n", "method", "matches", "mean", "<= .05", "<= .1",
                "failed", "seconds");
    for(std::size_t m = 0; m < m_methods.size(); ++m)
    {
      const Trials& trials = m_trials[m];
      if(trials.errors.empty())
        continue;
      const auto failed = std::count_if(trials.means.begin(), trials.means.end(),
                                        [](const double error) { return error > .1; });
      std::printf("%-20s%8zu%8.2f%8.3f%8.3f%8td%8.2f\n", m_methods[m].name.c_str(),
                  trials.means.size(), 100 * mean(trials.errors), trials.share_up_to(.05),
                  trials.share_up_to(.1), failed, median(trials.seconds));
    }
  }

  void write_curves(const std::string& file) const
  {
    std::ofstream out(file);
    out << "error";
    for(const Matching_method& method : m_methods)
      out << ',' << method.name;
    constexpr int last = 50;
    constexpr double step = .005;
    for(int i = 0; i <= last; ++i)
    {
      out << '\n' << i * step;
      for(const Trials& trials : m_trials)
        out << ',' << trials.share_up_to(i * step);
    }
    out << '\n';
    if(!out.flush())
      throw std::runtime_error("cannot write " + file);
  }

private:
  std::vector<Matching_method> m_methods;
  std::vector<Trials> m_trials;
  bool m_prints_each;
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const auto number_of_samples
      = static_cast<std::size_t>(arguments.take_number("--samples", 200));
    const std::string curves = arguments.take_text("--csv");
    Match_benchmark benchmark(chosen_matching_methods(arguments.take_text("--methods")),
                              arguments.take_flag("--each"));
    const bool matches_all = arguments.take_flag("--all");
    const CP::Options options = take_options(arguments);
    if(arguments.rest().size() < 2 || number_of_samples == 0)
      throw std::invalid_argument("at least two meshes and one sample are needed");
    std::printf("%s\n", setting().c_str());
    bool all_done = true;
    std::vector<std::unique_ptr<Shape>> references;
    const Shape& first = *references.emplace_back(
      std::make_unique<Shape>(arguments.rest().front(), benchmark.methods(), options));
    const std::vector<std::size_t> vertices = first.spread_vertices(number_of_samples);
    references.front()->set_vertices(vertices);
    for(std::size_t i = 1; i < arguments.rest().size(); ++i)
      try
      {
        auto shape = std::make_unique<Shape>(arguments.rest()[i], benchmark.methods(), options);
        if(shape->number_of_vertices() != first.number_of_vertices())
          throw std::invalid_argument("its vertices do not correspond to those of the first file");
        shape->set_vertices(vertices);
        for(const std::unique_ptr<Shape>& reference : references)
        {
          benchmark.match(*reference, *shape);
          benchmark.match(*shape, *reference);
        }
        if(matches_all)
          references.push_back(std::move(shape));
      }
      catch(const std::exception& e)
      {
        std::cerr << arguments.rest()[i] << ": " << e.what() << '\n';
        all_done = false;
      }
    benchmark.print();
    if(!curves.empty())
      benchmark.write_curves(curves);
    return all_done ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const std::exception& e)
  {
    std::cerr << "match_benchmark: " << e.what() << '\n';
    return 2;
  }
}
