// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TABLES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TABLES_H

#include "Stance_trial.h"
#include "limb_measures.h"
#include "median.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <map>
#include <numeric>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

/// The trials of a class and a stance, or of a stance.
using Trials = std::vector<const Stance_trial*>;

inline double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

inline double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/// Over the postures of a shape. All vectors have one element per trial, or none if vertices do not
/// correspond.
struct Consistency
{
  double stance = 0, pose = 0;      // mean differences over all pairs
  double ratio_of_lengths = 0;      // of stances to poses, if differences are lengths
  std::vector<double> to_others;    // mean difference of a stance from the others
  std::vector<double> shares_alike; // of the vertices that follow the same limb as in most postures

  explicit Consistency(const Trials& trials)
  {
    if(trials.size() < 2
       || std::any_of(trials.begin(), trials.end(), [&](const Stance_trial* trial) {
            return trial->pose.rows() != trials.front()->pose.rows();
          }))
      return;
    set_differences(trials);
    set_shares(trials);
  }

private:
  // Relative to the root of the area of the input.
  static double radius_of_gyration(const Point_matrix& points, const double root_of_area)
  {
    const Eigen::RowVector3d mean = points.colwise().mean();
    return std::sqrt((points.rowwise() - mean).rowwise().squaredNorm().mean()) / root_of_area;
  }

