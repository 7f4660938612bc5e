// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Command_line.h"
#include "option_values.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Arguments that are converted to options of the library.
struct Raw_arguments
{
  std::string kernel = "classical", components = "auto", solver = "auto", frame = "input",
              target_mode = "mds", contacts = "keep", paper_weights, parts = "auto";
  std::vector<std::string> springs, directions, handles, symmetric_pairs;
};

using CGAL::Canonical_pose_3::Registration_options;

// Splits "1,2,0.5" at the commas; there must be from `least` to `most` numbers.
std::vector<std::string> words(const std::string& option, const std::string& text,
                               const std::size_t least, const std::size_t most)
{
  std::vector<std::string> result;
  for(std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find(',', begin);
    result.push_back(text.substr(begin, end - begin));
    if(!real_of(result.back()))
      throw CLI::ValidationError(option, "'" + text
                                           + "' is not a list of numbers with commas between them");
  }
  if(result.size() < least || result.size() > most)
    throw CLI::ValidationError(option, "'" + text + "' has a wrong number of values");
  return result;
}

std::string shown(const double number)
{
  std::ostringstream out;
  out << number;
  return out.str();
}

// Defines a constraint: vertices, then numbers, then optionally a stiffness.
struct Constraint_values
{
  Constraint_values(const std::string& option, const std::string& text,
                    const std::size_t number_of_vertices, const std::size_t number_of_numbers)
  {
    const std::size_t n = number_of_vertices + number_of_numbers;
    const std::vector<std::string> all = words(option, text, n, n + 1);
    for(std::size_t i = 0; i < number_of_vertices; ++i)
    {
      const auto vertex = count_of<std::size_t>(all[i]);
      if(!vertex)
        throw CLI::ValidationError(
          option, "'" + text + "' does not begin with "
                    + (number_of_vertices == 2 ? "two vertex numbers" : "a vertex number"));
      vertices.push_back(*vertex);
    }
    for(std::size_t i = number_of_vertices; i < n; ++i)
      rest.push_back(*real_of(all[i]));
    if(all.size() > n)
      stiffness = *real_of(all.back());
    constexpr double least = Registration_options::SMALLEST_WEIGHT,
                     largest = Registration_options::LARGEST_WEIGHT;
    if(stiffness < least || stiffness > largest)
      throw CLI::ValidationError(option, "'" + text + "' has a stiffness that is not from "
                                           + shown(least) + " to " + shown(largest));
  }

  Eigen::RowVector3d vector() const { return {rest[0], rest[1], rest[2]}; }

  std::vector<std::size_t> vertices;
  std::vector<double> rest;
  double stiffness = 1;
};

void take_constraints(const Raw_arguments& raw, Options& options)
{
  for(const std::string& text : raw.springs)
  {
    const Constraint_values v("--spring", text, 2, 1);
    options.constraints.springs.push_back({v.vertices[0], v.vertices[1], v.rest[0], v.stiffness});
  }
  for(const std::string& text : raw.directions)
  {
    const Constraint_values v("--direction", text, 2, 3);
    options.constraints.directions.push_back(
      {v.vertices[0], v.vertices[1], v.vector(), v.stiffness});
  }
  for(const std::string& text : raw.handles)
  {
    const Constraint_values v("--handle", text, 1, 3);
    options.constraints.handles.push_back({v.vertices[0], v.vector(), v.stiffness});
  }
  for(const std::string& text : raw.symmetric_pairs)
  {
    const Constraint_values v("--symmetric", text, 2, 0);
    options.constraints.symmetric_pairs.push_back({v.vertices[0], v.vertices[1], v.stiffness});
  }
}

// The type of the option must be `Integer`.
template <class Integer>
CLI::Validator integer(const Integer least)
{
  const std::string name = least > 0 ? "POSITIVE" : "NONNEGATIVE";
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<Integer> value = count_of<Integer>(text);
      if(!value || *value < least)
        return "'" + text + "' is not an integer from " + std::to_string(least) + " to "
               + std::to_string((std::numeric_limits<Integer>::max)());
      text = std::to_string(*value); // leading zeros would mean octal numbers
      return std::string();
    },
    name, name);
}

