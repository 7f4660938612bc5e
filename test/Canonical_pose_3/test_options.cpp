// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Walks over all members of all types of options. Each has values that are refused, with a message
// that names it, or is listed as one that has none. The names are those of a structured binding, so a
// member that is added does not compile before it is listed here.

#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Power_kernel.h>
#include <CGAL/Canonical_pose_3/Smacof_target_builder_3.h>
#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_options {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Options;

// `found`: the names of all members of the type, which follow.
#define EXPECT_MEMBERS(found, Type, ...)                                                           \
  do                                                                                               \
  {                                                                                                \
    const Type object{};                                                                           \
    [[maybe_unused]] const auto& [__VA_ARGS__] = object;                                           \
    const std::set<std::string> members = names(#__VA_ARGS__);                                     \
    EXPECT_EQ(found, members);                                                                     \
  } while(false)

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN(),
             INFINITE = std::numeric_limits<double>::infinity();

std::set<std::string> names(const std::string& list)
{
  std::set<std::string> result;
  std::istringstream in(list);
  for(std::string name; std::getline(in >> std::ws, name, ',');)
    result.insert(name);
  return result;
}

// Changes options into ones that are refused, with the text in the message.
struct Bad_value
{
  std::string text;
  std::function<void(Options&)> set;
};

using Bad_values = std::map<std::string, std::vector<Bad_value>>;

// `member(options)`: a reference to a number.
template <class Function>
std::vector<Bad_value> bad_numbers(const std::string& text, const std::vector<double>& values,
                                   const Function& member)
{
  std::vector<Bad_value> result;
  for(const double value : values)
    result.push_back({text, [=](Options& options) {
                        auto& number = member(options);
                        number = static_cast<std::decay_t<decltype(number)>>(value);
                      }});
  return result;
}

template <class Value>
std::vector<Bad_value> bad_enumerators(const std::string& name,
                                       Value CP::Method_options::*const member, const Value last)
{
  std::vector<Bad_value> result;
  for(const int value : {-1, static_cast<int>(last) + 1})
    result.push_back(
      {name, [=](Options& options) { options.*member = static_cast<Value>(value); }});
  return result;
}

const std::vector<double> NOT_NONNEGATIVE = {-1, NOT_A_NUMBER, INFINITE},
                          NOT_POSITIVE = {0, -1, NOT_A_NUMBER, INFINITE},
                          NOT_FINITE = {NOT_A_NUMBER, INFINITE, -INFINITE},
                          NO_WEIGHT = {0, -1, NOT_A_NUMBER, INFINITE, 1e-320, 1e300},
                          NO_WEIGHT_OR_ZERO = {-1, NOT_A_NUMBER, INFINITE, 1e300};

Bad_values of_registration()
{
  const auto numbers = [](const std::string& name, const std::vector<double>& values,
                          auto CP::Registration_options::*const member) {
    return bad_numbers(
      name, values, [=](Options & o) -> auto& { return o.registration.*member; });
  };
  using R = CP::Registration_options;
  return {
    {"detail_length",
     numbers("detail_length", {0, -1, NOT_A_NUMBER, INFINITE, 1e-320, 1e-7, 1e4, 1e20},
             &R::detail_length)},
    {"tikhonov", numbers("tikhonov", NO_WEIGHT_OR_ZERO, &R::tikhonov)},
    {"number_of_iterations", numbers("number_of_iterations", {-1}, &R::number_of_iterations)},
    {"energy_tolerance", numbers("energy_tolerance", NOT_NONNEGATIVE, &R::energy_tolerance)},
    {"move_tolerance", numbers("move_tolerance", NOT_NONNEGATIVE, &R::move_tolerance)},
    {"acceleration_window", numbers("acceleration_window", {-1}, &R::acceleration_window)},
    {"fairing_passes", numbers("fairing_passes", {-1}, &R::fairing_passes)},
    {"fairing_lambda",
     numbers("fairing_lambda", {NOT_A_NUMBER, INFINITE, -1.5, 1.5}, &R::fairing_lambda)},
    {"fairing_mu", numbers("fairing_mu", {NOT_A_NUMBER, INFINITE, -1.5, 1.5}, &R::fairing_mu)},
    {"injective", {}},
  };
}

class Kernel_without_values : public CP::Gaussian_kernel
{
public:
  double operator()(double) const { return NOT_A_NUMBER; }
  const char* name() const { return "mds_kernel without values"; }
};

Bad_values of_method()
{
  using O = Options;
  const auto number_of_rounds = [](Options& o) -> int& { return o.number_of_rounds.emplace(); };
  const auto volume_ratio_limit
    = [](Options& o) -> double& { return o.volume_ratio_limit.emplace(); };
  const auto spacing = [](Options& o) -> double& { return o.lattice_spacing; };
  return {
    {"geodesics", bad_enumerators("geodesics", &O::geodesics, O::Geodesics::WAVEFRONT)},
    {"landmark_fields_function", {}},
    {"target_fields_function", {}},
    {"number_of_coarse_vertices", {}},
    {"number_of_landmarks",
     bad_numbers("number_of_landmarks", {0},
                 [](Options& o) -> std::size_t& { return o.number_of_landmarks; })},
    {"random_seed", {}},
    {"kernel", bad_enumerators("kernel", &O::kernel, O::Kernel::UNCENTERED_GAUSSIAN)},
    {"mds_kernel", {{"mds_kernel", [](Options& o) { o.mds_kernel = Kernel_without_values(); }}}},
    {"target_mode", bad_enumerators("target_mode", &O::target_mode, O::Target_mode::UNFOLDING)},
    {"unfolding", bad_numbers("unfolding.weight", NO_WEIGHT,
                              [](Options& o) -> double& { return o.unfolding.weight; })},
    {"number_of_rounds", bad_numbers("number_of_rounds", {-1}, number_of_rounds)},
    {"takes_mirror_image", {}},
    {"searches_self_intersections", {}},
    {"body", bad_enumerators("body", &O::body, O::Body::MESH_3)},
    {"make_body", {}},
    {"lattice_spacing",
     bad_numbers("lattice_spacing", {-1, NOT_A_NUMBER, INFINITE, 1e-320, 1e-7, 1.5}, spacing)},
    {"components", bad_enumerators("components", &O::components, O::Components::EACH)},
    {"symmetry", bad_enumerators("symmetry", &O::symmetry, O::Symmetry::NONE)},
    {"contacts", bad_enumerators("contacts", &O::contacts, O::Contacts::CUT)},
    {"stance", bad_enumerators("stance", &O::stance, O::Stance::STAND)},
    {"frame", bad_enumerators("frame", &O::frame, O::Frame::BODY)},
    {"registration", of_registration()["detail_length"]}, // and its other members, below
    {"paper_weights", bad_numbers("paper_weights.alpha", NOT_POSITIVE,
                                  [](Options& o) -> double& {
                                    return o.paper_weights.emplace().alpha;
                                  })}, // and beta, below
    {"volume_ratio_limit",
     bad_numbers("volume_ratio_limit", {0, -1, NOT_A_NUMBER}, volume_ratio_limit)},
    {"solver", bad_enumerators("solver", &O::solver, O::Solver::CHOLMOD)},
    {"linear_solver", {}},
    {"number_of_threads", bad_numbers("number_of_threads", {-1},
                                      [](Options& o) -> int& { return o.number_of_threads; })},
    {"visitor", {}},
    {"return_landmark_fields", {}},
  };
}

Bad_values of_paper_weights()
{
  return {{"alpha", of_method()["paper_weights"]},
          {"beta", bad_numbers("paper_weights.beta", NO_WEIGHT_OR_ZERO, [](Options& o) -> double& {
             return o.paper_weights.emplace().beta;
           })}};
}

const std::size_t NUMBER_OF_VERTICES = shapes::small_bar().points.size();

// Factors of all vertices, 1 but for one.
std::vector<Bad_value> bad_factors(const std::string& name,
                                   Eigen::VectorXd CP::Vertex_options::*const member,
                                   const std::vector<double>& values)
{
  const auto n = static_cast<Eigen::Index>(NUMBER_OF_VERTICES);
  std::vector<Bad_value> result = {{"3 numbers are given as " + name, [=](Options& options) {
                                      options.*member = Eigen::VectorXd::Ones(3);
                                    }}};
  for(const double value : values)
    result.push_back({"the " + name + " of vertex 7", [=](Options& options) {
                        options.*member = Eigen::VectorXd::Ones(n);
                        (options.*member)[7] = value;
                      }});
  return result;
}

Bad_values of_vertices()
{
  return {
    {"matching_weights", bad_factors("matching weight", &Options::matching_weights,
                                     {-1, NOT_A_NUMBER, INFINITE, 1e-320, 1e300})},
    {"stiffness", bad_factors("stiffness", &Options::stiffness, NO_WEIGHT)},
    {"constraints",
     {{"spring 0",
       [](Options& o) {
         o.constraints.springs = {{0, 0, 1., 1.}};
       }}}},
    {"limb_directions",
     {{"limb direction 0",
       [](Options& o) {
         o.limb_directions.resize(1);
         o.limb_directions[0].limb = NUMBER_OF_VERTICES;
       }}}},
    {"followers",
     {{"follower 1",
       [](Options& o) {
         o.followers = CP::Point_matrix::Zero(2, 3);
         o.followers(1, 2) = NOT_A_NUMBER;
       }}}},
    {"given",
     {{"the given target", [](Options& o) { o.given.target = CP::Point_matrix::Zero(2, 3); }}}},
  };
}

// Values of a member of an element of a constraint.
template <class Element, class Function>
std::vector<Bad_value> bad_elements(const std::string& text, const Element& good,
                                    std::vector<Element> CP::Constraints_3::*const list,
                                    const std::vector<double>& values, const Function& member)
{
  return bad_numbers(
    text, values, [=](Options & options) -> auto& {
      (options.constraints.*list) = {good};
      return member((options.constraints.*list).front());
    });
}

Bad_values of_limb_directions()
{
  using D = CP::Limb_direction_3;
  const auto bad = [](const std::function<void(D&)>& change) {
    return std::vector<Bad_value>{{"limb direction 1", [=](Options& options) {
                                     options.limb_directions.resize(2);
                                     options.limb_directions[1].limb = D::Limb::RIGHT_ARM;
                                     change(options.limb_directions[1]);
                                   }}};
  };
  std::vector<Bad_value> limbs = bad([](D&d) { d.limb = D::Limb::LEFT_ARM; }), directions;
  for(const int limb : {-1, 8})
    limbs.push_back(bad([=](D& d) { d.limb = static_cast<D::Limb>(limb); })[0]);
  limbs.push_back(bad([](D& d) { d.limb = NUMBER_OF_VERTICES; })[0]);
  for(const double value : NOT_FINITE)
    directions.push_back(bad([=](D& d) { d.direction[2] = value; })[0]);
  directions.push_back(bad([](D& d) { d.direction.setZero(); })[0]);
  return {{"limb", limbs}, {"direction", directions}, {"is_straightened", {}}};
}

const double NO_VERTEX = static_cast<double>(NUMBER_OF_VERTICES);

Bad_values of_springs()
{
  const CP::Spring_3 good = {0, 1, 1., 1.};
  const auto bad = [&](const std::vector<double>& values, auto CP::Spring_3::*const member) {
    return bad_elements(
      "spring 0", good, &CP::Constraints_3::springs,
      values, [=](CP::Spring_3 & s) -> auto& { return s.*member; });
  };
  return {{"p", bad({NO_VERTEX}, &CP::Spring_3::p)},
          {"q", bad({NO_VERTEX, 0}, &CP::Spring_3::q)},
          {"rest_length", bad(NOT_NONNEGATIVE, &CP::Spring_3::rest_length)},
          {"stiffness", bad(NO_WEIGHT, &CP::Spring_3::stiffness)}};
}

Bad_values of_directions()
{
  const CP::Directed_pair_3 good = {0, 1, Eigen::RowVector3d(1, 0, 0), 1.};
  const auto bad = [&](const std::vector<double>& values, const auto& member) {
    return bad_elements("direction 0", good, &CP::Constraints_3::directions, values, member);
  };
  using D = CP::Directed_pair_3;
  return {{"p", bad({NO_VERTEX}, [](D& d) -> std::size_t& { return d.p; })},
          {"q", bad({NO_VERTEX, 0}, [](D& d) -> std::size_t& { return d.q; })},
          {"vector", bad(NOT_FINITE, [](D& d) -> double& { return d.vector[2]; })},
          {"stiffness", bad(NO_WEIGHT, [](D& d) -> double& { return d.stiffness; })}};
}

Bad_values of_handles()
{
  const CP::Handle_3 good = {0, Eigen::RowVector3d(1, 0, 0), 1.};
  const auto bad = [&](const std::vector<double>& values, const auto& member) {
    return bad_elements("handle 0", good, &CP::Constraints_3::handles, values, member);
  };
  using H = CP::Handle_3;
  return {{"p", bad({NO_VERTEX}, [](H& h) -> std::size_t& { return h.p; })},
          {"position", bad(NOT_FINITE, [](H& h) -> double& { return h.position[2]; })},
          {"stiffness", bad(NO_WEIGHT, [](H& h) -> double& { return h.stiffness; })}};
}

Bad_values of_symmetric_pairs()
{
  const CP::Symmetric_pair_3 good = {0, 1, 1.};
  const auto bad = [&](const std::vector<double>& values, const auto& member) {
    return bad_elements("symmetric pair 0", good, &CP::Constraints_3::symmetric_pairs, values,
                        member);
  };
  using S = CP::Symmetric_pair_3;
  return {{"p", bad({NO_VERTEX}, [](S& s) -> std::size_t& { return s.p; })},
          {"q", bad({NO_VERTEX}, [](S& s) -> std::size_t& { return s.q; })},
          {"stiffness", bad(NO_WEIGHT, [](S& s) -> double& { return s.stiffness; })}};
}

Bad_values of_constraints()
{
  return {{"springs", of_springs()["p"]},
          {"directions", of_directions()["p"]},
          {"handles", of_handles()["p"]},
          {"symmetric_pairs", of_symmetric_pairs()["p"]},
          {"function", {}}};
}

// Given distances, all of them 1, to two landmarks.
template <class Function>
Bad_value bad_fields(const std::string& text, const Function& change)
{
  return {text, [=](Options& options) {
            CP::Landmark_fields_3& fields = options.given.landmark_fields.emplace();
            fields.landmarks = {0, 1};
            fields.distances
              = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(NUMBER_OF_VERTICES), 2);
            change(fields);
          }};
}

