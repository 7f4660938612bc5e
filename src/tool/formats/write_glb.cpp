// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gltf_builder.h"
#include "Shown_surface.h"

#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/triangulate_polygons.h>

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
using Triangles = std::vector<std::array<std::size_t, 3>>;

// A vertex of the surface and its part; -1 if there are no parts, or if it belongs to no face.
using Copy = std::pair<std::size_t, long long>;

const double LARGEST_FLOAT = (std::numeric_limits<float>::max)();

float to_float(const double x)
{
  return static_cast<float>((std::min)((std::max)(x, -LARGEST_FLOAT), LARGEST_FLOAT));
}

// Colors of glTF are linear.
std::uint8_t linear(const unsigned char of_srgb)
{
  const double x = of_srgb / 255.;
  const double y = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  return static_cast<std::uint8_t>(std::lround(255 * y));
}

Point_matrix matrix_of(const Mesh_file& mesh)
{
  Point_matrix points(static_cast<Eigen::Index>(mesh.points.size()), 3);
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k)
      points(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = mesh.points[v][k];
  return points;
}

// The triangles of a surface; its vertices are split where parts meet, sorted by vertex. Each has
// at least one copy.
struct Split_surface
{
  Split_surface(const Point_matrix& points, const Shown_surface& surface)
  {
    CGAL::Canonical_pose_3::Triangulated_polygons polygons
      = CGAL::Canonical_pose_3::triangulate_polygons(points, surface.mesh.faces);
    faces = polygons.triangles;
    triangles = std::move(polygons.triangles);
    const std::size_t n = surface.mesh.points.size();
    if(surface.part_of_face.empty())
    {
      for(std::size_t v = 0; v < n; ++v)
        copies.emplace_back(v, -1);
      return;
    }
    const auto part = [&](const std::size_t t) {
      return static_cast<long long>(surface.part_of_face[polygons.polygon_of_triangle[t]]);
    };
    std::vector<bool> has_face(n, false);
    for(std::size_t t = 0; t < faces.size(); ++t)
      for(const std::size_t v : faces[t])
      {
        has_face[v] = true;
        copies.emplace_back(v, part(t));
      }
    for(std::size_t v = 0; v < n; ++v)
      if(!has_face[v])
        copies.emplace_back(v, -1);
    std::sort(copies.begin(), copies.end());
    copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
    for(std::size_t t = 0; t < faces.size(); ++t)
      for(std::size_t& v : triangles[t])
        v = static_cast<std::size_t>(
          std::lower_bound(copies.begin(), copies.end(), Copy(v, part(t))) - copies.begin());
  }

  std::vector<Copy> copies;
  Triangles triangles; // of copies
  Triangles faces;     // the same of vertices
};

// Where a file has its origin, and its unit of length.
struct Frame
{
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
  double unit = 1;
};

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
    choose_frame();
    add_vertices();
    add_triangles();
    add_node();
    if(!m_surface.other_shapes.empty())
      add_animation();
    tinygltf::Model& model = m_builder.model();
    model.asset.generator = "canonical-pose";
    if(m_is_quantized)
      model.extensionsUsed = model.extensionsRequired = {"KHR_mesh_quantization"};
    if(!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, false, true))
      throw std::runtime_error("the model could not be turned into glTF");
  }