CLI::Validator number(const double least, const double largest)
{
  const std::string name = least > 0 ? "POSITIVE" : "NONNEGATIVE";
  return CLI::Validator(
    [=](const std::string& text) {
      const std::optional<double> value = real_of(text);
      return value && *value >= least && *value <= largest
               ? std::string()
               : "'" + text + "' is not a number from " + shown(least) + " to " + shown(largest);
    },
    name, name);
}

// An empty path, for example from an unset shell variable, is not the same as a missing option.
CLI::Validator path()
{
  return CLI::Validator(
    [](const std::string& text) { return text.empty() ? "the path is empty" : std::string(); },
    "PATH");
}

void add_input(CLI::App& command, Arguments& arguments)
{
  command
    .add_option("INPUT", arguments.input,
                "surface (.off, .obj, .ply, .stl, .glb, .gltf) or tetrahedral mesh (MEDIT, .mesh)")
    ->required();
}

void add_report(CLI::App& command, Arguments& arguments)
{
  command.add_option("--report", arguments.report, "write a report (JSON), too")->check(path());
}

void add_common(CLI::App& command, Arguments& arguments)
{
  command.add_option("--geodesics", arguments.geodesics, "distances: heat, wavefront, exact")
    ->check(CLI::IsMember({"heat", "wavefront", "exact"}))
    ->capture_default_str();
  command
    .add_option("--threads", arguments.options.number_of_threads,
                "at most so many threads; 0: as many as there are")
    ->transform(integer(0))
    ->capture_default_str();
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

void add_constraints(CLI::App& command, Raw_arguments& raw)
{
  command
    .add_option("--spring", raw.springs,
                "I,J,LENGTH[,STIFFNESS]: a spring between two vertices; may be repeated")
    ->allow_extra_args(false);
  command
    .add_option("--direction", raw.directions,
                "I,J,X,Y,Z[,STIFFNESS]: the vector to one vertex from another; may be repeated")
    ->allow_extra_args(false);
  command
    .add_option("--handle", raw.handles,
                "I,X,Y,Z[,STIFFNESS]: the position of a vertex; may be repeated")
    ->allow_extra_args(false);
  command
    .add_option("--symmetric", raw.symmetric_pairs,
                "I,J[,STIFFNESS]: two vertices that mirror each other; may be repeated")
    ->allow_extra_args(false);
}

// The options of `pose` that `segment` and `describe` have as well.
void add_pose_options(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  Options& options = arguments.options;
  command
    .add_option("--body", arguments.body,
                "elastic body inside a surface: auto, lattice, tetgen, mesh")
    ->check(CLI::IsMember({"auto", "lattice", "tetgen", "mesh"}))
    ->capture_default_str();
  command
    .add_option("--spacing", options.lattice_spacing,
                "spacing of the lattice by the largest distance")
    ->check(number(Options::SMALLEST_LATTICE_SPACING, 1));
  command
    .add_option("--target-mode", raw.target_mode,
                "target by scaling of distances, or by moving vertices away from each other, which "
                "needs none: mds, unfold")
    ->check(CLI::IsMember({"mds", "unfold"}))
    ->capture_default_str();
  command
    .add_option("--kernel", raw.kernel,
                "kernel of the target: classical, gaussian, gaussian-uncentred")
    ->check(CLI::IsMember({"classical", "gaussian", "gaussian-uncentred"}))
    ->capture_default_str();
  command.add_option("--landmarks", options.number_of_landmarks, "number of landmarks")
    ->transform(integer(std::size_t(1)))
    ->capture_default_str();
  command
    .add_option("--detail-length", options.registration.detail_length,
                "details smaller than this keep their shape; by the largest distance")
    ->check(number(Registration_options::SMALLEST_DETAIL_LENGTH,
                   Registration_options::LARGEST_DETAIL_LENGTH))
    ->capture_default_str();
  command
    .add_option("--tikhonov", options.registration.tikhonov,
                "weight that holds an iteration near the one before")
    ->check(number(0, Registration_options::LARGEST_WEIGHT))
    ->capture_default_str();
  command
    .add_option("--iterations", options.registration.number_of_iterations,
                "cap on the number of iterations")
    ->transform(integer(1))
    ->capture_default_str();
  command.add_option("--paper-weights", raw.paper_weights,
                     "ALPHA,BETA: the weights as the paper prints them");
  command.add_flag_callback(
    "--injective", [&options] { options.registration.injective = true; },
    "no inverted cells in the elastic body; the default, except with --paper-weights");
  command
    .add_flag_callback(
      "--no-injective", [&options] { options.registration.injective = false; },
      "inverted cells are allowed")
    ->excludes("--injective");
  command
    .add_option(
      "--rounds", options.number_of_rounds,
      "how often distances are measured again on the pose, at most; by default 3, or 0 "
      "with --given-target, --paper-weights, --target-mode unfold or the uncentered kernel")
    ->transform(integer(0));
  command
    .add_option("--components", raw.components,
                "more than one connected component: auto, refuse, largest, each")
    ->check(CLI::IsMember({"auto", "refuse", "largest", "each"}))
    ->capture_default_str();
  command
    .add_option("--contacts", raw.contacts,
                "handles of a surface that look like false contacts of its parts: keep, cut")
    ->check(CLI::IsMember({"keep", "cut"}))
    ->capture_default_str();
  command.add_option("--solver", raw.solver, "linear solver: auto, eigen, cholmod")
    ->check(CLI::IsMember({"auto", "eigen", "cholmod"}))
    ->capture_default_str();
  command.add_option("--seed", options.random_seed, "0, or the seed that draws the first landmark")
    ->transform(integer(0u))
    ->capture_default_str();
  add_common(command, arguments);
}

void add_pose(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  add_input(command, arguments);
  command
    .add_option("-o,--output", arguments.output, "the pose: INPUT's vertices and faces or cells")
    ->required()
    ->check(path());
  command.add_option("--target", arguments.target, "write the target of the registration, too")
    ->check(path());
  command
    .add_option("--scene", arguments.scene,
                "write input, target and pose in one file, with an animation (.glb), too")
    ->check(path());
  command
    .add_option("--matching-weights", arguments.matching_weights,
                "file of factors of the matching weights, one per vertex")
    ->check(path());
  command
    .add_option("--stiffness", arguments.stiffness,
                "file of factors of the stiffness, one per vertex of a surface, or per tetrahedron")
    ->check(path());
  command
    .add_option("--given-target", arguments.given_target,
                "take this target, as --target writes it, instead of computing one")
    ->check(path());
  command
    .add_option("--given-distances", arguments.given_distances,
                "take these distances, as geodesics writes them, instead of computing any")
    ->check(path());
  add_constraints(command, raw);
  command
    .add_option("--frame", raw.frame,
                "position of the pose: near the input, or canonical: principal axes")
    ->check(CLI::IsMember({"input", "canonical"}))
    ->capture_default_str();
  add_report(command, arguments);
  add_pose_options(command, arguments, raw);
}

void add_segment(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  add_input(command, arguments);
  command
    .add_option(
      "-o,--output", arguments.output,
      "the parts: numbers of the faces (.txt), colors (.ply, .glb), or a file each (folder/)")
    ->required()
    ->check(path());
  command.add_option("--parts", raw.parts, "number of parts: a positive number, or auto")
    ->capture_default_str();
  command
    .add_option("--method", arguments.method, "consensus, sweep (fast), kmeans (of the paper)")
    ->check(CLI::IsMember({"consensus", "sweep", "kmeans"}))
    ->capture_default_str();
  command.add_option("--pose", arguments.pose, "take this pose instead of computing one")
    ->check(path());
  add_report(command, arguments);
  add_pose_options(command, arguments, raw);
}

void add_describe(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  add_input(command, arguments);
  command.add_option("-o,--output", arguments.output, "the values of the descriptors (.json)")
    ->required()
    ->check(path());
  command
    .add_option("--descriptor", arguments.descriptors,
                "heat-kernel-quantiles, shape-dna, shape-distribution-d2, views; may be repeated; "
                "default: all")
    ->allow_extra_args(false);
  command.add_option("--pose", arguments.pose, "take this pose instead of computing one")
    ->check(path());
  add_pose_options(command, arguments, raw);
}

void add_page(CLI::App& command, Arguments& arguments)
{
  command.add_option("SCENE", arguments.inputs, "scenes, or other surfaces (.glb)")->required();
  command.add_option("-o,--output", arguments.output, "the page (.html)")
    ->required()
    ->check(path());
}

// Adds the options of `pose`, and remembers those that are given and matter for results.
void add_recorded_pose_options(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  const std::size_t number_before = command.get_options().size();
  add_pose_options(command, arguments, raw);
  command.final_callback([&command, &arguments, number_before] {
    const std::vector<CLI::Option*> options = command.get_options();
    for(std::size_t i = number_before; i < options.size(); ++i)
    {
      const std::string name = options[i]->get_name();
      if(options[i]->count() == 0 || name == "--threads" || name == "--quiet")
        continue;
      arguments.pose_words.push_back(name);
      if(options[i]->get_expected_max() > 0)
        for(const std::string& value : options[i]->results())
          arguments.pose_words.push_back(value);
    }
    for(const std::string& word : arguments.pose_words)
      arguments.pose_options += (arguments.pose_options.empty() ? "" : " ") + word;
  });
}

void add_database(CLI::App& command, Arguments& arguments)
{
  command.add_option("--database", arguments.database, "the collection (SQLite)")
    ->required()
    ->check(path());
}

void add_weighted_descriptors(CLI::App& command, Arguments& arguments)
{
  const auto weight
    = number(Registration_options::SMALLEST_WEIGHT, Registration_options::LARGEST_WEIGHT);
  command
    .add_option("--descriptor", arguments.descriptors,
                "NAME[:WEIGHT], as in describe; may be repeated; default: all of the collection")
    ->allow_extra_args(false)
    ->check([=](const std::string& text) {
      const std::size_t colon = text.rfind(':');
      return colon == std::string::npos ? std::string() : weight(text.substr(colon + 1));
    });
}

void add_collection(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  command
    .add_option("INPUT", arguments.inputs,
                "surfaces, folders with surfaces, and @lists of paths, one per line")
    ->required()
    ->check(path());
  add_database(command, arguments);
  command
    .add_option("--descriptor", arguments.descriptors,
                "a descriptor, as in describe; may be repeated; default: all")
    ->allow_extra_args(false);
  command.add_option("--poses", arguments.pose_folder, "folder for the poses (.off)")
    ->check(path());
  command.add_flag("--segment", arguments.is_segmented, "divide the shapes into parts, too");
  command
    .add_option("--workers", arguments.number_of_workers,
                "so many shapes at a time; 0: as many as there are processors")
    ->transform(integer(std::size_t(0)))
    ->capture_default_str();
  command.add_option("--time-limit", arguments.time_limit, "seconds for a shape; 0: no limit")
    ->check(number(0, 1e9))
    ->capture_default_str();
  command
    .add_option("--memory-limit", arguments.memory_limit,
                "megabytes of addresses for a shape; 0: no limit")
    ->check(number(0, 1e9))
    ->capture_default_str();
  add_recorded_pose_options(command, arguments, raw);
}

void add_shape(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  command.group(""); // for `collection`, not for people
  add_input(command, arguments);
  command.add_option("-o,--output", arguments.output, "the pose")->check(path());
  command.add_option("--descriptor", arguments.descriptors, "a descriptor")
    ->allow_extra_args(false);
  command.add_flag("--no-descriptor", arguments.has_no_descriptor, "none");
  command.add_flag("--segment", arguments.is_segmented, "parts");
  add_pose_options(command, arguments, raw);
}

void add_search(CLI::App& command, Arguments& arguments, Raw_arguments& raw)
{
  command.add_option("QUERY", arguments.input, "surface")->required();
  add_database(command, arguments);
  command.add_option("-n", arguments.number_of_answers, "number of answers")
    ->transform(integer(std::size_t(1)))
    ->capture_default_str();
  add_weighted_descriptors(command, arguments);
  command.add_option("--pose", arguments.pose, "take this pose instead of computing one")
    ->check(path());
  add_recorded_pose_options(command, arguments, raw);
}

void add_evaluate(CLI::App& command, Arguments& arguments)
{
  add_database(command, arguments);
  command.add_option("--classes", arguments.classes, "the classes: lines \"stem class\"")
    ->required()
    ->check(path());
  add_weighted_descriptors(command, arguments);
  command
    .add_option("--rerank", arguments.rerank,
                "evaluate the answers in another order, too: manifold")
    ->check(CLI::IsMember({"manifold"}));
  command
    .add_option("--csv", arguments.csv,
                "write precision-recall curves and the classes of nearest shapes")
    ->check(path());
  command.add_option("--plot", arguments.plot, "draw the precision-recall curves (.png)")
    ->check(path());
}

void add_check(CLI::App& command, Arguments& arguments)
{
  add_input(command, arguments);
  add_report(command, arguments);
  command.add_flag("--quiet", arguments.quiet, "print nothing but errors");
}

void add_geodesics(CLI::App& command, Arguments& arguments)
{
  add_input(command, arguments);
  command.add_option("--source", arguments.sources, "number of a vertex, from 0; may be repeated")
    ->required()
    ->transform(integer(std::size_t(0)))
    ->allow_extra_args(false);
  command
    .add_option("-o,--output", arguments.output,
                "the distances: a line per vertex, a column per source; or colors (.ply, .glb)")
    ->required()
    ->check(path());
  add_common(command, arguments);
}

void add_compare(CLI::App& command, Arguments& arguments)
{
  command
    .add_option("POSE", arguments.poses, "two or more meshes whose vertices correspond by number")
    ->required()
    ->expected(2, -1);
}

void take(const Raw_arguments& raw, Arguments& arguments)
{
  Options& options = arguments.options;
  options.body = BODIES.at(arguments.body);
  options.components = COMPONENTS.at(raw.components);
  options.frame = FRAMES.at(raw.frame);
  options.kernel = KERNELS.at(raw.kernel);
  options.solver = SOLVERS.at(raw.solver);
  options.contacts = CONTACTS.at(raw.contacts);
  options.target_mode = TARGET_MODES.at(raw.target_mode);
  if(arguments.geodesics == "wavefront")
    options.geodesics = Options::Geodesics::WAVEFRONT;
  if(!raw.paper_weights.empty())
  {
    const std::vector<std::string> weights = words("--paper-weights", raw.paper_weights, 2, 2);
    const double alpha = *real_of(weights[0]), beta = *real_of(weights[1]);
    if(!(alpha > 0) || beta < 0 || beta > Registration_options::LARGEST_WEIGHT)
      throw CLI::ValidationError("--paper-weights",
                                 "'" + raw.paper_weights
                                   + "': ALPHA must be positive, and BETA from 0 to "
                                   + shown(Registration_options::LARGEST_WEIGHT));
    options.paper_weights = CGAL::Canonical_pose_3::Paper_weights{alpha, beta};
  }
  if(options.target_mode == Options::Target_mode::UNFOLDING && !arguments.given_target.empty())
    throw CLI::ValidationError("--target-mode", "unfold excludes --given-target");
  take_constraints(raw, options);
  if(raw.parts != "auto")
  {
    arguments.number_of_parts = count_of<std::size_t>(raw.parts).value_or(0);
    if(arguments.number_of_parts == 0)
      throw CLI::ValidationError("--parts",
                                 "'" + raw.parts + "' is neither auto nor a positive number");
  }
  if(arguments.method == "kmeans" && arguments.number_of_parts == 0)
    throw CLI::ValidationError("--method", "'kmeans' cannot determine the number of parts: --parts "
                                           "is required");
}

} // namespace

