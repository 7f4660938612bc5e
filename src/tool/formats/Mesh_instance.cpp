// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gltf_numbers.h"
#include "Mesh_instance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

Eigen::Affine3d own_transformation(const tinygltf::Node& node)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if(node.matrix.size() == 16)
  {
    result.matrix() = Eigen::Matrix4d::Map(node.matrix.data());
    return result;
  }
  if(node.translation.size() == 3)
    result.translate(Eigen::Vector3d::Map(node.translation.data()));
  if(node.rotation.size() == 4)
    result.rotate(
      Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
        .normalized());
  if(node.scale.size() == 3)
    result.scale(Eigen::Vector3d::Map(node.scale.data()));
  return result;
}

// By each node and those above it.
class Node_transformations
{
public:
  explicit Node_transformations(const tinygltf::Model& model)
    : m_model(model), m_parents(model.nodes.size(), NONE)
  {
    for(std::size_t n = 0; n < model.nodes.size(); ++n)
      for(const int child : model.nodes[n].children)
        if(child >= 0 && static_cast<std::size_t>(child) < m_parents.size())
          m_parents[static_cast<std::size_t>(child)] = n;
  }

  Eigen::Affine3d operator()(const std::size_t node) const
  {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    std::size_t steps = 0;
    for(std::size_t n = node; n != NONE; n = m_parents[n])
    {
      if(steps++ == m_parents.size())
        throw std::invalid_argument("the nodes form a cycle");
      result = own_transformation(m_model.nodes[n]) * result;
    }
    return result;
  }

private:
  static constexpr std::size_t NONE = std::size_t(-1);

  const tinygltf::Model& m_model;
  std::vector<std::size_t> m_parents;
};

// Those of the joints of a skin, after the inverse bind matrices.
std::vector<Eigen::Affine3d> transformations_of_joints(const tinygltf::Model& model, const int skin,
                                                       const Node_transformations& of_nodes)
{
  if(static_cast<std::size_t>(skin) >= model.skins.size())
    throw std::invalid_argument("a node names skin " + std::to_string(skin) + ", but there are "
                                + std::to_string(model.skins.size()));
  const tinygltf::Skin& s = model.skins[static_cast<std::size_t>(skin)];
  std::vector<Eigen::Affine3d> result;
  for(const int joint : s.joints)
  {
    if(joint < 0 || static_cast<std::size_t>(joint) >= model.nodes.size())
      throw std::invalid_argument("skin " + std::to_string(skin) + " names node "
                                  + std::to_string(joint) + ", but there are "
                                  + std::to_string(model.nodes.size()));
    result.push_back(of_nodes(static_cast<std::size_t>(joint)));
  }
  if(s.inverseBindMatrices < 0)
    return result;
  const Gltf_numbers numbers(model, s.inverseBindMatrices, 16, "the inverse bind matrices");
  if(numbers.count() < result.size())
    throw std::invalid_argument("skin " + std::to_string(skin) + " has "
                                + std::to_string(result.size()) + " joints, but "
                                + std::to_string(numbers.count()) + " inverse bind matrices");
  for(std::size_t j = 0; j < result.size(); ++j)
  {
    Eigen::Affine3d inverse = Eigen::Affine3d::Identity();
    for(std::size_t i = 0; i < 12; ++i) // the first three rows, in columns of four
      inverse.matrix()(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3))
        = numbers(j, 4 * (i / 3) + i % 3);
    result[j] = result[j] * inverse;
  }
  return result;
}

// Whether each node is shown: by the default scene, otherwise the first one, or always if there is none.
std::vector<bool> nodes_of_scene(const tinygltf::Model& model)
{
  std::vector<bool> result(model.nodes.size(), model.scenes.empty());
  if(model.scenes.empty())
    return result;
  const auto scene = static_cast<std::size_t>((std::max)(model.defaultScene, 0));
  if(scene >= model.scenes.size())
    throw std::invalid_argument("scene " + std::to_string(scene) + " is shown, but there are "
                                + std::to_string(model.scenes.size()));
  std::vector<int> pending = model.scenes[scene].nodes;
  while(!pending.empty())
  {
    const auto node = static_cast<std::size_t>(pending.back());
    pending.pop_back();
    if(node >= result.size() || result[node])
      continue;
    result[node] = true;
    const std::vector<int>& children = model.nodes[node].children;
    pending.insert(pending.end(), children.begin(), children.end());
  }
  return result;
}

} // namespace

std::pair<int, int> accessors_of_vertices(const Mesh_instance& instance,
                                          const tinygltf::Primitive& primitive)
{
  const auto joints = primitive.attributes.find("JOINTS_0");
  return {primitive.attributes.at("POSITION"),
          instance.joints.empty() || joints == primitive.attributes.end() ? -1 : joints->second};
}

std::vector<Mesh_instance> mesh_instances(const tinygltf::Model& model)
{
  const std::vector<bool> is_in_scene = nodes_of_scene(model);
  const Node_transformations transformations(model);
  std::vector<Mesh_instance> result;
  for(std::size_t n = 0; n < model.nodes.size(); ++n)
  {
    if(model.nodes[n].mesh < 0 || !is_in_scene[n])
      continue;
    const auto mesh = static_cast<std::size_t>(model.nodes[n].mesh);
    if(mesh >= model.meshes.size())
      throw std::invalid_argument("node " + std::to_string(n) + " names mesh "
                                  + std::to_string(mesh) + ", but there are "
                                  + std::to_string(model.meshes.size()));
    result.push_back({mesh, transformations(n), n, {}});
    if(model.nodes[n].skin >= 0)
      result.back().joints = transformations_of_joints(model, model.nodes[n].skin, transformations);
  }
  if(result.empty() && model.meshes.size() == 1 && model.scenes.empty())
    result.push_back({0, Eigen::Affine3d::Identity(), std::nullopt, {}});
  if(result.empty())
    throw std::invalid_argument(model.meshes.empty()   ? "there is no mesh"
                                : model.scenes.empty() ? "no node has a mesh"
                                                       : "the scene shows no mesh");
  return result;
}

} // namespace Canonical_pose_tool
