// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Report.h"

#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Numbers that are not finite become null.
using Json = nlohmann::ordered_json;
using Diagnosis_3 = CGAL::Canonical_pose_3::Diagnosis_3;
using Registration_summary = CGAL::Canonical_pose_3::Registration_summary;
using Skeleton_3 = CGAL::Canonical_pose_3::Skeleton_3;

Json input_of(const Diagnosis_3& d)
{
  return {{"vertices", d.vertices},
          {"faces", d.faces},
          {"components", d.components},
          {"boundary_edges", d.boundary_edges},
          {"non_manifold", d.non_manifold_edges + d.non_manifold_vertices},
          {"degenerate_faces", d.degenerate_faces},
          {"self_intersections", d.self_intersections                 ? Json(*d.self_intersections)
                                 : d.has_searched_self_intersections ? Json()
                                                                     : Json("not searched")}};
}

Json target_of(const Registration_summary& s)
{
  return {{"kernel", s.target.kernel},
          {"landmarks", s.target.landmarks},
          {"covering_radius", s.target.covering_radius},
          {"stress", s.target.stress},
          {"eigenvalues", s.target.eigenvalues},
          {"max_geodesic", s.target.max_geodesic},
          {"scale", s.target.scale},
          {"reflected", s.target.reflected},
          {"is_handedness_certain", s.target.is_handedness_certain},
          {"symmetry_distortion",
           s.target.symmetry_distortion ? Json(*s.target.symmetry_distortion) : Json()}};
}

Json followers_of(const Registration_summary& s)
{
  Json result = Json::array();
  for(const Registration_summary::Follower& follower : s.followers)
    result.push_back({{"component", follower.component},
                      {"vertex", follower.vertex},
                      {"leader", follower.leader},
                      {"rigid", follower.is_rigid}});
  return result;
}

Json rounds_of(const Registration_summary& s)
{
  Json result = Json::array();
  for(const Registration_summary::Round& round : s.rounds)
    result.push_back({{"stress", round.stress},
                      {"energy", round.energy},
                      {"median_edge_strain", round.median_edge_strain},
                      {"seconds", round.seconds}});
  return result;
}

Json registration_of(const Registration_summary& s)
{
  return {{"iterations", s.iterations},
          {"converged", s.converged()},
          {"energy", s.energy},
          {"energy_match", s.energy_match},
          {"energy_arap", s.energy_arap},
          {"energy_constraints", s.energy_constraints},
          {"inverted", s.inverted},
          {"flipped_faces", s.flipped_faces},
          {"volume_ratio", s.volume_ratio},
          {"median_edge_strain", s.median_edge_strain}};
}

std::size_t peak_memory_bytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

Json skeleton_of(const std::optional<Skeleton_3>& skeleton)
{
  if(!skeleton)
    return {};
  Json joints = Json::array();
  for(const Skeleton_3::Joint& joint : skeleton->joints)
    joints.push_back({{"name", joint.name},
                      {"parent", skeleton->joints[joint.parent].name},
                      {"position", {joint.position[0], joint.position[1], joint.position[2]}},
                      {"radius", joint.radius}});
  return {{"kind", skeleton->kind == Skeleton_3::Kind::PERSON ? "person" : "four-legged"},
          {"is_front_certain", skeleton->is_front_certain},
          {"joints", joints}};
}

Json versions()
{
  const CGAL::Canonical_pose_3::Library_configuration c
    = CGAL::Canonical_pose_3::library_configuration();
  const auto optional = [](const std::optional<std::string>& version) {
    return version ? Json(*version) : Json();
  };
  return {{"canonical_pose_3", c.canonical_pose_3},
          {"cgal", c.cgal},
          {"eigen", c.eigen},
          {"boost", c.boost},
          {"cholmod", optional(c.cholmod)},
          {"tbb", optional(c.tbb)},
          {"compiler", c.compiler}};
}

void write(std::ostream& out, Json report, const std::vector<Registration_summary::Stage>& stages,
           const double total_seconds)
{
  report["stages"] = Json::array();
  for(const Registration_summary::Stage& stage : stages)
    report["stages"].push_back({{"name", stage.first}, {"seconds", stage.second}});
  report["total_seconds"] = total_seconds;
  report["peak_memory_bytes"] = peak_memory_bytes();
  report["versions"] = versions();
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

} // namespace

