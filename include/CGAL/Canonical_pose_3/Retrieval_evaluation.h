// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_RETRIEVAL_EVALUATION_H
#define CGAL_CANONICAL_POSE_3_RETRIEVAL_EVALUATION_H

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief tells how well the answers to a query agree with classes of shapes.

The measures are those of P. Shilane et al., "The Princeton shape benchmark", 2004. All are between 0 and
1, and 1 is perfect, except that the e-measure of a class with fewer or more than 32 other shapes is below 1.
A shape is a query to all others; \f$ c \f$ is the number of the others that are of its class.
*/
struct Retrieval_measures
{
  /// share of nearest shapes that are of the class.
  double nearest_neighbor = 0;
  /// share of the class among the first \f$ c \f$ answers.
  double first_tier = 0;
  /// share of the class that is among the first \f$ 2c \f$ answers.
  double second_tier = 0;
  /// harmonic mean of precision and recall of the first 32 answers.
  double e_measure = 0;
  /// discounted cumulative gain, divided by its maximum.
  double discounted_cumulative_gain = 0;
  /// mean of the precision at each shape of the class.
  double average_precision = 0;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief evaluates answers to queries if the classes of the shapes are known.

Shapes that are alone in their class are answers, but no queries.
*/
class Retrieval_evaluation
{
public:
  /// number of intervals of the precision-recall curve.
  static constexpr std::size_t number_of_recall_intervals = 20;

  /*!
  sorts the answers to each query, by increasing dissimilarity; of equal ones, that with the smaller
  number comes first.

  \param dissimilarities \f$ n \times n \f$, such as shape distances; row \f$ i \f$ belongs to query \f$ i \f$. See
         `Descriptor_index_3::distances()`, `fused_distances()`, `manifold_ranking()`.
  \param classes the class of each shape, a number.

  \throws std::invalid_argument if the matrix is not square, an entry is not a number, the number of
          classes is not that of shapes, or no two shapes are of the same class.

  <em>Complexity:</em> \f$ O(n^2 \log n) \f$.
  */
  Retrieval_evaluation(const Eigen::MatrixXd& dissimilarities, std::vector<std::size_t> classes)
    : m_classes(std::move(classes)), m_measures(m_classes.size()), m_is_query(m_classes.size()),
      m_nearest(m_classes.size()), m_precision(number_of_recall_intervals, 0)
  {
    const std::size_t n = m_classes.size();
    if(dissimilarities.rows() != dissimilarities.cols())
      throw std::invalid_argument("the matrix of dissimilarities is not square");
    if(dissimilarities.rows() != static_cast<Eigen::Index>(n))
      throw std::invalid_argument("there are " + std::to_string(n) + " classes, but "
                                  + std::to_string(dissimilarities.rows()) + " shapes");
    for(Eigen::Index j = 0; j < dissimilarities.cols(); ++j)
      for(Eigen::Index i = 0; i < dissimilarities.rows(); ++i)
        if(std::isnan(dissimilarities(i, j)))
          throw std::invalid_argument("a dissimilarity is not a number: that of shape "
                                      + std::to_string(j) + " from query " + std::to_string(i));
    for(std::size_t i = 0; i < n; ++i)
      evaluate(i, answers_to(dissimilarities, i));
    const auto number_of_queries = std::count(m_is_query.begin(), m_is_query.end(), true);
    if(number_of_queries == 0)
      throw std::invalid_argument("no two shapes are of the same class");
    for(double& precision : m_precision)
      precision /= static_cast<double>(number_of_queries);
  }

  /// returns whether other shapes are of the same class.
  /// \pre `shape` is the number of a shape.
  bool is_query(const std::size_t shape) const
  {
    CGAL_precondition(shape < m_classes.size());
    return m_is_query[shape];
  }

  /// returns the measures of a query.
  /// \pre `is_query(query)`
  const Retrieval_measures& measures(const std::size_t query) const
  {
    CGAL_precondition(is_query(query));
    return m_measures[query];
  }

  /// returns the means over all queries.
  Retrieval_measures mean() const
  {
    return mean_if([](std::size_t) { return true; });
  }

  /// returns the means over the queries of a class.
  /// \pre At least two shapes are of the class.
  Retrieval_measures mean_of_class(const std::size_t number) const
  {
    CGAL_precondition(std::count(m_classes.begin(), m_classes.end(), number) > 1);
    return mean_if([&](const std::size_t i) { return m_classes[i] == number; });
  }

