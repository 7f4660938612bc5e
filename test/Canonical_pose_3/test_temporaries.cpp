// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Arguments stored by reference must not be temporaries, which are destroyed at the end of the
// statement.

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Labeled_cells_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#if __has_include(<Spectra/SymEigsShiftSolver.h>)
#include <CGAL/Canonical_pose_3/Biharmonic_distances_3.h>
#define CANONICAL_POSE_3_TEST_BIHARMONIC
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_temporaries {

namespace CP = CGAL::Canonical_pose_3;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Map = boost::const_associative_property_map<std::map<Mesh::Vertex_index, Kernel::Point_3>>;
using Body = CP::Conforming_body_3;
using Triangles = std::vector<std::array<std::size_t, 3>>;

// Whether T can be constructed from an lvalue, constant or not, and the other arguments, but not
// from an rvalue.
template <class T, class Kept, class... Others>
constexpr bool takes_lvalues_only
  = std::is_constructible_v<T, Kept&, Others...>&& std::is_constructible_v<
      T, const Kept&,
      Others...> && !std::is_constructible_v<T, Kept, Others...> && !std::is_constructible_v<T, const Kept, Others...>;

template <class Geodesics, class Own_geodesics, class... Others>
constexpr bool geodesics_take_lvalues_only
  = takes_lvalues_only<Geodesics, Mesh>&& takes_lvalues_only<Own_geodesics, Mesh, Map, Others...>&&
      takes_lvalues_only<
        Own_geodesics, Mesh, Map, Others...,
        Kernel> && !std::is_convertible_v<Mesh&, Geodesics> && !std::is_convertible_v<Mesh, Geodesics>;

static_assert(
  geodesics_take_lvalues_only<CP::Heat_geodesics_3<Mesh>, CP::Heat_geodesics_3<Mesh, Map, Kernel>>);
static_assert(geodesics_take_lvalues_only<CP::Wavefront_geodesics_3<Mesh>,
                                          CP::Wavefront_geodesics_3<Mesh, Map, Kernel>>);
static_assert(geodesics_take_lvalues_only<CP::Exact_geodesics_3<Mesh>,
                                          CP::Exact_geodesics_3<Mesh, Map, Kernel>>);
#ifdef CANONICAL_POSE_3_TEST_BIHARMONIC
static_assert(
  geodesics_take_lvalues_only<CP::Biharmonic_distances_3<Mesh>,
                              CP::Biharmonic_distances_3<Mesh, Map, Kernel>, std::size_t>);
static_assert(takes_lvalues_only<CP::Biharmonic_distances_3<Mesh>, Mesh, std::size_t>);
#endif

static_assert(takes_lvalues_only<CP::Body_deformer_3<Body>, Body, Triangles>);

using Tetrahedra = CP::Indexed_tetrahedra_3<Kernel::Point_3>;
static_assert(takes_lvalues_only<CP::Labeled_cells_3<Tetrahedra>, Tetrahedra, int>);
static_assert(takes_lvalues_only<CP::Labeled_cells_3<Tetrahedra>, Tetrahedra, std::vector<int>>);
static_assert(takes_lvalues_only<CP::Labeled_cells_3<Tetrahedra>, Tetrahedra, std::set<int>>);

using Registrar = CP::Tetrahedral_arap_registrar_3<Body>;

// What owns memory can be moved.
template <class... T>
constexpr bool are_movable = (std::is_move_constructible_v<T> && ...);
static_assert(
  are_movable<CP::Heat_geodesics_3<Mesh>, CP::Wavefront_geodesics_3<Mesh>,
              CP::Exact_geodesics_3<Mesh>, CP::Body_deformer_3<Body>,
              CP::Labeled_cells_3<CP::Indexed_tetrahedra_3<Kernel::Point_3>>, Registrar>);
static_assert(std::is_same_v<CP::Heat_geodesics_3<Mesh, Map, Kernel>::Vertex_point_map, Map>);
static_assert(std::is_same_v<CP::Exact_geodesics_3<Mesh, Map, Kernel>::Geom_traits, Kernel>);
static_assert(std::is_same_v<Registrar::Elastic_body, Body>);
static_assert(std::is_same_v<CP::Body_deformer_3<Body>::Elastic_body, Body>);
static_assert(std::is_same_v<CP::Handle_constraint_adaptor_3::value_type, CP::Handle_3>);
static_assert(
  std::is_same_v<CP::Landmark_mds_target_builder_3<>::Kernel, CP::Squared_distance_kernel>);

struct Derived_registrar : Registrar
{
  using Registrar::Registrar;
};

template <class R>
constexpr bool registrar_takes_lvalues_only = takes_lvalues_only<R, Body, Eigen::VectorXd, double>&&
  takes_lvalues_only<R, Body, Eigen::VectorXd, double, CP::Registration_options>&&
    takes_lvalues_only<R, Body, Eigen::VectorXd, double, CP::Registration_options, Eigen::VectorXd>;

static_assert(registrar_takes_lvalues_only<Registrar>);
static_assert(registrar_takes_lvalues_only<Derived_registrar>);

template <class Constraint, class = void>
constexpr bool is_added = false;

template <class Constraint>
constexpr bool is_added<Constraint, std::void_t<decltype(std::declval<Registrar&>().add_constraint(
                                      std::declval<Constraint>()))>> = true;

using Handles = CP::Handle_constraint_adaptor_3;
static_assert(is_added<Handles&> && is_added<const Handles&>);
static_assert(!is_added<Handles> && !is_added<const Handles>);

// The rest is checked at compile time, above. The template parameter of the registrar is still
// deduced.
TEST(Temporaries, lvalues_are_taken)
{
  CP::Point_matrix points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const Body body(points, {{0, 1, 2, 3}}, 4);
  CP::Tetrahedral_arap_registrar_3 registrar(body, Eigen::VectorXd::Ones(4), 1.);
  static_assert(std::is_same_v<decltype(registrar), Registrar>);
  const Handles handles(4);
  registrar.add_constraint(handles);
  registrar.remove_constraint(handles);
  EXPECT_EQ(registrar.surface_points(points), points);
}

} // namespace test_temporaries