Bad_values of_fields()
{
  using F = CP::Landmark_fields_3;
  const std::string given = "the given distances";
  return {
    {"landmarks",
     {bad_fields(given + " have landmark " + std::to_string(NUMBER_OF_VERTICES),
                 [](F& f) { f.landmarks[1] = NUMBER_OF_VERTICES; }),
      bad_fields(given + " have landmark 18446744073709551615",
                 [](F& f) { f.landmarks[1] = std::size_t(-1); }),
      bad_fields(given + " have 1 landmarks, but 2", [](F& f) { f.landmarks = {0}; })}},
    {"distances",
     {bad_fields(given + " have 3 rows", [](F& f) { f.distances = Eigen::MatrixXd::Ones(3, 2); }),
      bad_fields("the distance of vertex 5 to landmark 1 is not finite",
                 [](F& f) { f.distances(5, 1) = NOT_A_NUMBER; }),
      bad_fields("the distance of vertex 5 to landmark 1 is negative",
                 [](F& f) { f.distances(5, 1) = -1; }),
      bad_fields("that of vertex 5 is too large", [](F& f) { f.distances(5, 1) = 1e200; })}},
    {"covering_radius",
     {bad_fields("covering_radius", [](F& f) { f.covering_radius = NOT_A_NUMBER; }),
      bad_fields("covering_radius", [](F& f) { f.covering_radius = INFINITE; }),
      bad_fields("covering_radius", [](F& f) { f.covering_radius = -1; })}},
  };
}