  void set_differences(const Trials& trials)
  {
    using CGAL::Canonical_pose_3::pose_difference;
    const auto number = static_cast<double>(trials.size());
    to_others.resize(trials.size());
    double length_of_stances = 0, length_of_poses = 0;
    std::vector<double> radii, radii_of_poses;
    for(const Stance_trial* trial : trials)
    {
      radii.push_back(radius_of_gyration(trial->pose, trial->mesh->root_of_area));
      radii_of_poses.push_back(radius_of_gyration(trial->mesh->pose, trial->mesh->root_of_area));
    }
    for(std::size_t i = 0; i < trials.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
      {
        const double difference = pose_difference(trials[i]->pose, trials[j]->pose),
                     difference_of_poses
                     = pose_difference(trials[i]->mesh->pose, trials[j]->mesh->pose);
        for(const std::size_t k : {i, j})
          to_others[k] += difference / (number - 1);
        pose += 2 * difference_of_poses / (number * (number - 1));
        length_of_stances += (radii[i] + radii[j]) * difference;
        length_of_poses += (radii_of_poses[i] + radii_of_poses[j]) * difference_of_poses;
      }
    stance = mean(to_others);
    ratio_of_lengths = length_of_stances / length_of_poses;
  }

  void set_shares(const Trials& trials)
  {
    const std::size_t n = trials.front()->limbs_of_vertices.size();
    std::vector<std::size_t> alike(trials.size());
    for(std::size_t v = 0; v < n; ++v)
    {
      std::array<std::size_t, 7> numbers = {};
      for(const Stance_trial* trial : trials)
        ++numbers[trial->limbs_of_vertices[v]];
      const auto usual = static_cast<std::size_t>(std::max_element(numbers.begin(), numbers.end())
                                                  - numbers.begin());
      for(std::size_t i = 0; i < trials.size(); ++i)
        alike[i] += trials[i]->limbs_of_vertices[v] == usual;
    }
    for(const std::size_t number : alike)
      shares_alike.push_back(static_cast<double>(number) / static_cast<double>(n));
  }
};

struct Differences
{
  std::vector<double> stances, poses, ratios_of_lengths, names;
};

inline void print_header_of_classes()
{
  std::printf("\n%-22s%-11s%7s%6s%8s%7s%7s%7s%8s%8s%7s%8s%7s%8s%8s%9s%8s%8s%7s%8s%7s%9s%7s%7s\n",
              "class", "stance", "meshes", "found", "refused", "failed", "arms", "legs", "largest",
              "within", "bend", "largest", "l-r", "strain", "largest", "inverted", "stance", "pose",
              "ratio", "lengths", "alike", "seconds", "pose", "ratio");
}

/// \param found those of them that have a stance.
inline void print_row(const std::string& class_name, const Trials& all, const Trials& found,
                      const Differences& differences)
{
  const auto number_of = [&](const Stance_trial::Outcome outcome) {
    return std::count_if(all.begin(), all.end(),
                         [=](const Stance_trial* trial) { return trial->outcome == outcome; });
  };
  std::printf("%-22s%-11s%7zu%6td%8td%7td", class_name.c_str(), name(all.front()->stance),
              all.size(), number_of(Stance_trial::FOUND), number_of(Stance_trial::REFUSED),
              number_of(Stance_trial::FAILED));
  if(found.empty())
  {
    std::printf("\n");
    return;
  }
  constexpr double largest_angle = 5;
  std::vector<double> arms, legs, bends, asymmetries, strains, seconds, seconds_of_poses, ratios;
  std::size_t inverted = 0;
  for(const Stance_trial* trial : found)
  {
    const Limb_measures& limbs = trial->limbs;
    arms.insert(arms.end(), limbs.angles.begin(), limbs.angles.begin() + 2);
    legs.insert(legs.end(), limbs.angles.begin() + 2, limbs.angles.end());
    bends.insert(bends.end(), limbs.bends.begin(), limbs.bends.end());
    asymmetries.push_back(limbs.asymmetry);
    strains.push_back(trial->strain);
    inverted += trial->inverted;
    seconds.push_back(trial->seconds);
    seconds_of_poses.push_back(trial->mesh->seconds);
    ratios.push_back(trial->seconds / trial->mesh->seconds);
  }
  std::vector<double> angles = arms;
  angles.insert(angles.end(), legs.begin(), legs.end());
  const auto within = std::count_if(angles.begin(), angles.end(),
                                    [](const double angle) { return angle <= largest_angle; });
  std::printf("%7.1f%7.1f%8.1f%8.2f%7.1f%8.1f%7.2f%8.4f%8.4f%9zu", mean(arms), mean(legs),
              largest(angles), static_cast<double>(within) / static_cast<double>(angles.size()),
              mean(bends), largest(bends), 100 * mean(asymmetries), median(strains),
              largest(strains), inverted);
  if(differences.stances.empty())
    std::printf("%8s%8s%7s%8s%7s", "-", "-", "-", "-", "-");
  else
    std::printf("%8.4f%8.4f%7.2f%8.2f%7.3f", mean(differences.stances), mean(differences.poses),
                mean(differences.stances) / mean(differences.poses),
                mean(differences.ratios_of_lengths), mean(differences.names));
  std::printf("%9.2f%7.2f%7.2f\n", median(seconds), median(seconds_of_poses), median(ratios));
}

/// Prints the lines of classes, and what is to be said about single meshes.
class Stance_tables
{
public:
  explicit Stance_tables(const std::vector<Stance_trial>& trials) : m_trials(trials) {}

  void print() const
  {
    print_header_of_classes();
    std::vector<std::string> notes;
    for(const auto& [stance_name, stance] : STANCES)
    {
      const Trials all = chosen([s = stance](const Stance_trial& t) { return t.stance == s; });
      if(!all.empty())
        print_classes(all, notes);
    }
    std::printf("\n");
    for(const std::string& note : notes)
      std::printf("%s\n", note.c_str());
    print_reasons();
  }

private:
  template <class Predicate>
  Trials chosen(const Predicate& predicate) const
  {
    Trials result;
    for(const Stance_trial& trial : m_trials)
      if(predicate(trial))
        result.push_back(&trial);
    return result;
  }

  static Trials found_ones(const Trials& trials)
  {
    Trials result;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(result),
                 [](const Stance_trial* trial) { return trial->outcome == Stance_trial::FOUND; });
    return result;
  }

