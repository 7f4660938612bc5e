// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/Shape_distribution_d2_3.h>
#include <CGAL/Canonical_pose_3/Shape_dna_3.h>
#include <CGAL/Canonical_pose_3/View_descriptor_3.h>
#include <CGAL/Canonical_pose_3/shape_descriptor.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "Polygon_soup.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_descriptors {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Polygon_soup;
using Canonical_pose_test::polygon_soup;
using CP::Point_matrix;
using Kernel = CGAL::Simple_cartesian<double>;
using Polygons = std::vector<std::vector<std::size_t>>;

Polygon_soup ball(const int level)
{
  return polygon_soup(Canonical_pose_test::icosphere_soup(level, 1));
}

// A ball that is stretched, so that no eigenvalue is multiple.
Polygon_soup egg(const int level)
{
  Polygon_soup soup = ball(level);
  soup.points *= Eigen::Vector3d(1, 1.3, 2).asDiagonal();
  return soup;
}

template <class Descriptor>
class Descriptors : public testing::Test
{
public:
  Eigen::VectorXd values(const Polygon_soup& soup) const
  {
    return Descriptor()(soup.points, soup.polygons);
  }
  double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const
  {
    return Descriptor::distances(a, b)[0];
  }
};
using All = testing::Types<CP::Heat_kernel_quantiles_3, CP::Shape_dna_3,
                           CP::Shape_distribution_d2_3, CP::View_descriptor_3>;
TYPED_TEST_SUITE(Descriptors, All);

// All differences are compared with that of two different shapes.
TYPED_TEST(Descriptors, are_invariant)
{
  const Polygon_soup soup = egg(4);
  const Eigen::VectorXd values = this->values(soup);
  ASSERT_EQ(values.size(), static_cast<Eigen::Index>(TypeParam::size()));
  EXPECT_TRUE(values.allFinite());
  const double other = this->distance(values, this->values(ball(4)));
  ASSERT_GT(other, 0);

  Polygon_soup moved = soup;
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for(const double scale : {1e-9, 1., 1e12})
  {
    moved.points
      = scale * ((soup.points * rotation.transpose()).rowwise() + Eigen::RowVector3d(5, -3, 2));
    EXPECT_LT(this->distance(values, this->values(moved)), 1e-3 * other) << scale;
  }

  // Other numbers of vertices and faces.
  Polygon_soup relabeled = soup;
  std::vector<std::size_t> numbers(static_cast<std::size_t>(soup.points.rows()));
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(1));
  for(std::size_t v = 0; v < numbers.size(); ++v)
    relabeled.points.row(static_cast<Eigen::Index>(numbers[v]))
      = soup.points.row(static_cast<Eigen::Index>(v));
  for(std::vector<std::size_t>& polygon : relabeled.polygons)
    for(std::size_t& v : polygon)
      v = numbers[v];
  std::shuffle(relabeled.polygons.begin(), relabeled.polygons.end(), std::mt19937(2));
  EXPECT_LT(this->distance(values, this->values(relabeled)), .1 * other);

  // Four times as many faces.
  EXPECT_LT(this->distance(values, this->values(egg(5))), .1 * other);
}

TYPED_TEST(Descriptors, two_models_of_face_graphs)
{
  const auto soup = Canonical_pose_test::icosphere_soup(2, 1);
  const TypeParam descriptor;
  const Eigen::VectorXd values = CP::shape_descriptor(
    descriptor, Canonical_pose_test::to_mesh<CGAL::Surface_mesh<Kernel::Point_3>>(soup));
  EXPECT_EQ(values, this->values(polygon_soup(soup)));
  EXPECT_EQ(values, CP::shape_descriptor(
                      descriptor, Canonical_pose_test::to_mesh<CGAL::Polyhedron_3<Kernel>>(soup)));
}

// A surface with a hole, a face that is there twice, two components; and a single triangle.
TYPED_TEST(Descriptors, any_surface)
{
  Polygon_soup soup = ball(2);
  const std::size_t n = static_cast<std::size_t>(soup.points.rows());
  const Polygons whole = soup.polygons;
  soup.points.conservativeResize(2 * soup.points.rows(), 3);
  soup.points.bottomRows(soup.points.rows() / 2)
    = soup.points.topRows(soup.points.rows() / 2).rowwise() + Eigen::RowVector3d(3, 0, 0);
  for(const std::vector<std::size_t>& t : whole)
    soup.polygons.push_back({t[0] + n, t[1] + n, t[2] + n});
  soup.polygons.front() = soup.polygons.back();
  EXPECT_TRUE(this->values(soup).allFinite());

  Polygon_soup triangle;
  triangle.points = Point_matrix::Identity(3, 3);
  triangle.polygons = {{0, 1, 2}};
  EXPECT_TRUE(this->values(triangle).allFinite());
}

