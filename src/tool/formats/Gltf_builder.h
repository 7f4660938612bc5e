// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_GLTF_BUILDER_H
#define CGAL_CANONICAL_POSE_3_TOOL_GLTF_BUILDER_H

#include "Appearance.h"

#include <Eigen/Core>

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace Canonical_pose_tool {

// A glTF model with one buffer, to which arrays of numbers are appended.
class Gltf_builder
{
public:
  template <class Number>
  using Rows = Eigen::Array<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  enum class Use { VERTICES, JOINTS, INDICES, ANIMATION, IMAGE };

  Gltf_builder() { m_model.buffers.emplace_back(); }

  tinygltf::Model& model() { return m_model; }

  // Appends an array, and returns the index of its accessor.
  template <class Number>
  int append(const Rows<Number>& rows, const Use use, const bool has_bounds = false)
  {
    tinygltf::Accessor accessor;
    accessor.bufferView = append_view(rows, use);
    accessor.componentType = component_type(Number());
    accessor.count = static_cast<std::size_t>(rows.rows());
    accessor.type = rows.cols() == 1   ? TINYGLTF_TYPE_SCALAR
                    : rows.cols() == 2 ? TINYGLTF_TYPE_VEC2
                    : rows.cols() == 3 ? TINYGLTF_TYPE_VEC3
                    : rows.cols() == 4 ? TINYGLTF_TYPE_VEC4
                                       : TINYGLTF_TYPE_MAT4;
    accessor.normalized = use == Use::VERTICES && std::is_unsigned_v<Number>; // colors
    if(has_bounds)
      for(Eigen::Index k = 0; k < rows.cols(); ++k)
      {
        accessor.minValues.push_back(static_cast<double>(rows.col(k).minCoeff()));
        accessor.maxValues.push_back(static_cast<double>(rows.col(k).maxCoeff()));
      }
    m_model.accessors.push_back(std::move(accessor));
    return static_cast<int>(m_model.accessors.size()) - 1;
  }

  // Appends the content of an image, and returns its index.
  int append_image(const std::string& content, const std::string& type)
  {
    Rows<std::uint8_t> bytes(static_cast<Eigen::Index>(content.size()), 1);
    std::copy(content.begin(), content.end(), bytes.data());
    tinygltf::Image image;
    image.bufferView = append_view(bytes, Use::IMAGE);
    image.mimeType = type;
    m_model.images.push_back(std::move(image));
    return static_cast<int>(m_model.images.size()) - 1;
  }

  // Appends a texture that shows an image, and returns its index.
  int append_texture(const int image, const Sampler& given)
  {
    tinygltf::Texture texture;
    texture.source = image;
    if(Sampler() < given) // something is stated
    {
      tinygltf::Sampler sampler;
      sampler.magFilter = given.mag_filter;
      sampler.minFilter = given.min_filter;
      for(const auto& [wrap, result] : {std::make_pair(given.wrap_s, &sampler.wrapS),
                                        std::make_pair(given.wrap_t, &sampler.wrapT)})
        if(wrap != -1)
          *result = wrap;
      texture.sampler = static_cast<int>(m_model.samplers.size());
      m_model.samplers.push_back(std::move(sampler));
    }
    m_model.textures.push_back(std::move(texture));
    return static_cast<int>(m_model.textures.size()) - 1;
  }

private:
  static int component_type(float) { return TINYGLTF_COMPONENT_TYPE_FLOAT; }
  static int component_type(std::uint8_t) { return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE; }
  static int component_type(std::int16_t) { return TINYGLTF_COMPONENT_TYPE_SHORT; }
  static int component_type(std::uint16_t) { return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT; }
  static int component_type(std::uint32_t) { return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT; }

  // Each row of vertices starts at a multiple of four bytes, and so does each array.
  template <class Number>
  int append_view(const Rows<Number>& rows, const Use use)
  {
    const std::size_t of_row = static_cast<std::size_t>(rows.cols()) * sizeof(Number);
    const bool is_of_vertices = use == Use::VERTICES || use == Use::JOINTS;
    const std::size_t stride = is_of_vertices ? padded(of_row) : of_row;
    const std::size_t n = static_cast<std::size_t>(rows.rows());
    auto& bytes = m_model.buffers[0].data;
    const std::size_t begin = padded(bytes.size());
    if(begin + n * stride > std::numeric_limits<std::int32_t>::max())
      throw std::invalid_argument("the surface is too large for glTF: there are more than 2 GB");
    bytes.resize(begin + n * stride, 0);
    for(std::size_t i = 0; i < n; ++i)
      std::memcpy(&bytes[begin + i * stride],
                  rows.data() + i * static_cast<std::size_t>(rows.cols()), of_row);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = begin;
    view.byteLength = n * stride;
    view.byteStride = stride == of_row ? 0 : stride;
    view.target = is_of_vertices        ? TINYGLTF_TARGET_ARRAY_BUFFER
                  : use == Use::INDICES ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER
                                        : 0;
    m_model.bufferViews.push_back(std::move(view));
    return static_cast<int>(m_model.bufferViews.size()) - 1;
  }

  static std::size_t padded(const std::size_t bytes) { return (bytes + 3) / 4 * 4; }

  tinygltf::Model m_model;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_GLTF_BUILDER_H
