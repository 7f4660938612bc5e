// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// glTF as the tool writes and reads it. What is written is also examined without our reader: by its
// JSON, and by the bytes to which its accessors lead.

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include "formats/Cgal_types.h"
#include "formats/Shown_surface.h"
#include "formats/readers.h"

#include <CGAL/canonical_pose_3.h>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"
#include "written_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_gltf {

using namespace Canonical_pose_tool;
using CGAL::Canonical_pose_3::Point_matrix;
using Canonical_pose_test::written_file;
using nlohmann::json;

Mesh_file mesh_of(const Canonical_pose_test::Triangle_soup& soup)
{
  Mesh_file mesh;
  mesh.points = soup.points;
  mesh.faces = soup.triangles;
  return mesh;
}

Mesh_file ball() { return mesh_of(Canonical_pose_test::icosphere_soup(2, 1.5)); }

std::string written(const Shown_surface& surface)
{
  std::ostringstream out;
  write_glb(out, surface);
  return out.str();
}

std::string written(const Mesh_file& mesh)
{
  std::ostringstream out;
  write_mesh(out, Format::GLB, mesh);
  return out.str();
}

Mesh_file read(const std::string& bytes)
{
  Mesh_file mesh;
  read_gltf(bytes, "", mesh);
  return mesh;
}

std::uint32_t number_at(const std::string& bytes, const std::size_t position)
{
  std::uint32_t number;
  std::memcpy(&number, &bytes[position], 4);
  return number;
}

json json_of(const std::string& bytes)
{
  return json::parse(bytes.substr(20, number_at(bytes, 12)));
}

// The same file with other JSON.
std::string with_json(const std::string& bytes, const json& changed)
{
  std::string text = changed.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string rest = bytes.substr(20 + number_at(bytes, 12));
  std::string result = bytes.substr(0, 8) + std::string(8, '\0') + "JSON" + text + rest;
  const std::uint32_t lengths[]
    = {static_cast<std::uint32_t>(result.size()), static_cast<std::uint32_t>(text.size())};
  std::memcpy(&result[8], lengths, 8);
  return result;
}

// The numbers of type Number in an accessor, or in an attribute; `target` is that of a morph target.
template <class Number>
std::vector<Number> numbers_of(const std::string& bytes, const int index)
{
  const json model = json_of(bytes);
  const json& accessor = model["accessors"][index];
  const json& view = model["bufferViews"][accessor["bufferView"].get<int>()];
  const std::size_t n = accessor["count"],
                    components = accessor["type"] == "SCALAR" ? 1
                                 : accessor["type"] == "VEC3" ? 3
                                 : accessor["type"] == "MAT4" ? 16
                                                              : 4,
                    stride = view.value("byteStride", components * sizeof(Number)),
                    begin = 28 + number_at(bytes, 12) + view.value("byteOffset", 0);
  std::vector<Number> result(n * components);
  for(std::size_t i = 0; i < n; ++i)
    std::memcpy(&result[i * components], &bytes[begin + i * stride], components * sizeof(Number));
  return result;
}

template <class Number>
std::vector<Number> numbers(const std::string& bytes, const std::string& attribute,
                            const int target = -1)
{
  const json primitive = json_of(bytes)["meshes"][0]["primitives"][0];
  return numbers_of<Number>(bytes, target < 0 ? primitive["attributes"][attribute]
                                              : primitive["targets"][target][attribute]);
}

void expect_near(const Mesh_file& a, const Mesh_file& b, const double tolerance)
{
  ASSERT_EQ(a.points.size(), b.points.size());
  for(std::size_t v = 0; v < a.points.size(); ++v)
    for(int k = 0; k < 3; ++k)
      ASSERT_NEAR(a.points[v][k], b.points[v][k], tolerance) << v;
  EXPECT_EQ(a.faces, b.faces);
}

Point_matrix matrix_of(const Mesh_file& mesh)
{
  Point_matrix points(static_cast<Eigen::Index>(mesh.points.size()), 3);
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    points.row(v) << mesh.points[v][0], mesh.points[v][1], mesh.points[v][2];
  return points;
}

Shown_surface scene_of(const Mesh_file& mesh)
{
  Shown_surface surface;
  surface.mesh = mesh;
  surface.origins.resize(mesh.points.size());
  std::iota(surface.origins.begin(), surface.origins.end(), std::size_t(0));
  Point_matrix target = 2 * matrix_of(mesh), pose = matrix_of(mesh);
  pose.col(0).swap(pose.col(1));
  surface.other_shapes = {{"target", target}, {"pose", pose}};
  return surface;
}

TEST(Gltf, vertices_and_faces_keep_their_order)
{
  Mesh_file mesh = ball();
  mesh.points.push_back({9, 9, 9});    // isolated
  mesh.faces.push_back({3, 3, 5});     // degenerate
  mesh.faces.push_back(mesh.faces[0]); // duplicate
  expect_near(read(written(mesh)), mesh, 1e-6);
}

TEST(Gltf, polygons_become_triangles)
{
  Mesh_file mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2, 3}};
  const Mesh_file found = read(written(mesh));
  EXPECT_EQ(found.points, mesh.points);
  EXPECT_EQ(found.faces.size(), 2u);
}

// Single precision is that of the surface, not of its distance from the origin.
TEST(Gltf, far_from_the_origin)
{
  Mesh_file mesh = ball();
  for(auto& p : mesh.points)
    p[1] += 4.5e6;
  expect_near(read(written(mesh)), mesh, 1e-6);
}

TEST(Gltf, what_single_precision_cannot_hold)
{
  for(const double scale : {1e60, 1e-60})
  {
    Mesh_file mesh = ball();
    for(auto& p : mesh.points)
      for(double& x : p)
        x *= scale;
    EXPECT_THROW_WITH(written(mesh), std::invalid_argument, "single precision");
  }
  EXPECT_THROW_WITH(written(Mesh_file()), std::invalid_argument, "at least one face");
}

