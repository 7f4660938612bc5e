// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Landmark multidimensional scaling of arbitrary distances: given their great-circle distances to
// eight of them, cities of the world are embedded on a globe again (too large, since arcs are
// longer than chords).

#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;

struct City
{
  const char* name;
  double latitude, longitude; // degrees
};

const std::vector<City> CITIES
  = {{"Anchorage", 61.2, -149.9}, {"Nairobi", -1.3, 36.8},    {"Sydney", -33.9, 151.2},
     {"Lima", -12.0, -77.0},      {"Tokyo", 35.7, 139.7},     {"Reykjavik", 64.1, -21.9},
     {"Cape Town", -33.9, 18.4},  {"Honolulu", 21.3, -157.9}, // the landmarks, up to here
     {"Istanbul", 41.0, 29.0},    {"Delhi", 28.6, 77.2},      {"Paris", 48.9, 2.4},
     {"New York", 40.7, -74.0},   {"Jakarta", -6.2, 106.8},   {"Buenos Aires", -34.6, -58.4}};

double great_circle(const City& a, const City& b) // km
{
  const double degree = 3.14159265358979323846 / 180, radius = 6371;
  const double cosine = std::sin(degree * a.latitude) * std::sin(degree * b.latitude)
                        + std::cos(degree * a.latitude) * std::cos(degree * b.latitude)
                            * std::cos(degree * (a.longitude - b.longitude));
  return radius * std::acos(std::fmax(-1., std::fmin(1., cosine)));
}

int main()
{
  CP::Landmark_fields_3 fields;
  fields.distances.resize(CITIES.size(), 8);
  for(std::size_t j = 0; j < 8; ++j)
  {
    fields.landmarks.push_back(j);
    for(std::size_t i = 0; i < CITIES.size(); ++i)
      fields.distances(i, j) = great_circle(CITIES[i], CITIES[j]);
  }

  CP::Landmark_mds_target_builder_3<> builder; // three dimensions, classical scaling
  builder.build(fields);
  for(std::size_t i = 0; i < CITIES.size(); ++i)
    std::cout << CITIES[i].name << ": " << builder.targets().row(i) << " km\n";
  std::cout << "stress " << builder.stress() << '\n';
  return builder.stress() < 0.2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