TYPED_TEST(Descriptors, bad_input)
{
  Polygon_soup soup = ball(1);
  Polygon_soup bad = soup;
  bad.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(this->values(bad), std::invalid_argument);
  bad = soup;
  bad.polygons[2][1] = 1000;
  EXPECT_THROW(this->values(bad), std::invalid_argument);
  bad = soup;
  bad.polygons.clear();
  EXPECT_THROW(this->values(bad), std::invalid_argument);
  bad = soup;
  bad.points.setZero();
  EXPECT_THROW(this->values(bad), std::invalid_argument);
}

// The positive eigenvalues of the unit sphere are l (l + 1), 2 l + 1 times each; its area is 4 pi.
TEST(Shape_dna, of_the_sphere)
{
  const Polygon_soup soup = ball(4);
  const Eigen::VectorXd values = CP::Shape_dna_3()(soup.points, soup.polygons);
  int k = 0;
  for(int l = 1; l <= 4; ++l)
    for(int i = 0; i < 2 * l + 1; ++i, ++k)
      EXPECT_NEAR(values[k], l * (l + 1.) / (k + 1), .01 * values[k]) << k;
}

// The heat kernel is the same at all points of the sphere: all quantiles are equal.
TEST(Heat_kernel_quantiles, of_the_sphere)
{
  const Polygon_soup soup = ball(4);
  const Eigen::VectorXd values = CP::Heat_kernel_quantiles_3()(soup.points, soup.polygons);
  for(Eigen::Index time = 0; time < 16; ++time)
    EXPECT_LT(values[10 * time + 9] - values[10 * time], .02 * values[10 * time]) << time;
}

// Bending a strip without stretching it changes no length on it: the intrinsic descriptors remain,
// D2 does not.
TEST(Intrinsic_descriptors, do_not_change_with_bending)
{
  constexpr std::size_t columns = 120, rows = 20;
  Polygon_soup flat, bent;
  flat.points.resize((columns + 1) * (rows + 1), 3);
  bent.points.resize((columns + 1) * (rows + 1), 3);
  Eigen::Index v = 0;
  for(std::size_t y = 0; y <= rows; ++y)
    for(std::size_t x = 0; x <= columns; ++x, ++v)
    {
      const double s = 6. * double(x) / columns, t = double(y) / rows;
      flat.points.row(v) << s, t, 0;
      bent.points.row(v) << std::sin(s / 2) * 2, t, std::cos(s / 2) * 2;
    }
  for(std::size_t y = 0; y < rows; ++y)
    for(std::size_t x = 0; x < columns; ++x)
    {
      const std::size_t a = y * (columns + 1) + x, b = a + columns + 1;
      flat.polygons.push_back({a, a + 1, b + 1});
      flat.polygons.push_back({a, b + 1, b});
    }
  bent.polygons = flat.polygons;
  const auto change = [&](const auto& descriptor) {
    const Eigen::VectorXd values = descriptor(flat.points, flat.polygons);
    const Polygon_soup other = ball(3);
    return descriptor.distances(values, descriptor(bent.points, bent.polygons))[0]
           / descriptor.distances(values, descriptor(other.points, other.polygons))[0];
  };
  EXPECT_LT(change(CP::Heat_kernel_quantiles_3()), .01);
  EXPECT_LT(change(CP::Shape_dna_3()), .01);
  EXPECT_GT(change(CP::Shape_distribution_d2_3()), .2);
}

// The density of the distance d of two points of the unit sphere is d / 2 up to 2; its mean is 4/3.
TEST(Shape_distribution_d2, of_the_sphere)
{
  const Polygon_soup soup = ball(5);
  const Eigen::VectorXd values = CP::Shape_distribution_d2_3()(soup.points, soup.polygons);
  EXPECT_NEAR(values.sum(), 1, 1e-9);
  double difference = 0;
  for(Eigen::Index i = 0; i < 64; ++i)
  {
    const double from = (std::min)(double(i) / 16, 2.), to = (std::min)(double(i + 1) / 16, 2.);
    difference += std::abs(values[i] - (to * to - from * from) / 4);
  }
  EXPECT_LT(difference, .04);
}

// All depths of the unit sphere are known: sqrt(1 - r^2) at the distance r from the center of the
// image. Its first moment is their mean, (1 + 2/3) / 2; those of odd order are 0.
TEST(View_descriptor, of_the_sphere)
{
  const Polygon_soup soup = ball(5);
  const Eigen::VectorXd values = CP::View_descriptor_3()(soup.points, soup.polygons);
  for(Eigen::Index view = 0; view < 26; ++view)
  {
    EXPECT_NEAR(values[64 * view], 5. / 6, .02);
    EXPECT_LT(values[64 * view + 1], .01); // n = m = 1
  }
}