// Where linear blend skinning takes the vertices, with some nodes rotated.
Eigen::MatrixX3d skinned(const std::string& bytes, const std::string& joint = {},
                         const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity())
{
  const json model = json_of(bytes), skin = model["skins"][0], nodes = model["nodes"];
  const std::vector<float> matrices = numbers_of<float>(bytes, skin["inverseBindMatrices"]),
                           positions = numbers<float>(bytes, "POSITION"),
                           weights = numbers<float>(bytes, "WEIGHTS_0");
  const std::vector<std::uint16_t> joints = numbers<std::uint16_t>(bytes, "JOINTS_0");
  std::map<int, Eigen::Affine3d> of_nodes;
  const std::function<void(int, Eigen::Affine3d)> visit
    = [&](const int node, Eigen::Affine3d of_node) {
        const json& n = nodes[node];
        if(n.contains("translation"))
          of_node.translate(
            Eigen::Vector3d(n["translation"][0], n["translation"][1], n["translation"][2]));
        if(n.value("name", std::string()) == joint)
          of_node.rotate(rotation);
        of_nodes[node] = of_node;
        for(const json& child : n.value("children", json::array()))
          visit(child, of_node);
      };
  for(const json& root : model["scenes"][0]["nodes"])
    visit(root, Eigen::Affine3d::Identity());
  Eigen::MatrixX3d result
    = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(positions.size() / 3), 3);
  for(std::size_t v = 0; v < positions.size() / 3; ++v)
  {
    float sum = 0;
    for(std::size_t k = 0; k < 4; ++k)
    {
      sum += weights[4 * v + k];
      const std::size_t j = joints[4 * v + k];
      const Eigen::Affine3d inverse(
        Eigen::Map<const Eigen::Matrix4f>(&matrices[16 * j]).cast<double>());
      result.row(static_cast<Eigen::Index>(v))
        += static_cast<double>(weights[4 * v + k])
           * (of_nodes.at(skin["joints"][j]) * inverse
              * Eigen::Map<const Eigen::Vector3f>(&positions[3 * v]).cast<double>())
               .transpose();
    }
    EXPECT_EQ(sum, 1);
  }
  return result;
}

// A person in a T: with its joints as they are, it is where it is; an elbow bends its forearm alone, and smoothly. The same
// far from the origin, with seams and two materials.
TEST(Gltf, a_stance_has_a_skin)
{
  const Canonical_pose_examples::Articulated_figure figure(3000);
  Mesh_file mesh;
  mesh.faces = figure.triangles();
  CGAL::Canonical_pose_3::Options options;
  options.stance = CGAL::Canonical_pose_3::Options::Stance::T;
  std::vector<Point_3> points, pose;
  for(const auto& p : figure.points(figure.named_poses()[0].angles))
    points.emplace_back(p[0], p[1], p[2]);
  const auto result = CGAL::canonical_pose_3(points, mesh.faces, pose, options);
  Shown_surface surface;
  for(const bool is_far : {false, true})
  {
    const Eigen::RowVector3d shift(is_far ? 1e6 : 0, 0, 0);
    mesh.points.clear();
    for(const Point_3& p : pose)
      mesh.points.push_back({p.x() + shift[0], p.y(), p.z()});
    surface.mesh = mesh;
    surface.origins.resize(pose.size());
    std::iota(surface.origins.begin(), surface.origins.end(), std::size_t(0));
    surface.skeleton = result.skeleton.value();
    for(auto& joint : surface.skeleton->joints)
      joint.position += shift;
    if(is_far)
    {
      surface.mesh.appearance.materials.resize(2);
      for(std::size_t f = 0; f < mesh.faces.size(); ++f)
      {
        surface.mesh.appearance.material_of_face.push_back(f % 2);
        for(const std::size_t v : mesh.faces[f])
          surface.mesh.appearance.texture_coordinates.push_back({v < 1500 ? float(f % 3) : 0, 0});
      }
    }
    const std::string bytes = written(surface);
    const Eigen::MatrixX3d at_rest
      = skinned(bytes),
      bent = skinned(bytes, "left elbow",
                     Eigen::Quaterniond(Eigen::AngleAxisd(CGAL_PI / 6, Eigen::Vector3d::UnitY())));
    EXPECT_EQ(json_of(bytes)["meshes"][0]["primitives"].size(), is_far ? 2u : 1u);
    EXPECT_EQ(at_rest.rows() > static_cast<Eigen::Index>(pose.size()), is_far);
    const std::vector<float> vertices = numbers<float>(bytes, "_VERTEX");
    ASSERT_EQ(static_cast<std::size_t>(at_rest.rows()), vertices.size());
    const auto position = [&](const std::string& name) {
      for(const auto& joint : surface.skeleton->joints)
        if(joint.name == name)
          return joint.position;
      throw std::out_of_range(name);
    };
    const double elbow = position("left elbow")[0], shoulder = position("left shoulder")[0],
                 wrist = position("left wrist")[0];
    for(Eigen::Index i = 0; i < at_rest.rows(); ++i)
    {
      const std::array<double, 3>& p
        = mesh.points[static_cast<std::size_t>(vertices[static_cast<std::size_t>(i)])];
      EXPECT_LT((at_rest.row(i) - Eigen::RowVector3d(p[0], p[1], p[2])).norm(), 2e-7);
      const double moved = (bent.row(i) - at_rest.row(i)).norm(), forearm = wrist - elbow;
      if(p[0] < .5 * (shoulder + elbow))
        EXPECT_LT(moved, 1e-9);
      if(p[0] > elbow + .5 * forearm)
        EXPECT_NEAR(moved,
                    2 * std::sin(CGAL_PI / 12)
                      * std::hypot(p[0] - elbow, p[2] - position("left elbow")[2]),
                    .02);
    }
    const std::vector<std::uint16_t> corners
      = numbers_of<std::uint16_t>(bytes, json_of(bytes)["meshes"][0]["primitives"][0]["indices"]);
    for(std::size_t c = 0; c < corners.size(); ++c)
    {
      const Eigen::Index a = corners[c], b = corners[c % 3 == 2 ? c - 2 : c + 1];
      EXPECT_LT((bent.row(a) - bent.row(b)).norm(), 1.5 * (at_rest.row(a) - at_rest.row(b)).norm());
    }
    if(!is_far)
      expect_near(read(bytes), mesh, 1e-6);
  }
}

