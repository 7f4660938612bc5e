// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Canonical forms of several authors, side by side: how much forms of one shape differ, how well
// shapes of the same class find each other by them, and how long they take.
//
// How to read: a table in Markdown with a row per form. NN (nearest neighbor), FT (first tier) and DCG
// are measures of Retrieval_evaluation.h, for the descriptors D2 and views. `seconds` are those of the
// processor (all threads), per file, after reading and repair. With --corresponding, `difference` is
// the mean over the classes of the mean over all pairs of files: root mean square distance of
// corresponding vertices after the best rigid motion, with or without reflection, at unit radius of
// gyration; differences of each class follow each row.
//
// Usage: canonical_forms_benchmark [--form NAME] [--corresponding] [--prefix P] CLASSES FILE...
//   CLASSES          lines "stem class"; files of other stems are not used
//   --form NAME      computes this form only
//   --corresponding  the files of each class have the same vertices
//   --prefix P       writes the forms to files with names P followed by stem_form.off

#include "Argument_list.h"
#include "Processor_clock.h"
#include "descriptors.h" // of the tool
#include "other_canonical_forms.h"
#include "paper_shapes.h"
#include "collection/read_classes.h"
#include "setting.h"

#include <CGAL/Canonical_pose_3/Retrieval_evaluation.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace Canonical_pose_benchmark;
namespace CP = CGAL::Canonical_pose_3;
using Component = CP::Prepared_surface_3::Component;

namespace {

struct Form
{
  std::string name;
  std::function<Point_matrix(const Component&)> points;
};

// The steps of the one call up to the target.
struct Landmark_target
{
  explicit Landmark_target(const Component& component)
    : coarse(CP::coarse_surface(component.surface, component.options)),
      fields(CP::landmark_fields(coarse, component.options)),
      target(CP::mds_target(component.surface, coarse, fields, component.options))
  {}

  // Vertices of the surface.
  std::vector<std::size_t> landmarks(const std::size_t number) const
  {
    std::vector<std::size_t> result;
    for(std::size_t k = 0; k < (std::min)(number, fields.landmarks.size()); ++k)
      result.push_back(coarse.vertices[fields.landmarks[k]]);
    return result;
  }

  Eigen::MatrixXd distances_of_landmarks() const
  {
    const auto l = static_cast<Eigen::Index>(fields.landmarks.size());
    Eigen::MatrixXd result(l, l);
    for(Eigen::Index k = 0; k < l; ++k)
      result.row(k) = fields.distances.row(
        static_cast<Eigen::Index>(fields.landmarks[static_cast<std::size_t>(k)]));
    return result;
  }

  CP::Coarse_surface_3 coarse;
  CP::Landmark_fields_3 fields;
  CP::Target_3 target;
};

Point_matrix least_squares(const Component& component)
{
  const Landmark_target start(component);
  Point_matrix points(static_cast<Eigen::Index>(start.coarse.vertices.size()), 3);
  for(std::size_t v = 0; v < start.coarse.vertices.size(); ++v)
    points.row(static_cast<Eigen::Index>(v))
      = start.target.points.row(static_cast<Eigen::Index>(start.coarse.vertices[v]));
  CP::Smacof_target_builder_3 builder(0);
  builder.build(
    start.fields, points,
    CP::vertex_area_shares(start.coarse.surface.points, start.coarse.surface.triangles));
  return start.coarse.interpolated(builder.targets());
}

Point_matrix pose(const Component& component, const CP::Component_options& options)
{
  const CP::Surface_component_3& surface = component.surface;
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, options);
  const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, options);
  const CP::Surface_body_3 body = CP::surface_body(surface, coarse, fields, options);
  const CP::Target_3 target = options.target_mode == CP::Options::Target_mode::UNFOLDING
                                ? CP::unfolded_target(surface, body, options)
                                : CP::mds_target(surface, coarse, fields, options);
  const CP::Result result = CP::registered_pose(surface, coarse, fields, target, body, options);
  Point_matrix points(surface.points.rows(), 3);
  for(std::size_t v = 0; v < body.surface_vertices.size(); ++v)
    points.row(static_cast<Eigen::Index>(v))
      = result.pose.row(static_cast<Eigen::Index>(body.surface_vertices[v]));
  return points;
}