Bad_values of_given()
{
  return {{"landmark_fields", of_fields()["distances"]}, {"target", of_vertices()["given"]}};
}

std::set<std::string> names_of(const Bad_values& values)
{
  std::set<std::string> result;
  for(const auto& member : values)
    result.insert(member.first);
  return result;
}

// Each bad value is refused by the call, for a surface.
void expect_refused(const Bad_values& values)
{
  static const shapes::Polygon_soup bar = shapes::small_bar();
  for(const auto& [member, bad_values] : values)
    for(const Bad_value& bad : bad_values)
    {
      SCOPED_TRACE(member);
      Options options;
      bad.set(options);
      EXPECT_THROW_WITH(shapes::pose_of(bar, options), std::invalid_argument, bad.text);
    }
}

TEST(Options_of_the_call, no_member_is_missing)
{
  EXPECT_MEMBERS(names_of(of_registration()), CP::Registration_options, detail_length, tikhonov,
                 number_of_iterations, energy_tolerance, move_tolerance, acceleration_window,
                 fairing_passes, fairing_lambda, fairing_mu, injective);
  EXPECT_MEMBERS(names_of(of_method()), CP::Method_options, geodesics, landmark_fields_function,
                 target_fields_function, number_of_coarse_vertices, number_of_landmarks,
                 random_seed, kernel, mds_kernel, target_mode, unfolding, number_of_rounds,
                 symmetry, takes_mirror_image, searches_self_intersections, body, make_body,
                 lattice_spacing, components, contacts, stance, frame, registration, paper_weights,
                 volume_ratio_limit, solver, linear_solver, number_of_threads, visitor,
                 return_landmark_fields);
  EXPECT_MEMBERS(names_of(of_paper_weights()), CP::Paper_weights, alpha, beta);
  EXPECT_MEMBERS(names("weight"), CP::Unfolding, weight);
  EXPECT_MEMBERS(names_of(of_vertices()), CP::Vertex_options, matching_weights, stiffness,
                 constraints, limb_directions, followers, given);
  EXPECT_MEMBERS(names_of(of_limb_directions()), CP::Limb_direction_3, limb, direction,
                 is_straightened);
  EXPECT_MEMBERS(names_of(of_constraints()), CP::Constraints_3, springs, directions, handles,
                 symmetric_pairs, function);
  EXPECT_MEMBERS(names_of(of_springs()), CP::Spring_3, p, q, rest_length, stiffness);
  EXPECT_MEMBERS(names_of(of_directions()), CP::Directed_pair_3, p, q, vector, stiffness);
  EXPECT_MEMBERS(names_of(of_handles()), CP::Handle_3, p, position, stiffness);
  EXPECT_MEMBERS(names_of(of_symmetric_pairs()), CP::Symmetric_pair_3, p, q, stiffness);
  EXPECT_MEMBERS(names_of(of_given()), CP::Intermediate_results, landmark_fields, target);
  EXPECT_MEMBERS(names_of(of_fields()), CP::Landmark_fields_3, landmarks, distances,
                 covering_radius);
}

