// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "Descriptor_index.h"

#include "descriptors.h"

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Shape_distribution_d2_3.h>
#include <CGAL/Canonical_pose_3/View_descriptor_3.h>
#ifdef CANONICAL_POSE_WITH_SPECTRA
#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/Shape_dna_3.h>
#endif

#include <mutex>
#include <shared_mutex>
#include <stdexcept>

namespace Canonical_pose_python {

namespace {

namespace CP = CGAL::Canonical_pose_3;

template <class Model>
class Model_index : public Descriptor_index
{
public:
  std::size_t size() const override
  {
    const Reading lock(m_mutex);
    return m_index.size();
  }

  std::size_t insert(const Eigen::VectorXd& values) override
  {
    const std::unique_lock<std::shared_mutex> lock(m_mutex);
    return m_index.insert(values);
  }

  Eigen::VectorXd distances(const Eigen::VectorXd& query) const override
  {
    const Reading lock(m_mutex);
    return m_index.distances(query);
  }

  Eigen::MatrixXd distances() const override
  {
    const Reading lock(m_mutex);
    return m_index.distances();
  }

  Eigen::VectorXd values(const std::size_t shape) const override
  {
    const Reading lock(m_mutex);
    if(shape >= m_index.size())
      throw std::out_of_range("there is no shape " + std::to_string(shape) + ", but "
                              + std::to_string(m_index.size()) + " shapes");
    return m_index.values(shape);
  }

  std::pair<std::vector<std::size_t>, Eigen::VectorXd>
  nearest(const Eigen::VectorXd& query, const std::size_t number) const override
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

  mutable std::shared_mutex m_mutex;
  CP::Descriptor_index_3<Model> m_index;
};

template <class Model, class... Models>
std::unique_ptr<Descriptor_index> make_index(const std::string& name)
{
  if(name == Model::name())
    return std::make_unique<Model_index<Model>>();
  if constexpr(sizeof...(Models) > 0)
    return make_index<Models...>(name);
  Canonical_pose_tool::descriptors({name}); // throws
  throw std::logic_error("there is no index of " + name);
}

} // namespace

std::unique_ptr<Descriptor_index> make_descriptor_index(const std::string& descriptor)
{
  return make_index<
#ifdef CANONICAL_POSE_WITH_SPECTRA
    CP::Heat_kernel_quantiles_3, CP::Shape_dna_3,
#endif
    CP::Shape_distribution_d2_3, CP::View_descriptor_3>(descriptor);
}

} // namespace Canonical_pose_python
