// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The compiled part of the module: everything that crosses from Python to the library and back.
// The functions that users call, with their defaults and documentation, are in
// canonical_pose/__init__.py.

#include "Descriptor_index.h"
#include "Keywords.h"
#include "arrays.h"
#include "solvers.h"

#include "Output_files.h"
#include "Report.h"
#include "compute_parts.h"
#include "compute_pose.h"
#include "descriptors.h"
#include "exact_geodesics.h"
#include "formats/Cgal_types.h"
#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"

#include <CGAL/Canonical_pose_3/align_handedness.h>
#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/library_configuration.h>
#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/mean_pose.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/transfer_attributes.h>

#include <CGAL/assertions_behaviour.h>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace Canonical_pose_python;
using Canonical_pose_tool::Stage_clock;
namespace tool = Canonical_pose_tool;

// CGAL prints its errors; here they are exceptions.
void do_not_print(const char*, const char*, const char*, int, const char*) {}

template <class... Arguments>
std::string report_of(const Arguments&... arguments)
{
  std::ostringstream out;
  tool::write_report(out, arguments...);
  return out.str();
}

py::tuple pose(const py::object& vertices, const py::object& faces, const py::object& cells,
               const py::dict& keywords)
{
  const Mesh_file input = mesh_of(vertices, faces, cells);
  const Options options = options_of(keywords);
  if(input.is_tetrahedral && options.body != Options::Body::AUTOMATIC)
    throw std::invalid_argument("option body: a tetrahedral mesh is its own body");
  Stage_clock clock;
  Result result = without_lock([&] { return tool::compute_pose(input, options); });
  return py::make_tuple(std::move(result.pose), std::move(*result.target),
                        report_of(result.summary, clock.total(), result.skeleton));
}

py::tuple target(const py::object& vertices, const py::object& faces, const py::dict& keywords)
{
  const Mesh_file input = surface_of(vertices, faces);
  const Options options = options_of(keywords);
  Stage_clock clock;
  Result result = without_lock([&] { return first_target(input, options); });
  return py::make_tuple(std::move(*result.target), report_of(result.summary, clock.total()));
}

Eigen::MatrixXd geodesics(const py::object& vertices, const py::object& faces,
                          const py::object& sources, const py::dict& keywords)
{
  const Mesh_file input = surface_of(vertices, faces);
  const Options options = options_of(keywords);
  const std::vector<std::size_t> source_vertices
    = vertices_of(sources, input.points.size(), "source");
  const bool is_exact = static_cast<bool>(options.landmark_fields_function);
  return without_lock([&] {
    return CGAL::Canonical_pose_3::geodesic_distances(
      tool::matrix_of(tool::points_of(input)), input.faces, source_vertices, options,
      is_exact ? tool::exact_distances : CGAL::Canonical_pose_3::Distances_function());
  });
}

std::string check(const py::object& vertices, const py::object& faces, const py::object& cells)
{
  const Mesh_file input = mesh_of(vertices, faces, cells, false);
  return without_lock([&] {
    Stage_clock clock;
    const auto diagnosis = tool::diagnosis_of(input);
    const double seconds = clock.lap();
    using Stages = std::vector<CGAL::Canonical_pose_3::Registration_summary::Stage>;
    return report_of(diagnosis, Stages{{"diagnosis", seconds}}, clock.total());
  });
}

std::vector<Point_matrix> matrices_of(const std::vector<py::object>& poses)
{
  std::vector<Point_matrix> result;
  for(const py::object& pose : poses)
    result.push_back(point_matrix_of(pose, "pose " + std::to_string(result.size())));
  return result;
}

std::pair<double, double> compare(const std::vector<py::object>& poses)
{
  const std::vector<Point_matrix> matrices = matrices_of(poses);
  return without_lock([&] {
    return std::make_pair(CGAL::Canonical_pose_3::mean_pose_difference(matrices, false),
                          CGAL::Canonical_pose_3::mean_pose_difference(matrices, true));
  });
}

std::vector<bool> align_handedness(const std::vector<py::object>& poses)
{
  const std::vector<Point_matrix> matrices = matrices_of(poses);
  return without_lock([&] { return CGAL::Canonical_pose_3::align_handedness(matrices); });
}

Point_matrix mean_pose(const std::vector<py::object>& poses)
{
  std::vector<Point_matrix> matrices = matrices_of(poses);
  return without_lock([&] { return CGAL::Canonical_pose_3::mean_pose(std::move(matrices)); });
}