TEST(Gltf, the_container_is_consistent)
{
  const std::string bytes = written(scene_of(ball()));
  EXPECT_EQ(number_at(bytes, 8), bytes.size());
  EXPECT_EQ(number_at(bytes, 12) % 4, 0u);
  const json model = json_of(bytes);
  for(const json& view : model["bufferViews"])
  {
    EXPECT_EQ(view.value("byteOffset", 0) % 4, 0);
    EXPECT_LE(view.value("byteOffset", 0) + view["byteLength"].get<int>(),
              model["buffers"][0]["byteLength"].get<int>());
  }
  EXPECT_EQ(model["meshes"][0]["extras"]["targetNames"], json({"target", "pose"}));
  EXPECT_EQ(model["animations"][0]["channels"][0]["target"]["path"], "weights");
  EXPECT_FALSE(model.contains("extensionsRequired"));
}

TEST(Gltf, normals_of_all_shapes_are_unit)
{
  const std::string bytes = written(scene_of(ball()));
  const std::vector<float> normals = numbers<float>(bytes, "NORMAL"),
                           pose = numbers<float>(bytes, "NORMAL", 1),
                           points = numbers<float>(bytes, "POSITION");
  for(std::size_t i = 0; i < normals.size(); i += 3)
  {
    EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-6);
    EXPECT_NEAR(
      std::hypot(normals[i] + pose[i], normals[i + 1] + pose[i + 1], normals[i + 2] + pose[i + 2]),
      1, 1e-6);
    EXPECT_GT(normals[i] * points[i] + normals[i + 1] * points[i + 1]
                + normals[i + 2] * points[i + 2],
              1.4);
  }
}