private:
  static constexpr std::size_t LARGEST_UNQUANTIZED = 250000;
  static constexpr std::size_t LARGEST_VERTEX_OF_ATTRIBUTES = 16777216; // of float
  static constexpr double LARGEST_SHORT = 32767;

  // The origin is moved only if the surface is far from it, where single precision is coarse.
  void choose_frame()
  {
    const Eigen::RowVector3d low = m_points.colwise().minCoeff(),
                             high = m_points.colwise().maxCoeff();
    const Eigen::RowVector3d center = 0.5 * low + 0.5 * high;
    const double radius = (0.5 * high - 0.5 * low).maxCoeff();
    const double many_radii = 8;
    if(m_is_quantized || center.cwiseAbs().maxCoeff() > many_radii * radius)
      m_frame.center = center;
    const double largest = (m_points.rowwise() - m_frame.center).cwiseAbs().maxCoeff();
    const double least_radius
      = (std::numeric_limits<float>::min)() / std::numeric_limits<float>::epsilon();
    if(!(largest <= LARGEST_FLOAT) || (radius > 0 && radius < least_radius))
      throw std::invalid_argument(
        "the surface is too large or too small for glTF, which has single precision");
    if(!m_is_quantized)
      return;
    double farthest = 0;
    for(const Other_shape& shape : m_surface.other_shapes)
      farthest = (std::max)(farthest, (shape.points - m_points).cwiseAbs().maxCoeff());
    if(farthest > 0)
      m_frame.unit = farthest / LARGEST_SHORT;
  }

  // A row per copy of a vertex.
  template <class Number, class Function>
  Rows<Number> rows(const int columns, const Function& value) const
  {
    Rows<Number> result(static_cast<Eigen::Index>(m_split.copies.size()), columns);
    for(Eigen::Index i = 0; i < result.rows(); ++i)
    {
      const Copy& copy = m_split.copies[static_cast<std::size_t>(i)];
      for(int k = 0; k < columns; ++k)
        result(i, k) = value(copy, k);
    }
    return result;
  }

  // A coordinate in the unit of the file.
  double stored(const Point_matrix& points, const std::size_t vertex, const int k) const
  {
    return (points(static_cast<Eigen::Index>(vertex), k) - m_frame.center[k]) / m_frame.unit;
  }

  void add_vertices()
  {
    m_primitive.attributes["POSITION"] = m_builder.append(
      rows<float>(3, [&](const Copy& c, const int k) { return position(c.first, k); }),
      Use::VERTICES, true);
    for(const Other_shape& shape : m_surface.other_shapes)
      add_shape(shape);
    if(!m_is_quantized)
      add_normals();
    add_values();
    add_colors();
  }

  // Some viewers read positions in single precision only, whatever they read of differences.
  float position(const std::size_t vertex, const int k) const
  {
    return to_float(stored(m_points, vertex, k));
  }

  void add_shape(const Other_shape& shape)
  {
    const auto difference = [&](const Copy& c, const int k) {
      return stored(shape.points, c.first, k) - static_cast<double>(position(c.first, k));
    };
    std::map<std::string, int> target;
    target["POSITION"]
      = m_is_quantized
          ? m_builder.append(rows<std::int16_t>(3,
                                                [&](const Copy& c, const int k) {
                                                  return static_cast<std::int16_t>(
                                                    std::lround(difference(c, k)));
                                                }),
                             Use::VERTICES, true)
          : m_builder.append(
            rows<float>(3, [&](const Copy& c, const int k) { return to_float(difference(c, k)); }),
            Use::VERTICES, true);
    m_primitive.targets.push_back(std::move(target));
  }

  Rows<float> normals(const Point_matrix& points) const
  {
    const Point_matrix of_vertices = CGAL::Canonical_pose_3::vertex_normals(points, m_split.faces);
    return rows<float>(3, [&](const Copy& c, const int k) {
      const auto normal = of_vertices.row(static_cast<Eigen::Index>(c.first));
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
                    [&](const Copy& c, int) {
                      return to_float(values.values[static_cast<Eigen::Index>(c.first)]);
                    }),
        Use::VERTICES);
    if(!m_surface.part_of_face.empty())
      m_primitive.attributes["_LABEL"] = m_builder.append(
        rows<float>(1, [](const Copy& c, int) { return static_cast<float>(c.second); }),
        Use::VERTICES);
    if(!m_surface.origins.empty())
      m_primitive.attributes["_VERTEX"] = m_builder.append(
        rows<float>(
          1, [&](const Copy& c, int) { return static_cast<float>(m_surface.origins[c.first]); }),
        Use::VERTICES);
  }

  void add_colors()
  {
    const bool has_parts = !m_surface.part_of_face.empty();
    if(!has_parts && m_surface.vertex_colors.empty())
      return;
    m_primitive.attributes["COLOR_0"] = m_builder.append(
      rows<std::uint8_t>(4,
                         [&](const Copy& c, const int k) -> std::uint8_t {
                           if(k == 3)
                             return 255;
                           const Color color
                             = !has_parts     ? m_surface.vertex_colors[c.first]
                               : c.second < 0 ? Color{128, 128, 128}
                                              : color_of_part(static_cast<std::size_t>(c.second));
                           return linear(color[static_cast<std::size_t>(k)]);
                         }),
      Use::VERTICES);
  }

  template <class Number>
  int append_indices()
  {
    Rows<Number> indices(static_cast<Eigen::Index>(3 * m_split.triangles.size()), 1);
    Eigen::Index i = 0;
    for(const std::array<std::size_t, 3>& triangle : m_split.triangles)
      for(const std::size_t v : triangle)
        indices(i++) = static_cast<Number>(v);
    return m_builder.append(indices, Use::INDICES);
  }

  void add_triangles()
  {
    const bool is_small = m_split.copies.size() <= std::numeric_limits<std::uint16_t>::max();
    m_primitive.indices
      = is_small ? append_indices<std::uint16_t>() : append_indices<std::uint32_t>();
    m_primitive.mode = TINYGLTF_MODE_TRIANGLES;
    m_primitive.material = 0;
    tinygltf::Material material;
    material.doubleSided = true; // surfaces may be open
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.8;
    m_builder.model().materials.push_back(material);
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
    return Value(extras);
  }

  void add_node()
  {
    tinygltf::Mesh mesh;
    if(!m_surface.other_shapes.empty() || m_surface.legend || !m_surface.figures.empty())
      mesh.extras = extras();
    mesh.weights.assign(m_surface.other_shapes.size(), 0);
    mesh.primitives.push_back(m_primitive);
    m_builder.model().meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.mesh = 0;
    if(!m_frame.center.isZero(0))
      node.translation.assign(m_frame.center.data(), m_frame.center.data() + 3);
    if(m_frame.unit != 1)
      node.scale.assign(3, m_frame.unit);
    m_builder.model().nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes = {0};
    m_builder.model().scenes.push_back(scene);
    m_builder.model().defaultScene = 0;
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
  Frame m_frame;
  Gltf_builder m_builder;
  tinygltf::Primitive m_primitive;
};

} // namespace

void write_glb(std::ostream& out, const Shown_surface& surface) { Glb_writer(surface).run(out); }

} // namespace Canonical_pose_tool