  /// returns the precision at the recalls \f$ 1/20, 2/20, \ldots, 1 \f$, the mean over all queries. The
  /// precision at a recall is the largest one at this or a larger recall.
  const std::vector<double>& precision() const { return m_precision; }

  /// returns how many queries of a class have their nearest shape in another (or the same) class.
  std::size_t confusion(const std::size_t class_of_query, const std::size_t class_of_nearest) const
  {
    std::size_t result = 0;
    for(std::size_t i = 0; i < m_classes.size(); ++i)
      if(m_is_query[i] && m_classes[i] == class_of_query
         && m_classes[m_nearest[i]] == class_of_nearest)
        ++result;
    return result;
  }

private:
  static std::vector<std::size_t> answers_to(const Eigen::MatrixXd& dissimilarities,
                                             const std::size_t query)
  {
    std::vector<std::size_t> result(static_cast<std::size_t>(dissimilarities.rows()));
    std::iota(result.begin(), result.end(), std::size_t(0));
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(query));
    const auto row = dissimilarities.row(static_cast<Eigen::Index>(query));
    std::stable_sort(result.begin(), result.end(), [&](const std::size_t a, const std::size_t b) {
      return row[static_cast<Eigen::Index>(a)] < row[static_cast<Eigen::Index>(b)];
    });
    return result;
  }

  void evaluate(const std::size_t query, const std::vector<std::size_t>& answers)
  {
    // Positions, from 1, of the shapes of the class.
    std::vector<std::size_t> positions;
    for(std::size_t i = 0; i < answers.size(); ++i)
      if(m_classes[answers[i]] == m_classes[query])
        positions.push_back(i + 1);
    m_is_query[query] = !positions.empty();
    if(positions.empty())
      return;
    m_nearest[query] = answers.front();
    const std::size_t c = positions.size();
    const auto number_until = [&](const std::size_t last) {
      return static_cast<double>(std::upper_bound(positions.begin(), positions.end(), last)
                                 - positions.begin());
    };
    const auto gain = [](const std::size_t position) {
      return position == 1 ? 1 : 1 / std::log2(static_cast<double>(position));
    };
    Retrieval_measures& m = m_measures[query];
    constexpr std::size_t length_of_first_page = 32;
    const auto number = static_cast<double>(c);
    m.nearest_neighbor = positions.front() == 1 ? 1 : 0;
    m.first_tier = number_until(c) / number;
    m.second_tier = number_until(2 * c) / number;
    m.e_measure = 2 * number_until(length_of_first_page)
                  / (static_cast<double>(length_of_first_page) + number);
    double ideal_gain = 0;
    std::vector<double> precision(c);
    for(std::size_t i = 0; i < c; ++i)
    {
      m.discounted_cumulative_gain += gain(positions[i]);
      ideal_gain += gain(i + 1);
      precision[i] = static_cast<double>(i + 1) / static_cast<double>(positions[i]);
      m.average_precision += precision[i] / number;
    }
    m.discounted_cumulative_gain /= ideal_gain;
    for(std::size_t i = c - 1; i-- > 0;)
      precision[i] = (std::max)(precision[i], precision[i + 1]);
    for(std::size_t r = 1; r <= number_of_recall_intervals; ++r)
    {
      const std::size_t retrieved
        = (r * c + number_of_recall_intervals - 1) / number_of_recall_intervals;
      m_precision[r - 1] += precision[retrieved - 1];
    }
  }

  template <class Predicate>
  Retrieval_measures mean_if(const Predicate& is_wanted) const
  {
    Retrieval_measures sum;
    double number = 0;
    for(std::size_t i = 0; i < m_classes.size(); ++i)
      if(m_is_query[i] && is_wanted(i))
      {
        ++number;
        for(const auto member : members())
          sum.*member += m_measures[i].*member;
      }
    for(const auto member : members())
      sum.*member /= number;
    return sum;
  }

  static std::vector<double Retrieval_measures::*> members()
  {
    using M = Retrieval_measures;
    return {&M::nearest_neighbor, &M::first_tier,        &M::second_tier,
            &M::e_measure,        &M::average_precision, &M::discounted_cumulative_gain};
  }

  std::vector<std::size_t> m_classes;
  std::vector<Retrieval_measures> m_measures;
  std::vector<bool> m_is_query;
  std::vector<std::size_t> m_nearest;
  std::vector<double> m_precision;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_RETRIEVAL_EVALUATION_H