  // `all`: of a stance.
  static void print_classes(const Trials& all, std::vector<std::string>& notes)
  {
    std::vector<std::string> names;
    std::map<std::string, Trials> classes;
    for(const Stance_trial* trial : all)
    {
      Trials& members = classes[trial->mesh->class_name];
      if(members.empty())
        names.push_back(trial->mesh->class_name);
      members.push_back(trial);
    }
    Differences of_classes;
    for(const std::string& class_name : names)
    {
      const Trials found = found_ones(classes.at(class_name));
      const Consistency consistency(found);
      Differences differences;
      if(!consistency.to_others.empty())
      {
        differences = {{consistency.stance},
                       {consistency.pose},
                       {consistency.ratio_of_lengths},
                       {mean(consistency.shares_alike)}};
        of_classes.stances.push_back(consistency.stance);
        of_classes.poses.push_back(consistency.pose);
        of_classes.ratios_of_lengths.push_back(consistency.ratio_of_lengths);
        of_classes.names.push_back(mean(consistency.shares_alike));
      }
      print_row(class_name, classes.at(class_name), found, differences);
      if(!found.empty())
        note_worst(found, consistency, notes);
    }
    if(names.size() > 1)
      print_row("all", all, found_ones(all), of_classes);
  }

  static void note_worst(const Trials& found, const Consistency& consistency,
                         std::vector<std::string>& notes)
  {
    constexpr double least_share_alike = .8;
    const Stance stance = found.front()->stance;
    const std::string of = " of " + found.front()->mesh->class_name + ", " + name(stance) + ": ";
    const auto note = [&](const char* const what, const std::size_t trial, const std::string& rest,
                          const double value) {
      char text[32];
      std::snprintf(text, sizeof(text), ", %.3g", value);
      notes.push_back(what + of + found[trial]->mesh->name + rest + text);
    };
    const auto note_limb
      = [&](const char* const what,
            const std::array<double, number_of_limbs> Limb_measures::*const values) {
          std::array<std::size_t, 2> worst = {0, 0};
          for(std::size_t i = 0; i < found.size(); ++i)
            for(std::size_t k = 0; k < number_of_limbs; ++k)
              if((found[i]->limbs.*values)[k] > (found[worst[0]]->limbs.*values)[worst[1]])
                worst = {i, k};
          note(what, worst[0], std::string(", ") + name_of_limb(worst[1], stance),
               (found[worst[0]]->limbs.*values)[worst[1]]);
        };
    note_limb("largest angle", &Limb_measures::angles);
    note_limb("largest bend", &Limb_measures::bends);
    const std::vector<double>& to_others = consistency.to_others;
    if(!to_others.empty())
    {
      const auto farthest = std::max_element(to_others.begin(), to_others.end());
      note("largest mean difference from the other postures",
           static_cast<std::size_t>(farthest - to_others.begin()), "", *farthest);
    }
    for(std::size_t i = 0; i < consistency.shares_alike.size(); ++i)
      if(consistency.shares_alike[i] < least_share_alike)
        note("other limbs than in most postures", i, ", share alike", consistency.shares_alike[i]);
  }

  // Equal ones meet: without numbers, of warnings without their details.
  void print_reasons() const
  {
    std::map<std::string, std::vector<std::string>> meshes;
    for(const Stance_trial& trial : m_trials)
    {
      if(trial.outcome != Stance_trial::FOUND)
        meshes[name(trial.stance) + std::string(", ") + name(trial.outcome) + ": "
               + std::regex_replace(trial.reason, std::regex("[0-9.]*[0-9]"), "#")]
          .push_back(trial.mesh->name);
      for(const std::string& warning : trial.warnings)
        meshes[name(trial.stance) + std::string(", warning: ")
               + warning.substr(0, warning.find(':'))]
          .push_back(trial.mesh->name);
    }
    for(const auto& [reason, names] : meshes)
      std::printf("%5zu %s (%s%s)\n", names.size(), reason.c_str(), names.front().c_str(),
                  names.size() > 1 ? ", ..." : "");
  }

  const std::vector<Stance_trial>& m_trials;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TABLES_H