TEST(Options_of_the_call, bad_values_are_refused_by_name)
{
  for(const Bad_values& values :
      {of_registration(), of_method(), of_paper_weights(), of_vertices(), of_constraints(),
       of_limb_directions(), of_springs(), of_directions(), of_handles(), of_symmetric_pairs(),
       of_given(), of_fields()})
    expect_refused(values);
}

// The detail length that the paper's weight leads to is known once there is a body.
TEST(Options_of_the_call, paper_weights_lead_to_a_detail_length)
{
  for(const double alpha : {1e-320, 1e-20, 1e20, 1e300})
  {
    Options options;
    options.paper_weights.emplace().alpha = alpha;
    EXPECT_THROW_WITH(shapes::pose_of(shapes::small_bar(), options), std::invalid_argument,
                      "option paper_weights.alpha is ");
  }
}

TEST(Options_of_the_call, values_are_shown_with_enough_digits)
{
  Options options;
  options.registration.detail_length = 1000.0000000000001;
  EXPECT_THROW_WITH(shapes::pose_of(shapes::small_bar(), options), std::invalid_argument,
                    "option detail_length is 1000.0000000000001, but must be from 1e-06 to 1000");
  options = Options();
  options.lattice_spacing = 1e-320;
  EXPECT_THROW_WITH(shapes::pose_of(shapes::small_bar(), options), std::invalid_argument,
                    "option lattice_spacing is 9.99989e-321, but must be 0 or from 1e-06 to 1");
  options.lattice_spacing = 1e-6;
  EXPECT_THROW_WITH(shapes::pose_of(shapes::small_bar(), options), std::invalid_argument,
                    "the spacing of the lattice, 1e-06 of the largest distance, is too small");
}

