// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TABLES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TABLES_H

#include "Stance_trial.h"
#include "limb_measures.h"
#include "mean_difference.h"
#include "median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
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

/// Over the postures of a shape.
struct Consistency
{
  double stance = std::numeric_limits<double>::quiet_NaN(), pose = stance;
  std::vector<double> names; // one per trial, if vertices correspond

  explicit Consistency(const Trials& trials)
  {
    std::vector<Point_matrix> stances, poses;
    for(const Stance_trial* trial : trials)
    {
      stances.push_back(trial->pose);
      poses.push_back(trial->mesh->pose);
    }
    stance = mean_difference(stances);
    pose = mean_difference(poses);
    if(std::isfinite(stance))
      set_names(trials);
  }

private:
  void set_names(const Trials& trials)
  {
    const std::size_t n = trials.front()->limbs_of_vertices.size();
    names.resize(trials.size());
    for(std::size_t v = 0; v < n; ++v)
    {
      std::array<std::size_t, 7> numbers = {};
      for(const Stance_trial* trial : trials)
        ++numbers[trial->limbs_of_vertices[v]];
      const auto usual = static_cast<std::size_t>(std::max_element(numbers.begin(), numbers.end())
                                                  - numbers.begin());
      for(std::size_t i = 0; i < trials.size(); ++i)
        names[i] += (trials[i]->limbs_of_vertices[v] == usual ? 1. : 0.) / static_cast<double>(n);
    }
  }
};

struct Differences
{
  std::vector<double> stances, poses, names;
};

inline void print_header_of_classes()
{
  std::printf("\n%-22s%-11s%7s%6s%8s%7s%7s%7s%8s%8s%7s%8s%7s%8s%8s%9s%8s%8s%7s%7s%9s%7s%7s\n",
              "class", "stance", "meshes", "found", "refused", "failed", "arms", "legs", "largest",
              "within", "bend", "largest", "l-r", "strain", "largest", "inverted", "stance", "pose",
              "ratio", "names", "seconds", "pose", "ratio");
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
    std::printf("%8s%8s%7s%7s", "-", "-", "-", "-");
  else
    std::printf("%8.4f%8.4f%7.2f%7.3f", mean(differences.stances), mean(differences.poses),
                mean(differences.stances) / mean(differences.poses), mean(differences.names));
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
    constexpr double least_share_of_names = .8;
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
      if(!consistency.names.empty())
      {
        differences = {{consistency.stance}, {consistency.pose}, {mean(consistency.names)}};
        of_classes.stances.push_back(consistency.stance);
        of_classes.poses.push_back(consistency.pose);
        of_classes.names.push_back(mean(consistency.names));
      }
      print_row(class_name, classes.at(class_name), found, differences);
      note_worst_limb(found, notes);
      for(std::size_t i = 0; i < consistency.names.size(); ++i)
        if(consistency.names[i] < least_share_of_names)
          notes.push_back("other names of limbs than in most postures: " + found[i]->mesh->name
                          + ", " + name(found[i]->stance) + ", "
                          + std::to_string(std::lround(100 * (1 - consistency.names[i])))
                          + " % of the vertices");
    }
    if(names.size() > 1)
      print_row("all", all, found_ones(all), of_classes);
  }

  static void note_worst_limb(const Trials& found, std::vector<std::string>& notes)
  {
    if(found.empty())
      return;
    const Stance_trial& worst
      = **std::max_element(found.begin(), found.end(), [](const auto* a, const auto* b) {
          return a->limbs.angles[a->worst_limb()] < b->limbs.angles[b->worst_limb()];
        });
    char angle[32];
    std::snprintf(angle, sizeof(angle), "%.1f", worst.limbs.angles[worst.worst_limb()]);
    notes.push_back("worst limb of " + worst.mesh->class_name + ", " + name(worst.stance) + ": "
                    + worst.mesh->name + ", " + name_of_limb(worst.worst_limb(), worst.stance)
                    + " by " + angle + " degrees");
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