void write_report(std::ostream& out, const Registration_summary& summary,
                  const double total_seconds, const std::optional<Skeleton_3>& skeleton)
{
  const Json body = {{"kind", summary.body.kind},
                     {"vertices", summary.body.vertices},
                     {"tetrahedra", summary.body.tetrahedra}};
  write(out,
        {{"input", input_of(summary.input)},
         {"body", body},
         {"followers", followers_of(summary)},
         {"target", target_of(summary)},
         {"rounds", rounds_of(summary)},
         {"registration", registration_of(summary)},
         {"skeleton", skeleton_of(skeleton)},
         {"solver", summary.solver},
         {"warnings", summary.warnings}},
        summary.stages, total_seconds);
}

void write_report(std::ostream& out, const Diagnosis_3& diagnosis,
                  const std::vector<Registration_summary::Stage>& stages,
                  const double total_seconds)
{
  const Json first_defect = diagnosis.defects.empty() ? Json() : Json(diagnosis.first_defect);
  Json defects = Json::array();
  for(const Diagnosis_3::Defect& defect : diagnosis.defects)
    defects.push_back({{"kind", defect.kind},
                       {"count", defect.count},
                       {"element", defect.element},
                       {"examples", defect.examples},
                       {"message", defect.message}});
  write(out, {{"input", input_of(diagnosis)}, {"first_defect", first_defect}, {"defects", defects}},
        stages, total_seconds);
}

void write_report(std::ostream& out, const Segmentation_report& segmentation,
                  const double seconds_to_write, const double total_seconds)
{
  Json parts = Json::array();
  for(const auto& part : segmentation.parts)
  {
    Json neighbors = Json::array();
    for(const auto& neighbor : part.neighbors)
      neighbors.push_back({{"part", neighbor.part},
                           {"boundary_length", neighbor.boundary_length},
                           {"boundary_centroid",
                            {neighbor.boundary_centroid[0], neighbor.boundary_centroid[1],
                             neighbor.boundary_centroid[2]}}});
    parts.push_back(
      {{"area", part.area}, {"faces", part.number_of_faces}, {"neighbors", neighbors}});
  }
  Json tree;
  if(segmentation.tree)
  {
    Json merges = Json::array();
    for(const auto& merge : segmentation.tree->merges)
      merges.push_back({{"nodes", merge.nodes}, {"cost", merge.cost}});
    tree = {{"leaves", segmentation.tree->number_of_leaves},
            {"leaf_of_face", segmentation.tree->leaf_of_face},
            {"merges", merges}};
  }
  auto stages = segmentation.stages;
  stages.emplace_back("write", seconds_to_write);
  write(out,
        {{"method", segmentation.method},
         {"parts", parts},
         {"tree", tree},
         {"warnings", segmentation.warnings}},
        stages, total_seconds);
}

void write_report(std::ostream& out, const CGAL::Canonical_pose_3::Surface_match_3& match,
                  const std::vector<std::string>& warnings,
                  const std::vector<Registration_summary::Stage>& stages,
                  const double total_seconds)
{
  write(out,
        {{"mean_distance", match.mean_distance},
         {"mean_round_trip", match.mean_round_trip},
         {"edge_strain", match.edge_strain},
         {"is_rotation_certain", match.is_rotation_certain},
         {"compared_share", match.compared_share},
         {"compared_share_of_other", match.compared_share_of_other},
         {"warnings", warnings}},
        stages, total_seconds);
}

void write_outcome(std::ostream& out, const Registration_summary& summary)
{
  out << summary << '\n';
  for(const std::string& warning : summary.warnings)
    out << "warning: " << warning << '\n';
}

void write_table(std::ostream& out, const Diagnosis_3& diagnosis)
{
  const auto write_line = [&](std::string name, const std::string& value) {
    name.resize((std::max)(name.size() + 1, std::size_t(26)), ' ');
    out << name << value << '\n';
  };
  const Json input = input_of(diagnosis);
  for(const auto& field : input.items())
    write_line(field.key(), field.value().is_null() ? "not examined" : field.value().dump());
  write_line("first_defect", diagnosis.defects.empty() ? "none" : diagnosis.first_defect);
  for(const Diagnosis_3::Defect& defect : diagnosis.defects)
  {
    std::string line = std::to_string(defect.count);
    for(const std::vector<std::size_t>& example : defect.examples)
    {
      line += (&example == &defect.examples.front() ? ": " : ", ") + defect.element;
      for(const std::size_t i : example)
        line += ' ' + std::to_string(i);
    }
    write_line("defect " + defect.kind,
               line + (defect.examples.size() < defect.count ? ", ..." : ""));
  }
}

void write_descriptors(std::ostream& out, const std::vector<Described_shape>& descriptors)
{
  Json json = Json::object();
  for(const Described_shape& d : descriptors)
    json[d.name]
      = {{"version", d.version}, {"values", std::vector<double>(d.values.begin(), d.values.end())}};
  out << json.dump(2) << '\n';
}

} // namespace Canonical_pose_tool
