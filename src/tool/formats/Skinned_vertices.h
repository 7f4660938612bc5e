// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SKINNED_VERTICES_H
#define CGAL_CANONICAL_POSE_3_TOOL_SKINNED_VERTICES_H

#include "Gltf_numbers.h"
#include "Mesh_instance.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// Where the vertices of a primitive are in the scene: moved by their node or, if that has a skin, by the
// mean of its joints (linear blend skinning), which do not depend on the node.
class Skinned_vertices
{
public:
  // Throws std::invalid_argument if the skin, or what the primitive says about it, is wrong.
  Skinned_vertices(const tinygltf::Model& model, const Mesh_instance& instance,
                   const tinygltf::Primitive& primitive, const std::size_t number_of_vertices)
    : m_of_node(instance.transformation), m_of_joints(instance.joints)
  {
    if(m_of_joints.empty())
      return;
    for(std::size_t set = 0;; ++set)
    {
      const std::string joints = "JOINTS_" + std::to_string(set),
                        weights = "WEIGHTS_" + std::to_string(set);
      const auto of_joints = primitive.attributes.find(joints),
                 of_weights = primitive.attributes.find(weights);
      if(of_joints == primitive.attributes.end() || of_weights == primitive.attributes.end())
        break;
      m_joints.emplace_back(model, of_joints->second, int(INFLUENCES), joints);
      m_weights.emplace_back(model, of_weights->second, int(INFLUENCES), weights);
      if(m_joints.back().count() != number_of_vertices
         || m_weights.back().count() != number_of_vertices)
        throw std::invalid_argument("there are " + std::to_string(number_of_vertices)
                                    + " vertices, but another number of " + joints + " or "
                                    + weights);
    }
    if(m_joints.empty())
      m_of_joints.clear(); // the node alone
  }

  Eigen::Affine3d operator()(const std::size_t v) const
  {
    if(m_of_joints.empty())
      return m_of_node;
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    double total = 0;
    for(std::size_t set = 0; set < m_joints.size(); ++set)
      for(std::size_t k = 0; k < INFLUENCES; ++k)
      {
        const double weight = m_weights[set](v, k);
        if(weight == 0)
          continue;
        const double joint = m_joints[set](v, k);
        if(!(joint >= 0 && joint < static_cast<double>(m_of_joints.size())))
          throw std::invalid_argument(
            "vertex " + std::to_string(v) + " of a primitive is moved by joint "
            + std::to_string(static_cast<long long>(joint)) + " of its skin, which has "
            + std::to_string(m_of_joints.size()));
        sum += weight * m_of_joints[static_cast<std::size_t>(joint)].matrix();
        total += weight;
      }
    if(!(total > 0))
      throw std::invalid_argument("vertex " + std::to_string(v)
                                  + " of a primitive is moved by no joint of its skin");
    return Eigen::Affine3d(Eigen::Matrix4d(sum / total));
  }

  bool is_mirrored() const
  {
    return (m_of_joints.empty() ? m_of_node : m_of_joints.front()).linear().determinant() < 0;
  }

private:
  static constexpr std::size_t INFLUENCES = 4; // in a set of attributes

  Eigen::Affine3d m_of_node;
  std::vector<Eigen::Affine3d> m_of_joints;
  std::vector<Gltf_numbers> m_joints, m_weights;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SKINNED_VERTICES_H
