// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tables and figures of the paper, computed by this package; see the manual's page on them.
//
// How to read: tables in Markdown; numbers of the paper are printed beside ours. Seconds are those of
// the processor, of all threads together.
//
// Usage: paper_benchmark COMMAND [options]
//   noise [--verbose] FILE...    Table 1: poses of the files, whose targets are computed from noisy
//                                surfaces. A noisy surface is the file with each vertex moved along its
//                                normal and in a random direction, by random amounts of up to rho mean
//                                edge lengths each. Hausdorff distance between the pose of the file to
//                                this target and the pose to its own; both targets are scaled such that
//                                the largest distance on their surface is 1, which is the unit.
//   contact [--vertices 10000] [--prefix P]
//                                Figure 10: the articulated figure with a hand merged with the knee.
//   times [FILE...]              Section 8: seconds and peak memory of the one call, on the sitting
//                                articulated figure in the sizes of the paper's meshes, or of files.
//   scalings [--vertices 2000] [--high 53000] [--prefix P]
//                                Figure 1: classical and least squares scaling of all pairs of
//                                vertices, and landmark scaling, for a low and a high resolution. Stress
//                                is that of all pairs, or of all vertices with 500 landmarks.
//   weights [--vertices 10000] [--prefix P]
//                                Figure 3: the paper's weights, literally, for the sitting figure in
//                                centimeters and the body of TetGen.
//   detail [--vertices 10000] [FILE...]
//                                Mean difference of all pairs of poses, mirror images allowed, and
//                                median edge strain for several detail lengths, without and with
//                                rounds: the five named poses of the figure, or files of one shape.
// With --prefix P, meshes are written to files with names P followed by what they are;
// scripts/paper_pictures draws them.

#include "Argument_list.h"
#include "paper_tables.h"
#include "setting.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

int main(int argc, char** argv)
{
  using namespace Canonical_pose_benchmark;
  using Table = void (*)(Argument_list&);
  static const std::map<std::string, Table> tables
    = {{"noise", print_noise_table},     {"contact", print_contact_table},
       {"times", print_times_table},     {"scalings", print_scalings_table},
       {"weights", print_weights_table}, {"detail", print_detail_table}};
  try
  {
    const auto table = argc > 1 ? tables.find(argv[1]) : tables.end();
    if(table == tables.end())
      throw std::invalid_argument("the first argument is noise, contact, times, scalings, weights "
                                  "or detail");
    Argument_list arguments(argc - 1, argv + 1);
    table->second(arguments);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << "paper_benchmark: " << e.what() << '\n';
    return 2;
  }
}
