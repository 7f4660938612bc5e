// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H
#define CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_python {

// See CGAL::Canonical_pose_3::Descriptor_index_3; with a descriptor that is chosen at run time.
class Descriptor_index
{
public:
  virtual ~Descriptor_index() = default;
  virtual std::size_t size() const = 0;
  virtual std::size_t insert(const Eigen::VectorXd& values) = 0;
  virtual Eigen::VectorXd values(std::size_t shape) const = 0;
  virtual Eigen::VectorXd distances(const Eigen::VectorXd& query) const = 0;
  virtual Eigen::MatrixXd distances() const = 0;
  // Shapes and distances.
  virtual std::pair<std::vector<std::size_t>, Eigen::VectorXd>
  nearest(const Eigen::VectorXd& query, std::size_t number) const = 0;
};

// Throws std::invalid_argument if there is no such descriptor in this build.
std::unique_ptr<Descriptor_index> make_descriptor_index(const std::string& descriptor);

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_DESCRIPTOR_INDEX_H