std::vector<Form> all_forms()
{
  return {
    {"input", [](const Component& c) { return c.surface.points; }},
    {"global point signature",
     [](const Component& c) { return global_point_signature(c.surface); }},
    {"landmark scaling", [](const Component& c) { return Landmark_target(c).target.points; }},
    {"fast classical scaling",
     [](const Component& c) {
       const Landmark_target start(c);
       return fast_classical_scaling(c.surface, start.landmarks(80),
                                     start.distances_of_landmarks());
     }},
    {"least squares scaling", least_squares},
    {"Euclidean distances",
     [](const Component& c) {
       return euclidean_form(c.surface, Landmark_target(c).landmarks(30));
     }},
    {"unfolding",
     [](const Component& c) {
       CP::Component_options options = c.options;
       options.target_mode = CP::Options::Target_mode::UNFOLDING;
       return pose(c, options);
     }},
    {"pose without rounds",
     [](const Component& c) {
       CP::Component_options options = c.options;
       options.number_of_rounds = 0;
       return pose(c, options);
     }},
    {"pose", [](const Component& c) { return pose(c, c.options); }},
  };
}

// The results of one form for all shapes.
struct Row
{
  Form form;
  std::vector<Point_matrix> of_class; // rows: vertices of the file, NaN if not in the form
  std::vector<std::vector<Eigen::VectorXd>> values; // per descriptor, of all shapes
  std::map<std::string, double> differences;        // of classes
  double seconds = 0;
};

class Forms_benchmark
{
public:
  Forms_benchmark(const std::string& form, const bool is_corresponding, std::string prefix)
    : m_is_corresponding(is_corresponding),
      m_descriptors(Canonical_pose_tool::descriptors({"shape-distribution-d2", "views"})),
      m_prefix(std::move(prefix))
  {
    for(Form& each : all_forms())
      if(form.empty() || form == each.name)
        m_rows.push_back({each, {}, {m_descriptors.size(), std::vector<Eigen::VectorXd>()}, {}});
    if(m_rows.empty())
      throw std::invalid_argument("--form does not know " + form);
  }

  void add_class(const std::string& name, const std::vector<std::string>& files)
  {
    for(const std::string& file : files)
      add(file);
    for(Row& row : m_rows)
    {
      if(m_is_corresponding)
        add_difference(name, row);
      row.of_class.clear();
    }
    m_classes.insert(m_classes.end(), files.size(), m_number_of_classes++);
  }