// The given pose, if there is one.
std::optional<Point_matrix> pose_of(const py::object& values, const Mesh_file& surface)
{
  if(values.is_none())
    return std::nullopt;
  Point_matrix pose = point_matrix_of(values, "pose");
  if(pose.rows() != static_cast<Eigen::Index>(surface.points.size()))
    throw std::invalid_argument("the pose has " + std::to_string(pose.rows())
                                + " vertices, but the surface has "
                                + std::to_string(surface.points.size()));
  return pose;
}

py::tuple segment(const py::object& vertices, const py::object& faces,
                  const std::size_t number_of_parts, const std::string& method,
                  const py::object& given_pose, const py::dict& keywords)
{
  const Mesh_file surface = surface_of(vertices, faces);
  const tool::Segmentation_input input{surface, method, pose_of(given_pose, surface),
                                       options_of(keywords), number_of_parts};
  Stage_clock clock;
  tool::Segmentation_report report;
  std::vector<std::size_t> parts
    = without_lock([&] { return tool::compute_parts(input, report, clock); });
  return py::make_tuple(array_of(std::move(parts)), report_of(report, 0., clock.total()));
}

py::dict describe(const py::object& vertices, const py::object& faces,
                  const std::vector<std::string>& names, const py::object& given_pose,
                  const py::dict& keywords)
{
  const std::vector<tool::Descriptor> chosen = tool::descriptors(names);
  const Mesh_file surface = surface_of(vertices, faces);
  const Options options = options_of(keywords);
  std::optional<Point_matrix> pose = pose_of(given_pose, surface);
  std::vector<Eigen::VectorXd> values;
  const auto describe_surface = [&] {
    const Point_matrix points = tool::matrix_of(tool::points_of(surface));
    for(const tool::Descriptor& descriptor : chosen)
    {
      if(descriptor.needs_pose && !pose)
        pose = tool::compute_pose(surface, options).pose;
      values.push_back(descriptor.values(descriptor.needs_pose ? *pose : points, surface.faces));
    }
  };
  without_lock([&] {
    CGAL::Canonical_pose_3::call_with_threads(options.number_of_threads, describe_surface);
  });
  py::dict result;
  for(std::size_t i = 0; i < chosen.size(); ++i)
    result[chosen[i].name.c_str()]
      = py::dict(py::arg("version") = chosen[i].version, py::arg("values") = values[i]);
  return result;
}

// Faces, vertices and weights.
py::tuple
arrays_of(const std::vector<CGAL::Canonical_pose_3::Surface_match_3::Location>& locations)
{
  std::vector<std::size_t> faces, corners;
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(locations.size()), 3);
  for(const auto& location : locations)
  {
    for(std::size_t k = 0; k < 3; ++k)
      weights(static_cast<Eigen::Index>(faces.size()), static_cast<Eigen::Index>(k))
        = location.weights[k];
    faces.push_back(location.face);
    corners.insert(corners.end(), location.vertices.begin(), location.vertices.end());
  }
  return py::make_tuple(array_of(std::move(faces)),
                        array_of(std::move(corners)).attr("reshape")(-1, 3), std::move(weights));
}

void check_landmarks(const py::object& vertices, const py::object& faces,
                     const py::object& other_vertices, const py::object& other_faces,
                     const std::vector<std::pair<std::size_t, std::size_t>>& landmarks)
{
  CGAL::Canonical_pose_3::Match_options options;
  options.landmarks = landmarks;
  options.check(surface_of(vertices, faces).points.size(),
                surface_of(other_vertices, other_faces).points.size());
}

py::tuple match(const py::object& vertices, const py::object& faces, const py::object& pose,
                const py::object& other_vertices, const py::object& other_faces,
                const py::object& other_pose,
                const std::vector<std::pair<std::size_t, std::size_t>>& landmarks,
                const py::dict& keywords)
{
  namespace CP = CGAL::Canonical_pose_3;
  const Mesh_file surface = surface_of(vertices, faces),
                  other = surface_of(other_vertices, other_faces);
  const Point_matrix poses[] = {*pose_of(pose, surface), *pose_of(other_pose, other)};
  CP::Match_options options;
  options.landmarks = landmarks;
  options.number_of_threads = options_of(keywords).number_of_threads;
  const CP::Surface_match_3 match = without_lock([&] {
    const auto prepared = [](const Mesh_file& mesh, const Point_matrix& given) {
      return CP::Matchable_surface_3(tool::matrix_of(tool::points_of(mesh)), mesh.faces, given);
    };
    return CP::match_surfaces(prepared(surface, poses[0]), prepared(other, poses[1]), options);
  });
  return arrays_of(match.locations) + arrays_of(match.locations_of_other)
         + py::make_tuple(match.round_trips, match.scale, match.mean_distance, match.edge_strain,
                          match.is_rotation_certain, match.compared_share,
                          match.compared_share_of_other);
}