std::optional<int> parse_command_line(const int argc, char* argv[], Arguments& arguments)
{
  Raw_arguments raw;
  CLI::App app("Brings 3D shapes into their detail-preserving canonical pose.", "canonical-pose");
  app.set_version_flag("--version", CGAL_CANONICAL_POSE_3_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) { // one line for bad values
    return std::string("canonical-pose: ") + error.what()
           + (error.get_name() == "ValidationError" ? "\n" : "; see --help\n");
  });
  CLI::App* const pose = app.add_subcommand("pose", "brings a shape into its canonical pose");
  CLI::App* const check
    = app.add_subcommand("check", "tells what is wrong with a surface, if anything");
  CLI::App* const geodesics = app.add_subcommand("geodesics", "measures distances on a surface");
  CLI::App* const segment = app.add_subcommand("segment", "divides a surface into parts");
  CLI::App* const describe
    = app.add_subcommand("describe", "describes a surface by numbers, for search");
  CLI::App* const page
    = app.add_subcommand("page", "makes a page for browsers that shows scenes (.glb)");
  CLI::App* const compare = app.add_subcommand(
    "compare", "tells how much poses differ, whatever their position and scale");
  CLI::App* const collection
    = app.add_subcommand("collection", "describes many surfaces, and keeps the results in a file");
  CLI::App* const search
    = app.add_subcommand("search", "finds the shapes of a collection that are like a surface");
  CLI::App* const evaluate
    = app.add_subcommand("evaluate", "tells how well shapes of the same class find each other");
  CLI::App* const shape = app.add_subcommand("shape", "");
  add_collection(*collection, arguments, raw);
  add_search(*search, arguments, raw);
  add_evaluate(*evaluate, arguments);
  add_shape(*shape, arguments, raw);
  add_compare(*compare, arguments);
  add_pose(*pose, arguments, raw);
  add_segment(*segment, arguments, raw);
  add_describe(*describe, arguments, raw);
  add_page(*page, arguments);
  add_check(*check, arguments);
  add_geodesics(*geodesics, arguments);
  try
  {
    app.parse(argc, argv);
    for(const CLI::App* const command : {segment, describe, collection, search, shape})
      if(*command && command->count("--components") == 0)
        raw.components = "each";
    if(*collection && collection->count("--threads") == 0)
      arguments.options.number_of_threads = 1;
    if(arguments.number_of_workers == 0)
      arguments.number_of_workers = (std::max)(std::thread::hardware_concurrency(), 1u);
    take(raw, arguments);
  }
  catch(const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 2;
  }
  using Command = Arguments::Command;
  for(const auto& [parsed, command] :
      {std::make_pair(pose, Command::POSE), std::make_pair(check, Command::CHECK),
       std::make_pair(geodesics, Command::GEODESICS), std::make_pair(compare, Command::COMPARE),
       std::make_pair(segment, Command::SEGMENT), std::make_pair(describe, Command::DESCRIBE),
       std::make_pair(page, Command::PAGE), std::make_pair(collection, Command::COLLECTION),
       std::make_pair(shape, Command::SHAPE), std::make_pair(search, Command::SEARCH),
       std::make_pair(evaluate, Command::EVALUATE)})
    if(*parsed)
      arguments.command = command;
  return std::nullopt;
}

void check_formats(const Arguments& arguments)
{
  const bool is_tetrahedral = format_of(arguments.input) == Format::MEDIT;
  const auto holds_tetrahedra = [](const std::string& path) {
    return format_of(path) == Format::MEDIT || format_of(path) == Format::VTU;
  };
  if(is_tetrahedral != holds_tetrahedra(arguments.output))
    throw std::invalid_argument(
      is_tetrahedral ? "the pose of a tetrahedral mesh (.mesh) has to be one, too (.mesh, .vtu)"
                     : "the pose of a surface cannot be a tetrahedral mesh (.mesh, .vtu)");
  if(!arguments.target.empty() && holds_tetrahedra(arguments.target))
    throw std::invalid_argument(
      "the target is a surface and cannot be a tetrahedral mesh (.mesh, .vtu)");
  if(!arguments.scene.empty() && format_of(arguments.scene) != Format::GLB)
    throw std::invalid_argument("'" + arguments.scene + "' is not a .glb file");
  if(is_tetrahedral && arguments.body != "auto")
    throw std::invalid_argument("--body " + arguments.body
                                + ": a tetrahedral mesh is its own body");
}

} // namespace Canonical_pose_tool