// At the ends of the ranges, also in rounds, where the detail length is halved.
TEST(Options_of_the_call, the_ends_of_the_ranges_work)
{
  using R = CP::Registration_options;
  const std::vector<std::function<void(Options&)>> ends = {
    [](Options& o) { o.registration.detail_length = R::SMALLEST_DETAIL_LENGTH; },
    [](Options& o) { o.registration.detail_length = R::LARGEST_DETAIL_LENGTH; },
    [](Options& o) { o.registration.tikhonov = R::LARGEST_WEIGHT; },
    [](Options& o) { o.lattice_spacing = 1; },
    [](Options& o) {
      o.target_mode = Options::Target_mode::UNFOLDING, o.unfolding.weight = R::SMALLEST_WEIGHT;
    },
    [](Options& o) {
      o.target_mode = Options::Target_mode::UNFOLDING, o.unfolding.weight = R::LARGEST_WEIGHT;
    },
    [](Options& o) {
      o.constraints.springs = {{0, 1, 1., R::LARGEST_WEIGHT}};
    },
    [](Options& o) {
      o.constraints.handles = {{0, Eigen::RowVector3d(0, 0, 0), R::SMALLEST_WEIGHT}};
    },
    [](Options& o) {
      o.constraints.symmetric_pairs = {{0, 1, R::LARGEST_WEIGHT}};
    },
    [](Options& o) {
      o.stiffness = Eigen::VectorXd::Constant(Eigen::Index(NUMBER_OF_VERTICES), R::LARGEST_WEIGHT);
      o.stiffness[0] = R::SMALLEST_WEIGHT;
    },
    [](Options& o) {
      o.stiffness = Eigen::VectorXd::Constant(Eigen::Index(NUMBER_OF_VERTICES), R::SMALLEST_WEIGHT);
    },
    [](Options& o) {
      o.matching_weights = Eigen::VectorXd::Constant(Eigen::Index(NUMBER_OF_VERTICES), 1e100);
      o.matching_weights[0] = 1e-100;
    },
    [](Options& o) {
      o.registration.fairing_passes = 1;
      o.registration.fairing_lambda = 1;
      o.registration.fairing_mu = -1;
    }};
  for(std::size_t i = 0; i < ends.size(); ++i)
  {
    SCOPED_TRACE(i);
    Options options;
    options.registration.number_of_iterations = 20;
    ends[i](options);
    EXPECT_TRUE(shapes::pose_of(shapes::small_bar(), options).pose.allFinite());
  }
}

