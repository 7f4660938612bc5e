// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_GLTF_NUMBERS_H
#define CGAL_CANONICAL_POSE_3_TOOL_GLTF_NUMBERS_H

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace Canonical_pose_tool {

// The numbers of an accessor of glTF, all of which are in its buffer.
class Gltf_numbers
{
public:
  // Throws std::invalid_argument unless there are tuples of `components` numbers. `name` is for
  // messages.
  Gltf_numbers(const tinygltf::Model& model, const int accessor, const int components,
               const std::string& name)
  {
    const auto refuse = [&](const std::string& defect) {
      throw std::invalid_argument("the accessor of " + name + " " + defect);
    };
    if(accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size())
      refuse("does not exist");
    const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
    if(a.sparse.isSparse)
      refuse("is sparse, which is not supported");
    if(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)) != components)
      refuse("does not have " + std::to_string(components)
             + (components == 1 ? " component" : " components"));
    if(a.bufferView < 0 || static_cast<std::size_t>(a.bufferView) >= model.bufferViews.size())
      refuse("has no buffer view");
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
    if(!view.extensions.empty())
      refuse("needs the extension " + view.extensions.begin()->first + ", which is not supported");
    if(view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
      refuse("has no buffer");
    const auto& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if(view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
      refuse("has a buffer view that is longer than its buffer");
    const int stride = a.ByteStride(view);
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType));
    if(stride <= 0 || size <= 0)
      refuse("has numbers of an unknown type");
    m_stride = static_cast<std::size_t>(stride);
    m_component_size = static_cast<std::size_t>(size);
    const std::size_t of_tuple = m_component_size * static_cast<std::size_t>(components);
    if(m_stride < of_tuple || a.byteOffset > view.byteLength
       || (a.count > 0
           && (view.byteLength - a.byteOffset < of_tuple
               || a.count - 1 > (view.byteLength - a.byteOffset - of_tuple) / m_stride)))
      refuse("is longer than its buffer view");
    m_type = a.componentType;
    m_is_normalized = a.normalized;
    m_count = a.count;
    m_bytes = bytes.data() + view.byteOffset + a.byteOffset;
  }

  std::size_t count() const { return m_count; }

  bool are_indices() const
  {
    return !m_is_normalized
           && (m_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
               || m_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
               || m_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  }

  double operator()(const std::size_t tuple, const std::size_t component) const
  {
    const unsigned char* const bytes = m_bytes + tuple * m_stride + component * m_component_size;
    switch(m_type)
    {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return normalized(value<std::int8_t>(bytes), 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized(value<std::uint8_t>(bytes), 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return normalized(value<std::int16_t>(bytes), 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return normalized(value<std::uint16_t>(bytes), 65535);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return value<std::int32_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return value<std::uint32_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return value<float>(bytes);
    default:
      return value<double>(bytes);
    }
  }

private:
  template <class Number>
  static Number value(const unsigned char* const bytes)
  {
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
  }

  double normalized(const double number, const double largest) const
  {
    return !m_is_normalized ? number : number < -largest ? -1 : number / largest;
  }

  const unsigned char* m_bytes;
  std::size_t m_count, m_stride, m_component_size;
  int m_type;
  bool m_is_normalized;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_GLTF_NUMBERS_H