  void print() const
  {
    std::printf("| %zu shapes, %zu classes | difference | D2: NN | FT | DCG | views: NN | FT | DCG "
                "| seconds |\n|---|---|---|---|---|---|---|---|---|\n",
                m_classes.size(), m_number_of_classes);
    for(const Row& row : m_rows)
    {
      double sum = 0;
      for(const auto& difference : row.differences)
        sum += difference.second;
      std::printf("| %s |", row.form.name.c_str());
      if(!row.differences.empty())
        std::printf(" %.3f", sum / static_cast<double>(row.differences.size()));
      std::printf(" |");
      for(std::size_t d = 0; d < m_descriptors.size(); ++d)
      {
        const CP::Retrieval_measures m
          = CP::Retrieval_evaluation(distances(m_descriptors[d], row.values[d]), m_classes).mean();
        std::printf(" %.3f | %.3f | %.3f |", m.nearest_neighbor, m.first_tier,
                    m.discounted_cumulative_gain);
      }
      std::printf(" %.2f |\n", row.seconds / static_cast<double>(m_classes.size()));
      for(const auto& [name, difference] : row.differences)
        std::printf("  %s: %.3f\n", name.c_str(), difference);
    }
  }

private:
  void add(const std::string& file)
  {
    const Mesh_file mesh = Canonical_pose_tool::read_mesh_file(file);
    const Component component = prepared_surface(mesh).components.front();
    const CGAL::Canonical_pose_3::Face_list polygons = component.surface.triangles;
    for(Row& row : m_rows)
    {
      const Processor_clock clock;
      const Point_matrix points = row.form.points(component);
      row.seconds += clock.seconds();
      for(std::size_t d = 0; d < m_descriptors.size(); ++d)
        row.values[d].push_back(m_descriptors[d].values(points, polygons));
      Point_matrix of_file = Point_matrix::Constant(static_cast<Eigen::Index>(mesh.points.size()),
                                                    3, std::numeric_limits<double>::quiet_NaN());
      for(std::size_t v = component.surface.origins.size(); v-- > 0;)
        of_file.row(static_cast<Eigen::Index>(component.surface.origins[v]))
          = points.row(static_cast<Eigen::Index>(v));
      write_picture_mesh(m_prefix, stem_of(file) + "_" + row.form.name, mesh, of_file);
      row.of_class.push_back(std::move(of_file));
    }
  }

  static void add_difference(const std::string& name, Row& row)
  {
    std::vector<Eigen::Index> common;
    for(const Point_matrix& points : row.of_class)
      if(points.rows() != row.of_class.front().rows())
        throw std::invalid_argument("the files of " + name + " have different vertices");
    for(Eigen::Index v = 0; v < row.of_class.front().rows(); ++v)
      if(std::all_of(row.of_class.begin(), row.of_class.end(),
                     [&](const Point_matrix& points) { return points.row(v).allFinite(); }))
        common.push_back(v);
    for(Point_matrix& points : row.of_class)
      points = Point_matrix(points(common, Eigen::all));
    if(row.of_class.size() > 1)
      row.differences[name] = CP::mean_pose_difference(row.of_class, true);
  }

  static Eigen::MatrixXd distances(const Canonical_pose_tool::Descriptor& descriptor,
                                   const std::vector<Eigen::VectorXd>& values)
  {
    const auto n = static_cast<Eigen::Index>(values.size());
    Eigen::MatrixXd all(descriptor.size, n), result(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
      all.col(i) = values[static_cast<std::size_t>(i)];
    for(Eigen::Index i = 0; i < n; ++i)
      result.col(i) = descriptor.distances(all.col(i), all);
    return result;
  }

  bool m_is_corresponding;
  std::vector<Canonical_pose_tool::Descriptor> m_descriptors;
  std::string m_prefix;
  std::vector<Row> m_rows;
  std::vector<std::size_t> m_classes; // of the shapes
  std::size_t m_number_of_classes = 0;
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    Argument_list arguments(argc, argv);
    const std::string form = arguments.take_text("--form");
    const std::string prefix = arguments.take_text("--prefix");
    const bool is_corresponding = arguments.take_flag("--corresponding");
    if(arguments.rest().size() < 2)
      throw std::invalid_argument("the classes and files of shapes are needed");
    const std::map<std::string, std::string> classes
      = Canonical_pose_tool::read_classes(arguments.rest().front());
    std::map<std::string, std::vector<std::string>> files;
    for(std::size_t i = 1; i < arguments.rest().size(); ++i)
    {
      const auto found = classes.find(stem_of(arguments.rest()[i]));
      if(found != classes.end())
        files[found->second].push_back(arguments.rest()[i]);
    }
    std::printf("%s\n", setting().c_str());
    Forms_benchmark benchmark(form, is_corresponding, prefix);
    for(const auto& [name, members] : files)
      benchmark.add_class(name, members);
    benchmark.print();
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "canonical_forms_benchmark: " << e.what() << '\n';
    return 2;
  }
}