// The steps are given options that the first one has not seen.
TEST(Options_of_the_steps, bad_values_are_refused_by_name)
{
  const shapes::Polygon_soup bar = shapes::small_bar();
  CP::Component_options good;
  good.number_of_landmarks = 6;
  const CP::Prepared_surface_3 prepared
    = CP::prepare_surface(shapes::to_matrix(bar.points), bar.polygons);
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  const CP::Coarse_surface_3 coarse = CP::coarse_surface(surface, good);
  const CP::Landmark_fields_3 fields = CP::landmark_fields(coarse, good);
  const CP::Target_3 target = CP::mds_target(surface, coarse, fields, good);
  const CP::Surface_body_3 body = CP::surface_body(surface, coarse, fields, good);
  Bad_values values = of_method();
  values.erase("mds_kernel"); // not all steps use it
  for(const auto& more : {of_registration(), of_paper_weights()})
    values.insert(more.begin(), more.end());
  for(const auto& [member, bad_values] : values)
    for(const Bad_value& bad : bad_values)
    {
      SCOPED_TRACE(member);
      Options of_call;
      bad.set(of_call);
      CP::Component_options options;
      static_cast<CP::Method_options&>(options) = of_call;
      EXPECT_THROW_WITH(CP::landmark_fields(surface, options), std::invalid_argument, bad.text);
      EXPECT_THROW_WITH(CP::landmark_fields(surface, {0, 1}, options), std::invalid_argument,
                        bad.text);
      EXPECT_THROW_WITH(CP::mds_target(surface, coarse, fields, options), std::invalid_argument,
                        bad.text);
      EXPECT_THROW_WITH(CP::refined_target(surface, coarse, fields, surface.points, options),
                        std::invalid_argument, bad.text);
      EXPECT_THROW_WITH(CP::surface_body(surface, coarse, fields, options), std::invalid_argument,
                        bad.text);
      EXPECT_THROW_WITH(CP::unfolded_target(surface, body, options), std::invalid_argument,
                        bad.text);
      EXPECT_THROW_WITH(CP::registered_pose(surface, coarse, fields, target, body, options),
                        std::invalid_argument, bad.text);
      EXPECT_THROW_WITH(
        CP::geodesic_distances(shapes::to_matrix(bar.points), bar.polygons, {0}, of_call),
        std::invalid_argument, bad.text);
    }
}

