// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any values of all members of the options, for a small shape: they are refused, or there is a finite
// pose.

#include "Byte_source.h"
#include "poses.h"
#include "shapes.h"

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/Power_kernel.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

using namespace Canonical_pose_fuzz;
namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;

namespace {

using Complex = CP::Indexed_tetrahedra_3<Point_3>;

/// Replaces some values, few or many: most combinations are refused.
class Any_values
{
public:
  explicit Any_values(Byte_source& bytes)
    : m_bytes(bytes), m_one_of(one_of<std::size_t, 4>({{3, 10, 40, 200}}, bytes))
  {}

  void operator()(double& value)
  {
    if(is_replaced())
      value = number();
  }

  void operator()(int& value)
  {
    constexpr int least = std::numeric_limits<int>::min();
    if(is_replaced())
      value = one_of<int, 8>({{0, 1, 2, 3, 7, 30, -1, least}}, m_bytes);
  }

  void operator()(std::size_t& value)
  {
    if(is_replaced())
      value
        = one_of<std::size_t, 6>({{0, 1, 2, 30, std::size_t(1) << 40, std::size_t(-1)}}, m_bytes);
  }

  void operator()(bool& value) { value = m_bytes.below(2) == 0; }

  template <class Enumeration>
  void choose(Enumeration& value, const std::size_t n)
  {
    if(is_replaced())
      value = Enumeration(m_bytes.below(n));
  }

  template <class Value>
  void operator()(std::optional<Value>& value)
  {
    if(!is_replaced())
      return;
    value = Value();
    (*this)(*value);
  }

  // As many as there should be, or not; the same, or not.
  Eigen::VectorXd vector(const std::size_t n)
  {
    if(!is_replaced())
      return {};
    Eigen::VectorXd result
      = Eigen::VectorXd::Constant(Eigen::Index(n + m_bytes.below(2)), m_bytes.below(3));
    if(result.size() > 0)
      (*this)(result[Eigen::Index(m_bytes.below(std::size_t(result.size())))]);
    return result;
  }

  Eigen::MatrixXd matrix(const std::size_t rows, const std::size_t columns)
  {
    Eigen::MatrixXd result
      = Eigen::MatrixXd::Constant(Eigen::Index(rows), Eigen::Index(columns), m_bytes.below(3));
    for(Eigen::Index i = 0; i < result.size(); ++i)
      result(i) = m_bytes.byte() / 64.;
    if(result.size() > 0)
      (*this)(result(Eigen::Index(m_bytes.below(std::size_t(result.size())))));
    return result;
  }

  bool is_replaced() { return m_bytes.below(m_one_of) == 1; }

private:
  double number()
  {
    return m_bytes.below(2) == 0
             ? m_bytes.special_number()
             : one_of<double, 8>({{-1, 1e-9, 0.1, 0.5, 1, 2, 10, 1e6}}, m_bytes);
  }

