// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MDS_KERNEL_H
#define CGAL_CANONICAL_POSE_3_MDS_KERNEL_H

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether T is a model of `MdsKernel`.
template <class T, class = void>
struct Is_mds_kernel : std::false_type
{};

template <class T>
struct Is_mds_kernel<T, std::void_t<decltype(std::declval<const T&>().is_centered() ? 1 : 0),
                                    decltype(std::string(std::declval<const T&>().name()))>>
  : std::bool_constant<std::is_copy_constructible<T>::value
                       && std::is_invocable_r<double, const T&, double>::value>
{};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds a kernel of any type, which can thus be chosen at run time.

\cgalModels `MdsKernel`

\sa `Options::mds_kernel`
*/
class Mds_kernel
{
public:
  /// constructs from a kernel.
  /// \tparam Kernel a model of `MdsKernel`
  template <class Kernel,
            std::enable_if_t<std::conjunction<std::negation<std::is_same<Kernel, Mds_kernel>>,
                                              internal::Is_mds_kernel<Kernel>>::value,
                             int> = 0>
  Mds_kernel(Kernel kernel)
    : m_is_centered(kernel.is_centered()), m_name(kernel.name()), m_similarity(std::move(kernel))
  {}

  /// returns the similarity of two points at relative distance \f$ r = g/L \f$.
  double operator()(const double relative_distance) const
  {
    return m_similarity(relative_distance);
  }

  /// returns whether the matrix of similarities is to be centered.
  bool is_centered() const { return m_is_centered; }

  /// returns the name of the kernel.
  const char* name() const { return m_name.c_str(); }

private:
  bool m_is_centered;
  std::string m_name;
  std::function<double(double)> m_similarity;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MDS_KERNEL_H
