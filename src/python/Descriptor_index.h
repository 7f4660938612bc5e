// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H
#define CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H

#include "descriptors.h"

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_python {

// A model of ShapeDescriptor_3 that is chosen at run time.
class Chosen_descriptor
{
public:
  // Throws std::invalid_argument if there is no such descriptor in this build.
  explicit Chosen_descriptor(const std::string& name)
    : m_descriptor(Canonical_pose_tool::descriptors({name}).front())
  {}

  const std::string& name() const { return m_descriptor.name; }
  std::size_t size() const { return static_cast<std::size_t>(m_descriptor.size); }

  Eigen::VectorXd distances(const Eigen::VectorXd& query, const Eigen::MatrixXd& others) const
  {
    return m_descriptor.distances(query, others);
  }

private:
  Canonical_pose_tool::Descriptor m_descriptor;
};

// See CGAL::Canonical_pose_3::Descriptor_index_3; several threads may call it.
class Descriptor_index
{
public:
  explicit Descriptor_index(const std::string& descriptor) : m_index(Chosen_descriptor(descriptor))
  {}

  std::size_t size() const
  {
    const Reading lock(m_mutex);
    return m_index.size();
  }

  std::size_t insert(const Eigen::VectorXd& values)
  {
    const std::unique_lock<std::shared_mutex> lock(m_mutex);
    return m_index.insert(values);
  }

  Eigen::VectorXd values(const std::size_t shape) const
  {
    const Reading lock(m_mutex);
    if(shape >= m_index.size())
      throw std::out_of_range("there is no shape " + std::to_string(shape) + ", but "
                              + std::to_string(m_index.size()) + " shapes");
    return m_index.values(shape);
  }

  Eigen::VectorXd distances(const Eigen::VectorXd& query) const
  {
    const Reading lock(m_mutex);
    return m_index.distances(query);
  }

  Eigen::MatrixXd distances() const
  {
    const Reading lock(m_mutex);
    return m_index.distances();
  }

  // Shapes and distances.
  std::pair<std::vector<std::size_t>, Eigen::VectorXd> nearest(const Eigen::VectorXd& query,
                                                               const std::size_t number) const
  {
    const Reading lock(m_mutex);
    const auto neighbors = m_index.nearest(query, number);
    std::vector<std::size_t> shapes;
    Eigen::VectorXd distances(static_cast<Eigen::Index>(neighbors.size()));
    for(const auto& neighbor : neighbors)
    {
      distances[static_cast<Eigen::Index>(shapes.size())] = neighbor.distance;
      shapes.push_back(neighbor.shape);
    }
    return {shapes, distances};
  }

private:
  using Reading = std::shared_lock<std::shared_mutex>;

  CGAL::Canonical_pose_3::Descriptor_index_3<Chosen_descriptor> m_index;
  mutable std::shared_mutex m_mutex;
};

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H