  Byte_source& m_bytes;
  const std::size_t m_one_of; // of that many values, one is replaced
};

CP::Landmark_fields_3 any_fields(Any_values& any, Byte_source& bytes, const std::size_t n)
{
  CP::Landmark_fields_3 fields;
  const std::size_t l = bytes.below(6);
  fields.distances = any.matrix(n, l);
  for(std::size_t j = 0; j < l; ++j)
  {
    fields.landmarks.push_back(bytes.below(n + 1));
    if(fields.landmarks.back() < n && bytes.below(8) > 0)
      fields.distances(Eigen::Index(fields.landmarks.back()), Eigen::Index(j)) = 0;
  }
  any(fields.covering_radius);
  return fields;
}

CP::Landmark_fields_function fields_function(Any_values& any, Byte_source& bytes)
{
  return [any, &bytes](const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>&,
                       std::size_t, std::size_t, const std::vector<std::size_t>&) mutable {
    return any_fields(any, bytes, std::size_t(points.rows()));
  };
}

// `rows`: number of rows of distances and targets.
Options any_options(Byte_source& bytes, const std::size_t vertices, const std::size_t rows,
                    const std::size_t factors)
{
  Any_values any(bytes);
  Options options;
  any.choose(options.geodesics, 2);
  if(any.is_replaced())
    options.landmark_fields_function = fields_function(any, bytes);
  if(any.is_replaced())
    options.target_fields_function = fields_function(any, bytes);
  any(options.number_of_coarse_vertices);
  options.number_of_landmarks = 6;
  any(options.number_of_landmarks);
  options.random_seed = bytes.byte();
  any.choose(options.kernel, 3);
  if(any.is_replaced())
    options.mds_kernel = CP::Mds_kernel(CP::Power_kernel(1.5));
  any.choose(options.target_mode, 2);
  any(options.unfolding.weight);
  options.number_of_rounds = 0;
  any(options.number_of_rounds);
  any(options.takes_mirror_image);
  any(options.searches_self_intersections);
  any.choose(options.body, 4);
  options.lattice_spacing = 0.3; // few cells: the sanitizers are slow
  if(any.is_replaced())
    options.lattice_spacing
      = one_of<double, 8>({{0.5, 1, 2, -1, 1e-9, 1e300, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}},
                          bytes);
  any.choose(options.components, 3);
  any.choose(options.contacts, 2);
  any.choose(options.symmetry, 2);
  any.choose(options.frame, 2);
  any(options.registration.detail_length);
  any(options.registration.tikhonov);
  options.registration.number_of_iterations = 20;
  any(options.registration.number_of_iterations);
  any(options.registration.energy_tolerance);
  any(options.registration.move_tolerance);
  any(options.registration.acceleration_window);
  any(options.registration.fairing_passes);
  any(options.registration.fairing_lambda);
  any(options.registration.fairing_mu);
  any(options.registration.injective);
  if(any.is_replaced())
  {
    options.paper_weights = CP::Paper_weights();
    any(options.paper_weights->alpha);
    any(options.paper_weights->beta);
  }
  any(options.volume_ratio_limit);
  any.choose(options.solver, 3);
  options.number_of_threads = 1;
  any(options.number_of_threads);
  if(any.is_replaced())
    options.visitor = [&bytes](const CP::Registration_progress&) { return bytes.below(8) > 0; };
  any(options.return_landmark_fields);
  options.matching_weights = any.vector(vertices);
  options.stiffness = any.vector(factors);
  if(any.is_replaced())
    add_constraints(bytes, vertices, options);
  if(any.is_replaced())
    options.followers = any.matrix(bytes.below(4), 3);
  if(any.is_replaced())
    options.given.landmark_fields = any_fields(any, bytes, rows + bytes.below(2));
  if(any.is_replaced())
    options.given.target = any.matrix(rows + bytes.below(2), 3);
  return options;
}

void check_complex(Byte_source& bytes)
{
  const auto soup = bytes.below(2) == 0 ? Canonical_pose_test::tetrahedral_bent_bar(4, 1, 1, 2.)
                                        : Canonical_pose_test::tetrahedral_box(1, 1, 1);
  Complex complex;
  complex.points = to_points(soup.points);
  complex.cells = soup.cells;
  const Options options
    = any_options(bytes, soup.points.size(), soup.points.size(), soup.cells.size());
  std::vector<Point_3> pose(soup.points.size());
  is_accepted([&] {
    check_result(CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options), options,
                 soup.points.size());
  });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  using namespace Canonical_pose_test;
  Byte_source bytes(data, size);
  const std::size_t kind = bytes.below(4);
  if(kind == 0)
  {
    check_complex(bytes);
    return 0;
  }
  const Triangle_soup soup = kind == 1   ? icosphere_soup(0, 1)
                             : kind == 2 ? tube_soup(8, 5, 4, 0.3)
                                         : plane_grid_soup(5, 4, 5, 4);
  Polygons polygons;
  for(const auto& t : soup.triangles)
    polygons.emplace_back(t.begin(), t.end());
  const std::size_t n = soup.points.size();
  checked_pose(soup.points, polygons, any_options(bytes, n, n, n));
  return 0;
}