// No number of parts is too large: a segmentation has at most as many as faces.
TEST(Options_of_segmentations, every_member)
{
  EXPECT_MEMBERS(names("number_of_parts, random_seed, number_of_threads"), CP::Segmentation_options,
                 number_of_parts, random_seed, number_of_threads);
  const shapes::Polygon_soup bar = shapes::small_bar();
  const CP::Point_matrix points = shapes::to_matrix(bar.points);
  const CP::Point_matrix no_pose(0, 3);
  const std::size_t largest = std::numeric_limits<std::size_t>::max();
  for(const std::size_t number : {largest, largest / 4 + 1})
  {
    CP::Segmentation_options options;
    options.number_of_parts = number;
    options.random_seed = std::numeric_limits<unsigned int>::max();
    for(const auto& segmentation : {CP::consensus_segmentation_tree, CP::sweep_segmentation_tree})
    {
      const CP::Segmentation_tree_3 tree = segmentation(points, bar.polygons, no_pose, options);
      EXPECT_GT(tree.number_of_parts, 1u);
      EXPECT_LE(tree.number_of_parts, bar.polygons.size());
      EXPECT_EQ(tree.parts(number).size(), bar.polygons.size());
    }
  }
  CP::Segmentation_options options;
  options.number_of_parts = largest;
  EXPECT_EQ(CP::k_means_parts(points, bar.polygons, options).size(), bar.polygons.size());
  options.number_of_parts = 2;
  EXPECT_THROW_WITH(
    CP::k_means_parts(points, bar.polygons, options, static_cast<CP::K_means_weights>(2)),
    std::invalid_argument, "option weights is 2");
  options.number_of_threads = -1;
  const std::string text = "option number_of_threads is -1, but must be >= 0";
  EXPECT_THROW_WITH(CP::consensus_segmentation_tree(points, bar.polygons, no_pose, options),
                    std::invalid_argument, text);
  EXPECT_THROW_WITH(CP::sweep_segmentation_tree(points, bar.polygons, no_pose, options),
                    std::invalid_argument, text);
  EXPECT_THROW_WITH(CP::k_means_parts(points, bar.polygons, options), std::invalid_argument, text);
}

TEST(Parameters, bad_values_are_refused_by_name)
{
  const shapes::Triangle_soup bar = shapes::bent_bar();
  const CP::Point_matrix points = shapes::to_matrix(bar.points);
  const Eigen::MatrixXd distances = Eigen::MatrixXd::Ones(points.rows(), 1);
  for(const double value : NO_WEIGHT)
    EXPECT_THROW_WITH(CP::Power_kernel{value}, std::invalid_argument, "option exponent is ");
  for(const double value : {NOT_A_NUMBER, INFINITE, -1e300, 1e300})
    EXPECT_THROW_WITH(CP::Smacof_target_builder_3{value}, std::invalid_argument,
                      "option weight_exponent is ");
  for(const double value : {-1., NOT_A_NUMBER, INFINITE, 1e-320, 1e300})
  {
    EXPECT_THROW_WITH(CP::Smacof_target_builder_3(1., value), std::invalid_argument,
                      "option robust_scale is ");
    EXPECT_THROW_WITH(CP::Lattice_body_3(points, bar.triangles, distances, value),
                      std::invalid_argument, "option lattice_spacing is ");
  }
  for(const int value : {0, -1})
    EXPECT_THROW_WITH(CP::Landmark_mds_target_builder_3<>(CP::Squared_distance_kernel(), value),
                      std::invalid_argument, "option dimension is ");
}

} // namespace test_options