// `corners` and `weights`: of the vertices, on the other surface.
py::array matched_faces(const py::array_t<std::size_t>& corners, const Eigen::MatrixXd& weights,
                        const py::object& faces, const py::object& other_vertices,
                        const py::object& other_faces)
{
  const Mesh_file other = surface_of(other_vertices, other_faces);
  CGAL::Canonical_pose_3::Surface_match_3 match;
  const auto at = corners.unchecked<2>();
  for(Eigen::Index v = 0; v < weights.rows(); ++v)
  {
    auto& location = match.locations.emplace_back();
    for(std::size_t k = 0; k < 3; ++k)
    {
      location.vertices[k] = at(v, static_cast<py::ssize_t>(k));
      location.weights[k] = weights(v, static_cast<Eigen::Index>(k));
      if(location.vertices[k] >= other.points.size())
        throw std::invalid_argument("vertex " + std::to_string(v) + " is at vertex "
                                    + std::to_string(location.vertices[k]) + ", but there are "
                                    + std::to_string(other.points.size()));
    }
  }
  Mesh_file surface;
  surface.points.resize(match.locations.size());
  return array_of(CGAL::Canonical_pose_3::matched_faces(
    match, faces_of(faces, surface), tool::matrix_of(tool::points_of(other)), other.faces));
}

// Faces with the same number of corners each are a matrix, others a list of lists.
py::object faces_array(const tool::Face_list& faces)
{
  const std::size_t corners = faces.empty() ? 3 : faces[0].size();
  bool is_matrix = true;
  for(std::size_t f = 0; f < faces.size() && is_matrix; ++f)
    is_matrix = faces[f].size() == corners;
  py::list lists;
  if(!is_matrix)
  {
    for(const auto face : faces)
      lists.append(py::cast(std::vector<std::size_t>(face.begin(), face.end())));
    return std::move(lists);
  }
  std::vector<std::size_t> all;
  for(const auto face : faces)
    all.insert(all.end(), face.begin(), face.end());
  return array_of(std::move(all)).attr("reshape")(-1, corners);
}

py::tuple load(const std::string& path)
{
  const Mesh_file mesh = without_lock([&] {
    tool::forget_streams();
    return tool::read_other_mesh_file(path);
  });
  py::array_t<double> vertices({static_cast<py::ssize_t>(mesh.points.size()), py::ssize_t(3)});
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      vertices.mutable_at(static_cast<py::ssize_t>(v), static_cast<py::ssize_t>(k))
        = mesh.points[v][k];
  if(!mesh.is_tetrahedral)
    return py::make_tuple(std::move(vertices), faces_array(mesh.faces), py::none());
  std::vector<std::size_t> cells;
  for(const auto& cell : mesh.cells)
    cells.insert(cells.end(), cell.begin(), cell.end());
  return py::make_tuple(std::move(vertices), py::none(),
                        array_of(std::move(cells)).attr("reshape")(-1, 4));
}

// Returns what is lost of the file `like`.
std::vector<std::string> save(const std::string& path, const py::object& vertices,
                              const py::object& faces, const py::object& cells,
                              const std::optional<std::string>& like)
{
  Mesh_file mesh;
  if(!like)
    mesh = mesh_of(vertices, faces, cells);
  const auto points = points_of(vertices, "vertices");
  return without_lock([&] {
    tool::forget_streams();
    if(like)
      mesh = tool::read_other_mesh_file(*like, tool::Source::KEPT);
    if(points.size() != mesh.points.size())
      throw std::invalid_argument("there are " + std::to_string(points.size()) + " vertices, but '"
                                  + *like + "' has " + std::to_string(mesh.points.size()));
    const tool::Format format = tool::format_of(path, tool::Use::WRITE);
    if(mesh.is_tetrahedral != (format == tool::Format::MEDIT || format == tool::Format::VTU))
      throw std::invalid_argument(mesh.is_tetrahedral
                                    ? "a tetrahedral mesh is written as .mesh or .vtu"
                                    : "a surface cannot be written as .mesh or .vtu");
    tool::check_format_holds(format, mesh);
    tool::Output_files files({path});
    files.write_with_files(path, [&](std::ostream& out, tool::Companion_files* const beside) {
      if(tool::is_rewritable(mesh, format))
        return tool::rewrite_mesh(out, mesh, points, {}, beside);
      tool::load_appearance(mesh);
      Mesh_file written = mesh;
      written.points = points;
      tool::turn_normals(written, mesh.points);
      tool::write_mesh(out, format, written, beside);
    });
    files.commit();
    return tool::losses(mesh, format, tool::is_rewritable(mesh, format),
                        tool::has_files_beside(path));
  });
}

// Sources of a solver.
std::vector<std::size_t> sources_of(const Heat_solver& solver, const py::object& sources)
{
  return vertices_of(sources, solver.number_of_vertices(), "source");
}

