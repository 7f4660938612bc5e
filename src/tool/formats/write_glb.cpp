// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gltf_builder.h"
#include "Gltf_frame.h"
#include "Gltf_materials.h"
#include "Shown_surface.h"
#include "Split_surface.h"

#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using CGAL::Canonical_pose_3::Point_matrix;
template <class Number>
using Rows = Gltf_builder::Rows<Number>;
using Use = Gltf_builder::Use;

// Colors of glTF are linear.
double linear(const unsigned char of_srgb)
{
  const double x = of_srgb / 255.;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

Point_matrix matrix_of(const Mesh_file& mesh)
{
  Point_matrix points(static_cast<Eigen::Index>(mesh.points.size()), 3);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      points(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = mesh.points[v][k];
  return points;
}

class Glb_writer
{
public:
  explicit Glb_writer(const Shown_surface& surface)
    : m_surface(surface), m_points(matrix_of(surface.mesh)), m_split(m_points, surface),
      m_is_quantized(!surface.other_shapes.empty() && m_split.copies.size() > LARGEST_UNQUANTIZED)
  {}

  void run(std::ostream& out)
  {
    if(m_split.triangles.empty())
      throw std::invalid_argument("glTF holds surfaces with at least one face");
    if(m_split.copies.size() > LARGEST_VERTEX_OF_ATTRIBUTES && !m_surface.origins.empty())
      throw std::invalid_argument("there are more vertices than the attribute _VERTEX can count");
    m_frame = frame_of(m_points, m_surface.other_shapes, m_is_quantized);
    add_vertices();
    add_triangles();
    add_node();
    if(!m_surface.other_shapes.empty())
      add_animation();
    tinygltf::Model& model = m_builder.model();
    model.asset.generator = "canonical-pose";
    if(m_is_quantized)
    {
      model.extensionsRequired = {"KHR_mesh_quantization"};
      model.extensionsUsed.push_back("KHR_mesh_quantization");
    }
    if(!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, false, true))
      throw std::runtime_error("the model could not be turned into glTF");
  }

private:
  static constexpr std::size_t LARGEST_UNQUANTIZED = 250000;
  static constexpr std::size_t LARGEST_VERTEX_OF_ATTRIBUTES = 16777216; // of float

  // A row per copy of a vertex.
  template <class Number, class Function>
  Rows<Number> rows(const int columns, const Function& value) const
  {
    Rows<Number> result(static_cast<Eigen::Index>(m_split.copies.size()), columns);
    for(Eigen::Index i = 0; i < result.rows(); ++i)
    {
      const Vertex_copy& copy = m_split.copies[static_cast<std::size_t>(i)];
      for(int k = 0; k < columns; ++k)
        result(i, k) = value(copy, k);
    }
    return result;
  }

  void add_vertices()
  {
    m_primitive.attributes["POSITION"] = m_builder.append(
      rows<float>(3, [&](const Vertex_copy& c, const int k) { return position(c.vertex, k); }),
      Use::VERTICES, true);
    for(const Other_shape& shape : m_surface.other_shapes)
      add_shape(shape);
    if(!m_is_quantized)
      add_normals();
    add_values();
    add_colors();
    if(m_surface.skeleton)
      add_weights();
    if(!m_surface.mesh.appearance.texture_coordinates.empty())
      m_primitive.attributes["TEXCOORD_0"]
        = m_builder.append(rows<float>(2,
                                       [](const Vertex_copy& c, const int k) {
                                         return c.texture_coordinates[static_cast<std::size_t>(k)];
                                       }),
                           Use::VERTICES);
  }

  // Some viewers read positions in single precision only, whatever they read of differences.
  float position(const std::size_t vertex, const int k) const
  {
    return to_float(m_frame.stored(m_points, vertex, k));
  }

  void add_shape(const Other_shape& shape)
  {
    const auto difference = [&](const Vertex_copy& c, const int k) {
      return m_frame.stored(shape.points, c.vertex, k) - static_cast<double>(position(c.vertex, k));
    };
    std::map<std::string, int> target;
    target["POSITION"]
      = m_is_quantized
          ? m_builder.append(rows<std::int16_t>(3,
                                                [&](const Vertex_copy& c, const int k) {
                                                  return static_cast<std::int16_t>(
                                                    std::lround(difference(c, k)));
                                                }),
                             Use::VERTICES, true)
          : m_builder.append(
            rows<float>(
              3, [&](const Vertex_copy& c, const int k) { return to_float(difference(c, k)); }),
            Use::VERTICES, true);
    m_primitive.targets.push_back(std::move(target));
  }

  Rows<float> normals(const Point_matrix& points) const
  {
    const Point_matrix of_vertices = CGAL::Canonical_pose_3::vertex_normals(points, m_split.faces);
    return rows<float>(3, [&](const Vertex_copy& c, const int k) {
      if(c.normal != std::array<float, 3>())
        return c.normal[static_cast<std::size_t>(k)];
      const auto normal = of_vertices.row(static_cast<Eigen::Index>(c.vertex));
      return normal.isZero() ? (k == 2 ? 1.f : 0.f) : static_cast<float>(normal[k]);
    });
  }

  // Quantized differences of normals would not reach the opposite direction; without normals,
  // viewers shade flat, which is right for all shapes.
  void add_normals()
  {
    const Rows<float> at_rest = normals(m_points);
    m_primitive.attributes["NORMAL"] = m_builder.append(at_rest, Use::VERTICES);
    for(std::size_t i = 0; i < m_surface.other_shapes.size(); ++i)
      m_primitive.targets[i]["NORMAL"] = m_builder.append(
        Rows<float>(normals(m_surface.other_shapes[i].points) - at_rest), Use::VERTICES);
  }

  static std::string attribute(std::string name)
  {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](const unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return "_" + name;
  }

  void add_values()
  {
    for(const Vertex_values& values : m_surface.values)
      m_primitive.attributes[attribute(values.name)] = m_builder.append(
        rows<float>(1,
                    [&](const Vertex_copy& c, int) {
                      return to_float(values.values[static_cast<Eigen::Index>(c.vertex)]);
                    }),
        Use::VERTICES);
    if(!m_surface.part_of_face.empty())
      m_primitive.attributes["_LABEL"] = m_builder.append(
        rows<float>(1, [](const Vertex_copy& c, int) { return static_cast<float>(c.part); }),
        Use::VERTICES);
    if(!m_surface.origins.empty())
      m_primitive.attributes["_VERTEX"] = m_builder.append(
        rows<float>(1, [&](const Vertex_copy& c,
                           int) { return static_cast<float>(m_surface.origins[c.vertex]); }),
        Use::VERTICES);
  }

  // The joints that a vertex follows, and how much: multiples of a power of two, whose sum is 1 without rounding.
  void add_weights()
  {
    using Weights = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    constexpr Eigen::Index most = 4;
    constexpr double steps = 1 << std::numeric_limits<float>::digits;
    Rows<std::uint16_t> joints
      = Rows<std::uint16_t>::Zero(static_cast<Eigen::Index>(m_split.copies.size()), most);
    Rows<float> weights = Rows<float>::Zero(joints.rows(), most);
    for(Eigen::Index i = 0; i < joints.rows(); ++i)
    {
      const std::size_t vertex = m_split.copies[static_cast<std::size_t>(i)].vertex;
      Eigen::Index k = 0;
      for(Weights::InnerIterator entry(m_surface.skeleton->weights,
                                       static_cast<Eigen::Index>(m_surface.origins[vertex]));
          entry && k < most; ++entry)
        if(const double weight = std::round(steps * entry.value()) / steps; weight > 0)
        {
          joints(i, k) = static_cast<std::uint16_t>(entry.col());
          weights(i, k++) = static_cast<float>(weight);
        }
      Eigen::Index largest;
      weights.row(i).maxCoeff(&largest); // the first joint, if it belongs to no limb
      weights(i, largest) += static_cast<float>(1 - weights.row(i).cast<double>().sum());
    }
    m_primitive.attributes["JOINTS_0"] = m_builder.append(joints, Use::JOINTS);
    m_primitive.attributes["WEIGHTS_0"] = m_builder.append(weights, Use::VERTICES);
  }

  bool has_colors_of_results() const
  {
    return !m_surface.part_of_face.empty() || !m_surface.vertex_colors.empty();
  }

  // Those of the results, if any, come first.
  void add_colors()
  {
    const std::vector<Color>& own = m_surface.mesh.appearance.vertex_colors;
    const std::vector<unsigned char>& opacities = m_surface.mesh.appearance.vertex_opacities;
    const auto opaque = [](const Vertex_copy&) { return 1.; };
    const auto add = [&](const std::string& name, const auto& color, const auto& opacity) {
      constexpr double most = (std::numeric_limits<std::uint16_t>::max)();
      m_primitive.attributes[name] = m_builder.append(
        rows<std::uint16_t>(4,
                            [&](const Vertex_copy& c, const int k) {
                              const double share
                                = k == 3 ? opacity(c)
                                         : linear(color(c)[static_cast<std::size_t>(k)]);
                              return static_cast<std::uint16_t>(std::lround(most * share));
                            }),
        Use::VERTICES);
    };
    if(!m_surface.part_of_face.empty())
      add(
        "COLOR_0",
        [](const Vertex_copy& c) {
          return c.part < 0 ? Color{128, 128, 128}
                            : color_of_part(static_cast<std::size_t>(c.part));
        },
        opaque);
    else if(!m_surface.vertex_colors.empty())
      add(
        "COLOR_0", [&](const Vertex_copy& c) { return m_surface.vertex_colors[c.vertex]; }, opaque);
    if(!own.empty())
      add(
        has_colors_of_results() ? "COLOR_1" : "COLOR_0",
        [&](const Vertex_copy& c) { return own[c.vertex]; },
        [&](const Vertex_copy& c) { return opacities.empty() ? 1 : opacities[c.vertex] / 255.; });
  }

  template <class Number>
  int append_indices(const std::vector<std::size_t>& triangles)
  {
    Rows<Number> indices(static_cast<Eigen::Index>(3 * triangles.size()), 1);
    Eigen::Index i = 0;
    for(const std::size_t t : triangles)
      for(const std::size_t v : m_split.triangles[t])
        indices(i++) = static_cast<Number>(v);
    return m_builder.append(indices, Use::INDICES);
  }

  int add_material(const Material& material)
  {
    return m_materials.add(material, m_primitive.attributes.count("TEXCOORD_0") > 0);
  }

  // A primitive for each material. If colors show results, materials are those of a variant.
  void add_triangles()
  {
    const Appearance& appearance = m_surface.mesh.appearance;
    std::map<std::size_t, std::vector<std::size_t>> triangles;
    for(std::size_t t = 0; t < m_split.triangles.size(); ++t)
      triangles[appearance.has_materials()
                  ? appearance.material_of_face[m_split.polygon_of_triangle[t]]
                  : 0]
        .push_back(t);
    m_primitive.mode = TINYGLTF_MODE_TRIANGLES;
    const bool has_variant = appearance.has_materials() && has_colors_of_results();
    const auto is_opaque = [&](const std::size_t t) {
      return std::all_of(
        m_split.faces[t].begin(), m_split.faces[t].end(),
        [&](const std::size_t v) { return appearance.vertex_opacities[v] == 255; });
    };
    // Of triangles with this material; otherwise, opacities would not be seen.
    const auto with_opacities
      = [&](Material material, const std::vector<std::size_t>& of_material) {
          if(material.alpha_mode == "OPAQUE" && !has_colors_of_results()
             && !appearance.vertex_opacities.empty()
             && !std::all_of(of_material.begin(), of_material.end(), is_opaque))
            material.alpha_mode = "BLEND";
          return material;
        };
    Material without;
    if(!appearance.has_materials() && !triangles.empty())
      without = with_opacities(without, triangles.begin()->second);
    const int plain = has_variant || !appearance.has_materials() ? add_material(without) : -1;
    const bool is_small = m_split.copies.size() <= std::numeric_limits<std::uint16_t>::max();
    for(const auto& [material, of_material] : triangles)
    {
      m_primitive.indices = is_small ? append_indices<std::uint16_t>(of_material)
                                     : append_indices<std::uint32_t>(of_material);
      m_primitive.material = plain;
      if(appearance.has_materials())
      {
        const int own = add_material(with_opacities(appearance.materials[material], of_material));
        if(has_variant)
          Gltf_materials::add_to_variant(m_primitive, own);
        else
          m_primitive.material = own;
      }
      m_primitives.push_back(m_primitive);
    }
    if(has_variant)
      m_materials.add_variant();
  }

  // Viewers look for the names of shapes in the extras of the mesh.
  tinygltf::Value extras() const
  {
    using tinygltf::Value;
    Value::Object extras;
    if(!m_surface.other_shapes.empty())
    {
      Value::Array names;
      for(const Other_shape& shape : m_surface.other_shapes)
        names.emplace_back(shape.name);
      extras["targetNames"] = Value(names);
    }
    if(m_surface.legend)
    {
      Value::Object legend;
      legend["attribute"] = Value(attribute(m_surface.legend->name));
      legend["minimum"] = Value(m_surface.legend->minimum);
      legend["maximum"] = Value(m_surface.legend->maximum);
      legend["map"] = Value(std::string("viridis"));
      extras["legend"] = Value(legend);
    }
    if(!m_surface.figures.empty())
    {
      Value::Object figures;
      for(const Figure& figure : m_surface.figures)
        figures[figure.name] = Value(figure.value);
      extras["figures"] = Value(figures);
    }
    if(!m_surface.stance.empty())
      extras["stance"] = Value(m_surface.stance);
    return Value(extras);
  }

  void add_node()
  {
    tinygltf::Mesh mesh;
    if(!m_surface.other_shapes.empty() || m_surface.legend || !m_surface.figures.empty())
      mesh.extras = extras();
    mesh.weights.assign(m_surface.other_shapes.size(), 0);
    mesh.primitives = m_primitives;
    m_builder.model().meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.mesh = 0;
    tinygltf::Scene scene;
    scene.nodes = {0};
    if(m_surface.skeleton)
    {
      node.skin = 0;
      scene.nodes.push_back(1);
    }
    else // it does not move a mesh with a skin
    {
      if(!m_frame.center.isZero(0))
        node.translation.assign(m_frame.center.data(), m_frame.center.data() + 3);
      if(m_frame.unit != 1)
        node.scale.assign(3, m_frame.unit);
    }
    m_builder.model().nodes.push_back(node);
    if(m_surface.skeleton)
      add_skin();
    m_builder.model().scenes.push_back(scene);
    m_builder.model().defaultScene = 0;
  }

  // The joints as nodes 1, 2, ...; matrices lead from the mesh to them. Numbers of single precision cancel each other.
  void add_skin()
  {
    const auto& joints = m_surface.skeleton->joints;
    const auto n = static_cast<Eigen::Index>(joints.size());
    Rows<float> positions(n, 3), matrices = Rows<float>::Zero(n, 16);
    tinygltf::Skin skin;
    for(Eigen::Index j = 0; j < n; ++j)
    {
      const auto& joint = joints[static_cast<std::size_t>(j)];
      const bool is_root = j == 0;
      tinygltf::Node node;
      node.name = joint.name;
      for(int k = 0; k < 3; ++k)
      {
        positions(j, k) = to_float(joint.position[k] - m_frame.center[k]);
        const double from
          = is_root ? -m_frame.center[k]
                    : static_cast<double>(positions(static_cast<Eigen::Index>(joint.parent), k));
        node.translation.push_back(static_cast<double>(positions(j, k)) - from);
        matrices(j, 5 * k) = to_float(m_frame.unit);
        matrices(j, 12 + k) = -positions(j, k);
      }
      matrices(j, 15) = 1;
      const int index = static_cast<int>(m_builder.model().nodes.size());
      skin.joints.push_back(index);
      if(!is_root)
        m_builder.model().nodes[joint.parent + 1].children.push_back(index);
      m_builder.model().nodes.push_back(node);
    }
    skin.skeleton = skin.joints.front();
    skin.inverseBindMatrices = m_builder.append(matrices, Use::ANIMATION);
    m_builder.model().skins.push_back(skin);
  }

  // To the last shape, a rest, and back.
  void add_animation()
  {
    const Eigen::Index shapes = static_cast<Eigen::Index>(m_surface.other_shapes.size());
    Rows<float> times(4, 1), weights = Rows<float>::Zero(4 * shapes, 1);
    times << 0, 2, 3, 5;
    weights(2 * shapes - 1) = weights(3 * shapes - 1) = 1;
    tinygltf::AnimationSampler sampler;
    sampler.input = m_builder.append(times, Use::ANIMATION, true);
    sampler.output = m_builder.append(weights, Use::ANIMATION);
    sampler.interpolation = "LINEAR";
    tinygltf::AnimationChannel channel;
    channel.sampler = 0;
    channel.target_node = 0;
    channel.target_path = "weights";
    tinygltf::Animation animation;
    animation.name = "input to " + m_surface.other_shapes.back().name + " and back";
    animation.samplers.push_back(sampler);
    animation.channels.push_back(channel);
    m_builder.model().animations.push_back(animation);
  }

  const Shown_surface& m_surface;
  const Point_matrix m_points;
  const Split_surface m_split;
  const bool m_is_quantized;
  Gltf_frame m_frame;
  Gltf_builder m_builder;
  Gltf_materials m_materials{m_builder};
  tinygltf::Primitive m_primitive; // what those of all materials have in common
  std::vector<tinygltf::Primitive> m_primitives;
};

} // namespace

void write_glb(std::ostream& out, const Shown_surface& surface) { Glb_writer(surface).run(out); }

} // namespace Canonical_pose_tool