// Differences of large scenes are integers; all shapes are right up to 1 / 65 000 of the largest one.
TEST(Gltf, large_scenes_are_quantized)
{
  const Mesh_file mesh = mesh_of(Canonical_pose_test::plane_grid_soup(501, 501, 2, 1));
  const Shown_surface scene = scene_of(mesh);
  const std::string bytes = written(scene);
  EXPECT_EQ(json_of(bytes)["extensionsRequired"], json({"KHR_mesh_quantization"}));
  expect_near(read(bytes), mesh, 1e-6);
  const json node = json_of(bytes)["nodes"][0];
  const double unit = node["scale"][0];
  const std::vector<float> points = numbers<float>(bytes, "POSITION");
  for(int shape = 0; shape < 2; ++shape)
  {
    const std::vector<std::int16_t> differences = numbers<std::int16_t>(bytes, "POSITION", shape);
    ASSERT_EQ(differences.size(), points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      ASSERT_NEAR(unit * (points[i] + differences[i]) + node["translation"][i % 3].get<double>(),
                  scene.other_shapes[shape].points(i / 3, i % 3), 2. / 65000);
  }
}

// A vertex between two parts has a copy in each; _VERTEX leads back.
TEST(Gltf, parts_split_vertices)
{
  Shown_surface surface = scene_of(ball());
  surface.other_shapes.clear();
  surface.mesh.points.push_back({9, 9, 9});
  surface.origins.push_back(surface.origins.size());
  for(const Face_list::Face face : surface.mesh.faces)
    surface.part_of_face.push_back(surface.mesh.points[face[0]][0] > 0);
  const std::string bytes = written(surface);
  expect_near(read(bytes), surface.mesh, 1e-6);
  const std::vector<float> labels = numbers<float>(bytes, "_LABEL");
  const std::vector<std::uint16_t> colors = numbers<std::uint16_t>(bytes, "COLOR_0");
  EXPECT_GT(labels.size(), surface.mesh.points.size());
  EXPECT_EQ(labels.back(), -1); // of no face
  for(std::size_t i = 0; i < labels.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(labels[i] == labels[j],
                std::equal(&colors[4 * i], &colors[4 * i] + 4, &colors[4 * j]));
}

TEST(Gltf, values_are_attributes)
{
  Shown_surface surface = scene_of(ball());
  const Eigen::Index n = static_cast<Eigen::Index>(surface.mesh.points.size());
  surface.values = {{"distance", Eigen::VectorXd::LinSpaced(n, -1, 1e300)}};
  const std::vector<float> values = numbers<float>(written(surface), "_DISTANCE");
  EXPECT_EQ(values[0], -1);
  for(const float value : values)
    EXPECT_TRUE(std::isfinite(value));
}

// Whatever is in a file: it is read, or it is refused. The seed is fixed, so that this can be repeated.
TEST(Gltf, damaged_files_are_refused)
{
  const std::string bytes = written(ball());
  for(std::size_t length = 0; length < bytes.size(); length += length < 3000 ? 1 : 997)
    EXPECT_THROW(read(bytes.substr(0, length)), std::invalid_argument) << length;
  EXPECT_THROW_WITH(read(bytes + "x"), std::invalid_argument, "goes on for 1 bytes");
  std::mt19937 random(16);
  int refused = 0;
  for(int i = 0; i < 2000; ++i)
  {
    std::string damaged = bytes;
    for(int k = 0; k < 3; ++k)
      damaged[random() % (i % 2 == 0 ? 2500 : damaged.size())] = static_cast<char>(random());
    try
    {
      read(damaged);
    }
    catch(const std::invalid_argument&)
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(Gltf, unsupported_content_is_refused_by_name)
{
  const std::string bytes = written(ball());
  const auto expect_refusal
    = [&](const std::string& path, const json& value, const std::string& message) {
        json model = json_of(bytes);
        model[json::json_pointer(path)] = value;
        EXPECT_THROW_WITH(read(with_json(bytes, model)), std::invalid_argument, message);
      };
  const std::string primitive = "/meshes/0/primitives/0/";
  expect_refusal("/extensionsRequired", {"KHR_draco_mesh_compression"},
                 "the extension 'KHR_draco_mesh_compression' is required, but not supported");
  expect_refusal(primitive + "mode", 3,
                 "the primitive consists of line strips, but triangles are needed");
  expect_refusal(primitive + "mode", 9, "unknown mode 9");
  expect_refusal(primitive + "indices", 77, "out of bounds");
  expect_refusal(primitive + "attributes", {{"POSITION", 77}},
                 "the accessor of POSITION does not exist");
  expect_refusal(primitive + "attributes", {{"NORMAL", 1}}, "has no attribute POSITION");
  expect_refusal("/meshes/0/primitives/1", {{"attribute", {{"POSITION", 0}}}},
                 "a primitive of mesh 0 is not valid");
  expect_refusal("/meshes", json::array(), "node 0 names mesh 0, but there are 0");
  expect_refusal("/nodes/0/mesh", 1, "node 0 names mesh 1, but there are 1");
  expect_refusal("/nodes/0/children", {0}, "the nodes form a cycle");
  expect_refusal("/nodes/0/skin", 0, "a node names skin 0, but there are 0");
  expect_refusal("/nodes/0",
                 {{"mesh", 0}, {"translation", {1e308, 0, 0}}, {"scale", {1e308, 1, 1}}},
                 "has a coordinate that is too large");
  expect_refusal("/accessors/0/count", 1000000000000000,
                 "the accessor of POSITION is longer than its buffer view");
  expect_refusal("/accessors/0/type", "VEC2", "does not have 3 components");
  expect_refusal("/accessors/2/componentType", 5122, "the indices are not unsigned integers");
  expect_refusal("/accessors/2/count", 7, "the number of corners, 7, is no multiple of 3");
  expect_refusal("/bufferViews/0/byteLength", 4000000000,
                 "has a buffer view that is longer than its buffer");
  expect_refusal("/bufferViews/0/extensions", {{"EXT_meshopt_compression", {{"a", 1}}}},
                 "needs the extension EXT_meshopt_compression");
  expect_refusal("/buffers/0/byteLength", 4000000000, "not valid glTF");
  expect_refusal("/buffers/0/uri", "../b.bin",
                 "a buffer is in '../b.bin', which is not beside this file");
  expect_refusal("/buffers/0/uri", "https://a.b/c.bin", "which is not beside this file");
  expect_refusal("/bufferViews/0/byteOffset", -4,
                 "byteOffset of element 0 of bufferViews is negative");
  const json part = {{"bufferView", 0}, {"componentType", 5125}};
  expect_refusal("/accessors/0/sparse", {{"count", 1}, {"indices", part}, {"values", part}},
                 "is sparse");
  json deep = 1;
  for(int i = 0; i < 100; ++i)
    deep = json::array({deep});
  expect_refusal("/extras", deep, "nested more than 64 levels deep");
  std::string brackets(1000000, '[');
  EXPECT_THROW_WITH(read(brackets), std::invalid_argument, "levels deep");
}

TEST(Gltf, nodes_move_the_mesh)
{
  const Mesh_file mesh = ball();
  const std::string bytes = written(mesh);
  json model = json_of(bytes);
  const double half = std::sqrt(0.5);
  model["nodes"][0] = {{"mesh", 0},
                       {"translation", {1, 2, 3}},
                       {"rotation", {0, 0, half, half}},
                       {"scale", {2, 3, 4}}};
  model["nodes"][1]
    = {{"children", {0}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1}}};
  const Mesh_file moved = read(with_json(bytes, model));
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    EXPECT_NEAR(moved.points[v][0], 11 - 3 * mesh.points[v][1], 1e-5);
    EXPECT_NEAR(moved.points[v][1], 22 + 2 * mesh.points[v][0], 1e-5);
    EXPECT_NEAR(moved.points[v][2], 33 + 4 * mesh.points[v][2], 1e-5);
  }
}

// The same file with an accessor after its buffer. Returns its index.
template <class Number>
std::size_t add_accessor(std::string& bytes, json& model, const std::string& type,
                         const int component_type, const std::vector<Number>& numbers,
                         const std::size_t count)
{
  const std::size_t chunk = 20 + number_at(bytes, 12), begin = number_at(bytes, chunk);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  bytes.resize((bytes.size() + 3) / 4 * 4);
  const auto size = static_cast<std::uint32_t>(bytes.size() - chunk - 8);
  std::memcpy(&bytes[chunk], &size, sizeof(size));
  model["buffers"][0]["byteLength"] = size;
  model["bufferViews"].push_back(
    {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", numbers.size() * sizeof(Number)}});
  model["accessors"].push_back({{"bufferView", model["bufferViews"].size() - 1},
                                {"componentType", component_type},
                                {"count", count},
                                {"type", type}});
  return model["accessors"].size() - 1;
}

// A vertex is at the mean of the places to which its joints move it, wherever its node is. The pose has
// the same positions without a skin, in the space of the node.
TEST(Gltf, skins)
{
  Mesh_file mesh = ball();
  const std::size_t n = mesh.points.size();
  std::string bytes = written(mesh);
  json model = json_of(bytes);
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for(std::size_t v = 0; v < n; ++v)
  {
    joints.insert(joints.end(), {0, 1, 0, 0});
    const float second = v % 2 == 0 ? .25f : 0;
    weights.insert(weights.end(), {1 - second, second, 0, 0});
  }
  // The second joint rests at (0, 0, 5).
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,  1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1};
  json& primitive = model["meshes"][0]["primitives"][0];
  primitive["attributes"]["JOINTS_0"] = add_accessor(bytes, model, "VEC4", 5121, joints, n);
  primitive["attributes"]["WEIGHTS_0"] = add_accessor(bytes, model, "VEC4", 5126, weights, n);
  const std::size_t inverse = add_accessor(bytes, model, "MAT4", 5126, matrices, 2);
  model["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
  const double half = std::sqrt(.5);
  model["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}, {"scale", {2, 1, 1}}},
                    {{"children", {2}}, {"translation", {0, 7, 0}}},
                    {{"rotation", {half, 0, 0, half}}, {"translation", {0, 0, 5}}}};
  model["scenes"][0]["nodes"] = {0, 1};
  const std::string file = with_json(bytes, model);
  mesh = read(file);
  const Mesh_file rest = ball();
  for(std::size_t v = 0; v < n; ++v)
  {
    const Eigen::Vector3d p = Eigen::Vector3d::Map(rest.points[v].data()),
                          first = p + Eigen::Vector3d(0, 7, 0),
                          // a quarter around the x axis through (0, 0, 5)
      second(p[0], 7 - (p[2] - 5), 5 + p[1]);
    const double share = v % 2 == 0 ? .25 : 0;
    EXPECT_LT((Eigen::Vector3d::Map(mesh.points[v].data()) - ((1 - share) * first + share * second))
                .norm(),
              1e-5);
  }

  mesh.source = std::make_shared<const Source_file>(Source_file{Format::GLB, file});
  EXPECT_EQ(losses(mesh, Format::GLB), std::vector<std::string>{"skins"});
  std::ostringstream out;
  rewrite_mesh(out, mesh, mesh.points, {});
  expect_near(read(out.str()), mesh, 1e-4);
  const json changed = json_of(out.str());
  EXPECT_FALSE(changed.contains("skins") || changed["nodes"][0].contains("skin"));
  EXPECT_FALSE(changed["meshes"][0]["primitives"][0]["attributes"].contains("JOINTS_0"));
  EXPECT_EQ(changed["nodes"][0]["scale"], model["nodes"][0]["scale"]);

  // Joints that mirror turn the faces over, which the pose must keep.
  json mirrored = model;
  mirrored["nodes"][1]["scale"] = {-1, 1, 1};
  const std::string mirrored_file = with_json(bytes, mirrored);
  const Mesh_file original = mesh;
  mesh = read(mirrored_file);
  EXPECT_NE(mesh.faces, original.faces);
  mesh.source = std::make_shared<const Source_file>(Source_file{Format::GLB, mirrored_file});
  std::ostringstream turned_over;
  rewrite_mesh(turned_over, mesh, mesh.points, {});
  expect_near(read(turned_over.str()), mesh, 1e-4);

  const auto refusal = [&](const std::string& path, const json& value) {
    json wrong = model;
    wrong[json::json_pointer(path)] = value;
    return with_json(bytes, wrong);
  };
  EXPECT_THROW_WITH(read(refusal("/skins/0/joints", {1})), std::invalid_argument,
                    "vertex 0 of a primitive is moved by joint 1 of its skin, which has 1");
  EXPECT_THROW_WITH(read(refusal("/skins/0/joints", {1, 9})), std::invalid_argument,
                    "skin 0 names node 9, but there are 3");
  EXPECT_THROW_WITH(read(refusal("/skins/0/joints", {1, 2, 0})), std::invalid_argument,
                    "skin 0 has 3 joints, but 2 inverse bind matrices");
  EXPECT_THROW_WITH(read(refusal("/skins/0/inverseBindMatrices", 0)), std::invalid_argument,
                    "does not have 16 components");
  EXPECT_THROW_WITH(read(refusal("/nodes/2/children", {1})), std::invalid_argument,
                    "the nodes form a cycle");
  json few = model;
  few["accessors"][few["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"].get<int>()]["count"]
    = n - 1;
  EXPECT_THROW_WITH(read(with_json(bytes, few)), std::invalid_argument, "another number of JOINTS_0");
}

// A scene whose buffers and images are in files beside it becomes one file with the same content.
TEST(Gltf, buffers_and_images_beside_the_file)
{
  const Mesh_file mesh = ball();
  const std::string bytes = written(mesh);
  json model = json_of(bytes);
  const std::size_t chunk = 20 + number_at(bytes, 12) + 8;
  const auto uri_of = [](const std::string& name, const std::string& content) {
    return std::filesystem::path(written_file(name, content)).filename().string();
  };
  // The same buffer twice; indices are in the second one.
  const std::size_t size = bytes.size() - chunk;
  model["buffers"] = {{{"byteLength", size}, {"uri", uri_of("a.bin", bytes.substr(chunk))}},
                      {{"byteLength", size}, {"uri", uri_of("b.bin", bytes.substr(chunk))}}};
  const int indices = model["meshes"][0]["primitives"][0]["indices"];
  model["bufferViews"][model["accessors"][indices]["bufferView"].get<int>()]["buffer"] = 1;
  const std::string picture = "\x89PNG, but not really";
  std::string uri = uri_of("c d.PNG", picture);
  uri.replace(uri.find(' '), 1, "%20");
  model["images"] = {{{"uri", uri}, {"name", "c"}},
                     {{"uri", "missing.jpg"}},
                     {{"uri", uri_of("e.png", "RIFF")}}}; // no picture at all
  const Mesh_file read_one
    = read_mesh_file(written_file("scene.gltf", model.dump()), Source::KEPT);
  expect_near(read_one, mesh, 1e-6);
  ASSERT_TRUE(is_rewritable(read_one, Format::GLB));
  std::ostringstream out;
  rewrite_mesh(out, read_one, mesh.points, {});
  expect_near(read(out.str()), mesh, 1e-6);
  const json changed = json_of(out.str());
  EXPECT_EQ(changed["buffers"].size(), 1u);
  EXPECT_EQ(changed["images"][1], model["images"][1]); // as they were
  EXPECT_EQ(changed["images"][2], model["images"][2]);
  EXPECT_EQ(losses(read_one, Format::GLB).back(), "images that are not beside it");
  const json& image = changed["images"][0];
  EXPECT_EQ(image["mimeType"], "image/png");
  EXPECT_EQ(image["name"], "c");
  const json& view = changed["bufferViews"][image["bufferView"].get<int>()];
  EXPECT_EQ(out.str().substr(28 + number_at(out.str(), 12) + view["byteOffset"].get<std::size_t>(),
                             view["byteLength"]),
            picture);

  json wrong = model;
  wrong["images"][0]["uri"] = 7;
  EXPECT_THROW_WITH(read_mesh_file(written_file("wrong.gltf", wrong.dump()), Source::KEPT),
                    std::invalid_argument, "this is not valid glTF");
  json complete = changed;
  complete["images"] = {changed["images"][0]};
  EXPECT_EQ(self_contained_glb(with_json(out.str(), complete), ""), std::nullopt);
}

// Only what the default scene shows, otherwise the first one, is part of the surface.
TEST(Gltf, scenes)
{
  const Mesh_file mesh = ball();
  const std::size_t n = mesh.points.size();
  const auto number_of_vertices = [&](const json& scenes, const int scene) {
    const std::string bytes = written(mesh);
    json model = json_of(bytes);
    model["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"mesh", 0}}, {{"mesh", 0}}};
    model.erase("scene");
    model.erase("scenes");
    if(!scenes.is_null())
      model["scenes"] = scenes;
    if(scene >= 0)
      model["scene"] = scene;
    return read(with_json(bytes, model)).points.size();
  };
  const json scenes = {{{"nodes", {0, 1}}}, {{"nodes", {3}}}, {{"name", "empty"}}};
  EXPECT_EQ(number_of_vertices(scenes, 1), n);
  EXPECT_EQ(number_of_vertices(scenes, 0), 2 * n);
  EXPECT_EQ(number_of_vertices(scenes, -1), 2 * n);
  EXPECT_EQ(number_of_vertices({}, -1), 3 * n);
  EXPECT_THROW_WITH(number_of_vertices(scenes, 2), std::invalid_argument,
                    "the scene shows no mesh");
  EXPECT_THROW_WITH(number_of_vertices(scenes, 3), std::invalid_argument,
                    "scene 3 is shown, but there are 3");
}

// Meshes, and primitives of a mesh, are one surface: those that share vertices remain connected, and a mesh that several
// nodes show is there several times. A node that mirrors turns the faces over, so that they remain outward.
TEST(Gltf, several_meshes_and_primitives)
{
  const Mesh_file mesh = ball();
  const std::string bytes = written(mesh);
  const std::size_t n = mesh.points.size();
  json model = json_of(bytes);
  const json primitive = model["meshes"][0]["primitives"][0];
  model["meshes"][0]["primitives"].push_back(primitive);
  const Mesh_file twice = read(with_json(bytes, model));
  EXPECT_EQ(twice.points.size(), n);
  EXPECT_EQ(twice.faces.size(), 2 * mesh.faces.size());
  EXPECT_EQ(twice.faces[twice.faces.size() - 1], mesh.faces[mesh.faces.size() - 1]);

  model = json_of(bytes);
  model["meshes"].push_back(model["meshes"][0]);
  model["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}, {"scale", {1, 1, -1}}}, {{"mesh", 0}}};
  model["scenes"][0]["nodes"] = {0, 1, 2};
  const Mesh_file merged = read(with_json(bytes, model));
  ASSERT_EQ(merged.points.size(), 3 * n);
  ASSERT_EQ(merged.faces.size(), 3 * mesh.faces.size());
  for(std::size_t v = 0; v < n; ++v)
  {
    EXPECT_EQ(merged.points[v], merged.points[v + 2 * n]);
    EXPECT_EQ(merged.points[v + n][2], -merged.points[v][2]);
  }
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Face_list::Face face = merged.faces[f], mirrored = merged.faces[f + mesh.faces.size()];
    EXPECT_EQ(std::vector<std::size_t>(mirrored.begin(), mirrored.end()),
              (std::vector<std::size_t>{face[0] + n, face[2] + n, face[1] + n}));
  }
}

// Materials that are opaque have no opacity, whatever their numbers are; defaults are not told as lost.
TEST(Gltf, opacity_of_opaque_materials)
{
  const Mesh_file plain = ball();
  std::string bytes = written(plain);
  json model = json_of(bytes);
  json& primitive = model["meshes"][0]["primitives"][0];
  primitive["attributes"]["COLOR_0"]
    = add_accessor(bytes, model, "VEC4", 5126, std::vector<float>(4 * plain.points.size(), .5f),
                   plain.points.size());
  primitive["material"] = 0;
  for(const bool is_opaque : {true, false})
  {
    model["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, .25}}}}}};
    if(!is_opaque)
      model["materials"][0]["alphaMode"] = "BLEND";
    const Mesh_file mesh
      = read_shown_mesh_file(written_file("opacity.glb", with_json(bytes, model)));
    EXPECT_EQ(mesh.appearance.materials.at(0).color[3], is_opaque ? 1 : .25);
    EXPECT_EQ(mesh.appearance.vertex_opacities.empty(), is_opaque);
    const auto lost = losses(mesh, Format::OBJ, false);
    EXPECT_EQ(std::count(lost.begin(), lost.end(), OTHER_PROPERTIES), 0);
  }
}

// Sides, cutoff, wrapping and filters of materials, their other images, and the opacity of colors, are those of the file,
// wherever a surface with its appearance is written.
TEST(Gltf, materials_of_scenes)
{
  const Mesh_file plain = ball();
  const std::size_t n = plain.points.size();
  std::string bytes = written(plain);
  json model = json_of(bytes);
  json& attributes = model["meshes"][0]["primitives"][0]["attributes"];
  attributes["TEXCOORD_0"] = add_accessor(bytes, model, "VEC2", 5126, std::vector<float>(2 * n, .5f), n);
  std::vector<std::uint8_t> colors(4 * n, 255);
  colors[3] = 51;
  attributes["COLOR_0"] = add_accessor(bytes, model, "VEC4", 5121, colors, n);
  model["accessors"].back()["normalized"] = true;
  add_accessor(bytes, model, "SCALAR", 5121, std::vector<std::uint8_t>{0x89, 'P', 'N', 'G'}, 4);
  const std::size_t view = model["bufferViews"].size() - 1;
  model["accessors"].erase(model["accessors"].size() - 1);
  model["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  model["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}, {{"wrapS", 7}, {"minFilter", 8}}};
  model["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}}, {{"source", 0}, {"sampler", 1}}};
  const auto material = [](const int texture) {
    return json{{"alphaMode", "MASK"}, {"alphaCutoff", .25}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}};
  };
  model["materials"] = {material(0), material(1), material(2)};
  model["materials"][1]["doubleSided"] = true;
  model["materials"][1]["alphaMode"] = "BLEND";
  const json others = {{"name", "tin"},
                       {"emissiveFactor", {.5, .25, 1}},
                       {"normalTexture", {{"index", 1}, {"scale", .5}}},
                       {"occlusionTexture", {{"index", 0}, {"strength", .25}}},
                       {"emissiveTexture", {{"index", 1}}}};
  model["materials"][0].update(others);
  model["materials"][0]["pbrMetallicRoughness"].update(
    {{"metallicFactor", .75}, {"roughnessFactor", .125}, {"metallicRoughnessTexture", {{"index", 0}}}});
  model["materials"][2].update({{"normalTexture", {{"index", 0}, {"texCoord", 1}}},
                                {"extensions", {{"KHR_materials_unlit", json::object()}}}});
  const json primitive = model["meshes"][0]["primitives"][0];
  for(int p = 0; p < 3; ++p)
  {
    model["meshes"][0]["primitives"][p] = primitive;
    model["meshes"][0]["primitives"][p]["material"] = p;
  }
  const Mesh_file mesh = read_shown_mesh_file(written_file("materials.glb", with_json(bytes, model)));
  EXPECT_EQ(mesh.appearance.vertex_opacities.at(0), 51);
  const std::string own_coordinates = "the image of normals, which has texture coordinates of its own",
                    extension = "the extension 'KHR_materials_unlit' of materials";
  EXPECT_EQ(losses(mesh, Format::GLB, false), (std::vector<std::string>{extension, own_coordinates}));
  EXPECT_EQ(losses(mesh, Format::OBJ, false),
            (std::vector<std::string>{"the opacity of colors", OTHER_MAPS, OTHER_PROPERTIES,
                                      extension, own_coordinates}));
  for(const bool is_scene : {false, true})
  {
    Shown_surface scene = scene_of(mesh);
    scene.vertex_colors.assign(n, Color{1, 2, 3});
    const std::string file = is_scene ? written(scene) : written(mesh);
    const json shown = json_of(file);
    const std::size_t first = is_scene ? 1 : 0; // that of the results comes first
    const json& materials = shown["materials"];
    ASSERT_EQ(materials.size(), first + 3);
    EXPECT_EQ(materials[first].value("doubleSided", false), false);
    EXPECT_EQ(materials[first]["alphaCutoff"], .25);
    EXPECT_EQ(materials[first + 1]["doubleSided"], true);
    EXPECT_FALSE(materials[first + 1].contains("alphaCutoff"));
    const auto sampler = [&](const std::size_t m) {
      const json& texture = shown["textures"][materials[first + m]["pbrMetallicRoughness"]["baseColorTexture"]["index"].get<std::size_t>()];
      EXPECT_EQ(texture["source"], 0);
      return texture.contains("sampler") ? shown["samplers"][texture["sampler"].get<std::size_t>()] : json();
    };
    for(const auto& [key, value] : others.items())
    {
      json found = materials[first][key];
      if(found.is_object())
      {
        EXPECT_EQ(shown["textures"][found["index"].get<std::size_t>()].contains("sampler"), value["index"] == 0) << key;
        found["index"] = value["index"];
      }
      EXPECT_EQ(found, value) << key;
    }
    const json& base = materials[first]["pbrMetallicRoughness"];
    EXPECT_EQ(base["metallicFactor"], .75);
    EXPECT_EQ(base["roughnessFactor"], .125);
    EXPECT_EQ(base["metallicRoughnessTexture"], base["baseColorTexture"]);
    EXPECT_FALSE(materials[first + 2].contains("normalTexture"));
    EXPECT_EQ(sampler(0), model["samplers"][0]);
    EXPECT_EQ(sampler(1), json());
    EXPECT_EQ(sampler(2), json()); // numbers that glTF does not have
    EXPECT_EQ(shown["images"].size(), 1u);
    const auto written_colors = numbers<std::uint16_t>(file, is_scene ? "COLOR_1" : "COLOR_0");
    EXPECT_EQ(written_colors[3], 13107);
    EXPECT_EQ(written_colors[7], 65535);
  }
}

// What no other format has is named; what this program writes itself is not.
TEST(Gltf, what_other_formats_lack)
{
  using Names = std::vector<std::string>;
  std::string bytes = written(ball());
  EXPECT_EQ(losses(read_shown_mesh_file(written_file("plain.glb", bytes)), Format::OFF),
            Names{"materials"});
  json model = json_of(bytes);
  json& primitive = model["meshes"][0]["primitives"][0];
  json& attributes = primitive["attributes"];
  attributes.erase("NORMAL");
  attributes["_HEAT"] = attributes["COLOR_1"] = attributes["TEXCOORD_0"] = attributes["TEXCOORD_1"]
    = attributes["POSITION"];
  model["asset"]["copyright"] = "someone";
  model["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  model["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_unlit", "KHR_texture_transform"};
  model["nodes"].push_back({{"name", "parent"}, {"camera", 0}, {"children", {0}}});
  model["nodes"][0]["extras"] = {{"note", "by hand"}};
  model["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
  const Mesh_file mesh = read_shown_mesh_file(written_file("all.glb", with_json(bytes, model)));
  const auto lost = losses(mesh, Format::OFF);
  EXPECT_EQ(
    std::set<std::string>(lost.begin(), lost.end()),
    (std::set<std::string>{"materials", "texture coordinates", "other sets of texture coordinates",
                           "the attribute COLOR_1", "the attribute _HEAT", "cameras", "nodes",
                           "other scenes", "names of nodes and meshes", "the copyright", "extras",
                           "the extension KHR_lights_punctual"}));
  EXPECT_EQ(losses(mesh, Format::GLB), Names());
}

// With a vertex twice in the strip, and without indices; the pose has triangles.
TEST(Gltf, strips_and_fans)
{
  const Mesh_file mesh = mesh_of(Canonical_pose_test::boundary(
    {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{{0, 1, 2, 3}}}}));
  using Faces = std::vector<std::vector<std::size_t>>;
  const auto faces = [](const Mesh_file& read) {
    Faces result;
    for(const Face_list::Face face : read.faces)
      result.emplace_back(face.begin(), face.end());
    return result;
  };
  const auto with = [&](const int mode, const std::vector<std::uint16_t>& indices) {
    std::string bytes = written(mesh);
    json model = json_of(bytes);
    json& primitive = model["meshes"][0]["primitives"][0];
    primitive["mode"] = mode;
    primitive.erase("indices");
    if(!indices.empty())
      primitive["indices"] = add_accessor(bytes, model, "SCALAR", 5123, indices, indices.size());
    return with_json(bytes, model);
  };
  const Faces strip = {{0, 1, 2}, {2, 1, 3}}, fan = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(faces(read(with(5, {}))), strip);
  EXPECT_EQ(faces(read(with(6, {}))), fan);
  EXPECT_EQ(faces(read(with(5, {0, 1, 2, 2, 3, 0}))), (Faces{{0, 1, 2}, {3, 2, 0}}));
  EXPECT_TRUE(read(with(5, {0, 1})).faces.empty());
  EXPECT_THROW_WITH(read(with(6, {0, 1, 2, 4})), std::invalid_argument, "face 1 names vertex 4");
  const Mesh_file shown = read_shown_mesh_file(written_file("fan.glb", with(6, {})));
  EXPECT_FALSE(is_rewritable(shown, Format::GLB));
  EXPECT_EQ(shown.appearance.normals.size(), 6u);
  EXPECT_EQ(faces(read(written(shown))), fan);
}

// Indices that no vertex of the primitive has are refused, but for the list of all defects, where they are not vertices of
// other primitives.
TEST(Gltf, wrong_indices)
{
  const Mesh_file mesh = ball();
  std::string bytes = written(mesh);
  json model = json_of(bytes);
  const std::size_t n = mesh.points.size();
  model["accessors"].push_back(model["accessors"][0]);
  model["accessors"].back()["count"] = n - 1;
  json primitive = model["meshes"][0]["primitives"][0];
  primitive["attributes"] = {{"POSITION", model["accessors"].size() - 1}};
  model["meshes"][0]["primitives"].push_back(primitive);
  model["meshes"][0]["primitives"].push_back(model["meshes"][0]["primitives"][0]);
  std::size_t count = 0, first = mesh.faces.size();
  for(std::size_t f = mesh.faces.size(); f-- > 0;)
    for(const std::size_t v : mesh.faces[f])
      if(v == n - 1)
      {
        ++count;
        first = f;
      }
  const std::string path = written_file("wrong.glb", with_json(bytes, model));
  const auto diagnosis = diagnosis_of(read_mesh_file(path, Source::UNCHECKED));
  ASSERT_EQ(diagnosis.defects.size(), 1u);
  EXPECT_EQ(diagnosis.defects[0].kind, "wrong_indices");
  EXPECT_EQ(diagnosis.defects[0].count, count);
  EXPECT_EQ(diagnosis.defects[0].examples[0][0], mesh.faces.size() + first);
  EXPECT_THROW_WITH(read_mesh_file(path), std::invalid_argument,
                    "face " + std::to_string(mesh.faces.size() + first) + " names vertex " + std::to_string(n - 1)
                      + ", but there are " + std::to_string(n - 1));
}

// A pose of a file is the same scene with other positions: nodes, materials, and all that is not named here stay.
TEST(Gltf, rewritten)
{
  const std::string bytes = written(ball());
  json model = json_of(bytes);
  const double half = std::sqrt(.5);
  model["nodes"]
    = {{{"children", {1}}, {"translation", {1, 2, 3}}, {"name", "above"}},
       {{"mesh", 0}, {"rotation", {0, half, 0, half}}, {"scale", {2, 1, -1}}, {"extras", {{"a", 1}}}}};
  model["materials"] = {{{"name", "red"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}}};
  model["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string file = with_json(bytes, model);
  model = json_of(file);
  Mesh_file mesh = read(file), turned = mesh;
  mesh.source = std::make_shared<const Source_file>(Source_file{Format::GLB, file});
  for(std::array<double, 3>& p : turned.points)
    p = {p[0], -p[2], p[1]}; // by a quarter around the x axis
  ASSERT_TRUE(is_rewritable(mesh, Format::GLB));
  std::ostringstream out;
  rewrite_mesh(out, mesh, turned.points, {});
  expect_near(read(out.str()), turned, 1e-5);
  EXPECT_EQ(number_at(out.str(), 8), out.str().size());

  json changed = json_of(out.str());
  for(json* const scene : {&model, &changed})
    for(json& accessor : (*scene)["accessors"])
    {
      accessor.erase("min");
      accessor.erase("max");
    }
  EXPECT_EQ(changed, model);
  EXPECT_EQ(attributes_of_file(mesh),
            (std::vector<std::string>{"normals", "materials", "nodes", "names of nodes and meshes",
                                      "extras"}));
  // In the scene, normals of the rest pose are those of an ellipsoid; they turn as the positions do.
  const std::vector<float> before = numbers<float>(file, "NORMAL"),
                           after = numbers<float>(out.str(), "NORMAL");
  const auto in_scene = [&](const std::vector<float>& normals, const std::size_t v) {
    // inverse transpose of the scale, then a quarter around the y axis
    const Eigen::Vector3d n(normals[3 * v] / 2, normals[3 * v + 1], -normals[3 * v + 2]);
    return Eigen::Vector3d(n[2], n[1], -n[0]).normalized().eval();
  };
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const Eigen::Vector3d n = in_scene(before, v);
    EXPECT_LT((in_scene(after, v) - Eigen::Vector3d(n[0], -n[2], n[1])).norm(), 1e-5) << v;
  }

  // A mesh that is shown twice has two poses.
  model = json_of(file);
  model["nodes"].push_back({{"mesh", 0}});
  model["scenes"][0]["nodes"].push_back(2);
  mesh = read(with_json(file, model));
  mesh.source
    = std::make_shared<const Source_file>(Source_file{Format::GLB, with_json(file, model)});
  turned = mesh;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    turned.points[v][2] += v < mesh.points.size() / 2 ? 1 : -2;
  ASSERT_TRUE(is_rewritable(mesh, Format::GLB));
  std::ostringstream twice;
  rewrite_mesh(twice, mesh, turned.points, {});
  expect_near(read(twice.str()), turned, 1e-5);
  changed = json_of(twice.str());
  EXPECT_EQ(changed["meshes"].size(), 2u);
  EXPECT_EQ(changed["meshes"][1]["primitives"][0]["material"], 0);

  // So have two accessors with the same bytes.
  model["accessors"].push_back(model["accessors"][0]);
  model["meshes"].push_back(model["meshes"][0]);
  model["meshes"][1]["primitives"][0]["attributes"]["POSITION"] = model["accessors"].size() - 1;
  model["nodes"][2]["mesh"] = 1;
  mesh.source
    = std::make_shared<const Source_file>(Source_file{Format::GLB, with_json(file, model)});
  std::ostringstream aliased;
  rewrite_mesh(aliased, mesh, turned.points, {});
  expect_near(read(aliased.str()), turned, 1e-5);
}

} // namespace test_gltf