// A box whose axes are in another order, and a mirrored shape, are the same to the eye.
TEST(View_descriptor, compares_the_best_position)
{
  Polygon_soup soup = ball(4);
  for(Eigen::Index v = 0; v < soup.points.rows(); ++v) // a pear, not symmetric
    soup.points.row(v) *= 1 + .4 * soup.points(v, 0) + .2 * soup.points(v, 1) * soup.points(v, 2);
  const CP::View_descriptor_3 descriptor;
  const Eigen::VectorXd values = descriptor(soup.points, soup.polygons);
  const Polygon_soup other = ball(4);
  Point_matrix mirrored = soup.points;
  mirrored.col(1) *= -1;
  EXPECT_LT(descriptor.distances(values, descriptor(mirrored, soup.polygons))[0],
            .05 * descriptor.distances(values, descriptor(other.points, other.polygons))[0]);
}

// A descriptor of a single number: the height of a surface. An archetype of the concept.
struct Height
{
  static std::string name() { return "height"; }
  static int version() { return 1; }
  static std::size_t size() { return 1; }
  Eigen::VectorXd operator()(const Point_matrix& points, const Polygons&) const
  {
    return Eigen::VectorXd::Constant(1, points.col(2).maxCoeff() - points.col(2).minCoeff());
  }
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.row(0).array() - query[0]).abs().transpose();
  }
};

CP::Descriptor_index_3<Height> index_of(const std::vector<double>& heights)
{
  CP::Descriptor_index_3<Height> index;
  for(const double height : heights)
    index.insert(Eigen::VectorXd::Constant(1, height));
  return index;
}

TEST(Descriptor_index, finds_the_nearest)
{
  const auto index = index_of({5, 1, 3, 3, 8});
  EXPECT_EQ(index.size(), 5u);
  EXPECT_EQ(index.values(4)[0], 8);
  const auto found = index.nearest(Eigen::VectorXd::Constant(1, 3.5), 3);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].shape, 2u);
  EXPECT_EQ(found[1].shape, 3u);
  EXPECT_EQ(found[2].shape, 0u);
  EXPECT_EQ(found[2].distance, 1.5);
  EXPECT_EQ(index.nearest(Eigen::VectorXd::Constant(1, 3.5), 100).size(), 5u);
  const Eigen::MatrixXd all = index.distances();
  EXPECT_EQ(all(0, 4), 3);
  EXPECT_EQ(all, all.transpose());
  EXPECT_EQ(all.diagonal().norm(), 0);
  EXPECT_TRUE(index_of({}).nearest(Eigen::VectorXd::Zero(1), 3).empty());
}

TEST(Descriptor_index, refuses_wrong_values)
{
  auto index = index_of({1});
  EXPECT_THROW(index.insert(Eigen::VectorXd::Zero(2)), std::invalid_argument);
  EXPECT_THROW(index.insert(Eigen::VectorXd::Constant(1, NAN)), std::invalid_argument);
  EXPECT_THROW(index.nearest(Eigen::VectorXd(), 1), std::invalid_argument);
  EXPECT_EQ(index.size(), 1u);
}

// The mean over all pairs of each term is its weight.
TEST(Fused_distances, are_normalized)
{
  const Eigen::MatrixXd a = index_of({0, 1, 2}).distances(), b = index_of({5, 1, 3}).distances();
  const Eigen::MatrixXd fused = CP::fused_distances({a, 100 * b}, {1, 2});
  EXPECT_NEAR(fused.sum() / 6, 3, 1e-12);
  EXPECT_NEAR(fused(0, 1), 1 / (4. / 3) + 2 * 4 / (8. / 3), 1e-12);
  EXPECT_THROW(CP::fused_distances({}), std::invalid_argument);
  EXPECT_THROW(CP::fused_distances({a}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(CP::fused_distances({a}, {0}), std::invalid_argument);
  EXPECT_THROW(CP::fused_distances({a, a.topLeftCorner(2, 2)}), std::invalid_argument);
}

// Ten shapes in a row at distances of 1, and five at distances of 1 that are 3 beyond the first one:
// all of the row are nearer to the first one than any of the others, since there is a path.
TEST(Manifold_ranking, follows_paths)
{
  std::vector<double> heights;
  for(int i = 0; i < 10; ++i)
    heights.push_back(i);
  for(int i = 0; i < 5; ++i)
    heights.push_back(-3 - i);
  const Eigen::MatrixXd distances = index_of(heights).distances();
  ASSERT_LT(distances(0, 10), distances(0, 9));
  const Eigen::MatrixXd ranking = CP::manifold_ranking(distances, 2);
  EXPECT_GT(ranking.row(0).tail(5).minCoeff(), ranking.row(0).head(10).maxCoeff());
  EXPECT_EQ(CP::manifold_ranking(Eigen::MatrixXd(0, 0)).size(), 0);
  EXPECT_EQ(CP::manifold_ranking(Eigen::MatrixXd::Zero(1, 1)).rows(), 1);
  EXPECT_THROW(CP::manifold_ranking(distances, 0), std::invalid_argument);
  EXPECT_THROW(CP::manifold_ranking(Eigen::MatrixXd(2, 3)), std::invalid_argument);
}

} // namespace test_descriptors