py::tuple registered(Registrar& registrar, const py::object& target, const bool is_warm,
                     const py::object& progress)
{
  const Point_matrix points = point_matrix_of(target, "target");
  const auto visitor = visitor_of(progress);
  const Uninterrupted during_iterations; // the visitor looks for signals between them
  Result result = without_lock([&] { return registrar.registered_to(points, is_warm, visitor); });
  const auto& summary = result.summary;
  py::dict report(
    py::arg("iterations") = summary.iterations, py::arg("converged") = summary.converged(),
    py::arg("energy") = summary.energy, py::arg("energy_match") = summary.energy_match,
    py::arg("energy_arap") = summary.energy_arap, py::arg("inverted") = summary.inverted,
    py::arg("volume_ratio") = summary.volume_ratio);
  return py::make_tuple(std::move(result.pose), std::move(report));
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  CGAL::set_error_handler(do_not_print);
  CGAL::set_warning_handler(do_not_print);
  let_signals_interrupt();
  module.attr("version") = CGAL_CANONICAL_POSE_3_VERSION;
  module.def("pose", &pose);
  module.def("target", &target);
  module.def("geodesics", &geodesics);
  module.def("check", &check);
  module.def("compare", &compare);
  module.def("align_handedness", &align_handedness);
  module.def("mean_pose", &mean_pose);
  module.def("check_landmarks", &check_landmarks);
  module.def("match", &match);
  module.def("matched_faces", &matched_faces);
  module.def("segment", &segment);
  module.def("describe", &describe);
  module.def("load", &load);
  module.def("save", &save);

  py::class_<Heat_solver>(module, "Heat_solver")
    .def(py::init([](const py::object& vertices, const py::object& faces,
                     const double time_step_factor) {
      const Mesh_file surface = surface_of(vertices, faces);
      return without_lock([&] { return std::make_unique<Heat_solver>(surface, time_step_factor); });
    }))
    .def("distances",
         [](const Heat_solver& self, const py::object& sources) {
           const std::vector<std::size_t> vertices = sources_of(self, sources);
           return without_lock([&] { return self.distances(vertices); });
         })
    .def("distance_to_nearest", [](const Heat_solver& self, const py::object& sources) {
      const std::vector<std::size_t> vertices = sources_of(self, sources);
      return without_lock([&] { return self.distance_to_nearest(vertices); });
    });

  py::class_<Registrar>(module, "Registrar")
    .def(
      py::init([](const py::object& vertices, const py::object& faces, const py::dict& keywords) {
        const Mesh_file surface = surface_of(vertices, faces);
        const Options options = options_of(keywords);
        return without_lock([&] { return std::make_unique<Registrar>(surface, options); });
      }))
    .def("register", &registered)
    .def("set_detail_length",
         [](Registrar& self, const double detail_length) {
           const Uninterrupted at_all;
           without_lock([&] { self.set_detail_length(detail_length); });
         })
    .def("target", &Registrar::target, py::return_value_policy::reference_internal)
    .def("body_vertices", &Registrar::body_points, py::return_value_policy::reference_internal)
    .def("body_cells", [](const py::object& self) {
      const auto& cells = self.cast<const Registrar&>().body_cells();
      py::array_t<int> result({static_cast<py::ssize_t>(cells.size()), py::ssize_t(4)},
                              cells.front().data(), self);
      result.attr("setflags")(py::arg("write") = false);
      return result;
    });

  py::class_<Descriptor_index>(module, "Descriptor_index")
    .def(py::init<const std::string&>())
    .def("__len__",
         [](const Descriptor_index& self) { return without_lock([&] { return self.size(); }); })
    .def("insert",
         [](Descriptor_index& self, const py::object& values) {
           const Eigen::VectorXd vector = vector_of(values, "values");
           return without_lock([&] { return self.insert(vector); });
         })
    .def("values",
         [](const Descriptor_index& self, const std::size_t shape) {
           return without_lock([&] { return self.values(shape); });
         })
    .def("distances",
         [](const Descriptor_index& self, const py::object& query) {
           const Eigen::VectorXd values = vector_of(query, "query");
           return without_lock([&] { return self.distances(values); });
         })
    .def(
      "all_distances",
      [](const Descriptor_index& self) { return without_lock([&] { return self.distances(); }); })
    .def("nearest",
         [](const Descriptor_index& self, const py::object& query, const std::size_t number) {
           const Eigen::VectorXd values = vector_of(query, "query");
           auto [shapes, distances] = without_lock([&] { return self.nearest(values, number); });
           return py::make_tuple(array_of(std::move(shapes)), std::move(distances));
         });
}
