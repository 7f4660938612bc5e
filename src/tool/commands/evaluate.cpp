// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command evaluate.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "shown_results.h"
#include "collection/Collection_database.h"
#include "collection/described_collection.h"
#include "collection/read_classes.h"
#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Retrieval_evaluation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

namespace fs = std::filesystem;
using CGAL::Canonical_pose_3::Retrieval_evaluation;
using CGAL::Canonical_pose_3::Retrieval_measures;

struct Named_evaluation
{
  std::string name;
  Retrieval_evaluation evaluation;
};

// The shapes that have a class, in the order of their stems.
struct Classified_shapes
{
  std::vector<std::size_t> columns;
  std::vector<std::size_t> classes;
  std::vector<std::string> names; // of the classes
};

Classified_shapes classified(const Described_collection& shapes,
                             const std::map<std::string, std::string>& class_of)
{
  std::vector<std::pair<std::string, std::size_t>> order; // stem, column
  for(std::size_t i = 0; i < shapes.paths.size(); ++i)
    if(const std::string stem = stem_of(shapes.paths[i]); class_of.count(stem) > 0)
      order.emplace_back(stem, i);
  std::sort(order.begin(), order.end());
  for(std::size_t i = 1; i < order.size(); ++i)
    if(order[i].first == order[i - 1].first)
      throw std::invalid_argument("'" + shapes.paths[order[i - 1].second] + "' and '"
                                  + shapes.paths[order[i].second]
                                  + "' have the same stem, so their classes are ambiguous");
  Classified_shapes result;
  for(const auto& [stem, column] : order)
    result.names.push_back(class_of.at(stem));
  std::sort(result.names.begin(), result.names.end());
  result.names.erase(std::unique(result.names.begin(), result.names.end()), result.names.end());
  for(const auto& [stem, column] : order)
  {
    result.columns.push_back(column);
    result.classes.push_back(static_cast<std::size_t>(
      std::lower_bound(result.names.begin(), result.names.end(), class_of.at(stem))
      - result.names.begin()));
  }
  if(result.columns.empty())
    throw std::invalid_argument("no shape of the database has a class");
  return result;
}

// Tells which names with a class have no described shape, and which classes have a single one.
void warn_of_names(const std::map<std::string, std::string>& class_of,
                   const Described_collection& shapes, const Classified_shapes& classified)
{
  std::vector<std::string> missing, alone;
  std::set<std::string> stems;
  for(const std::size_t column : classified.columns)
    stems.insert(stem_of(shapes.paths[column]));
  for(const auto& [stem, name] : class_of)
    if(stems.count(stem) == 0)
      missing.push_back(stem);
  for(std::size_t c = 0; c < classified.names.size(); ++c)
    if(std::count(classified.classes.begin(), classified.classes.end(), c) == 1)
      alone.push_back(classified.names[c]);
  const auto warn = [](const std::vector<std::string>& names, const char* const defect) {
    if(!names.empty())
      std::cerr << "canonical-pose: warning: " << defect << ": '" << names.front() << '\''
                << (names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "")
                << '\n';
  };
  warn(missing, "the database has no described shape of this name, which has a class");
  warn(alone, "this class has a single shape, which is no query");
}

Eigen::MatrixXd distances_of_pairs(const Descriptor& descriptor, const Eigen::MatrixXd& values,
                                   const std::vector<std::size_t>& columns)
{
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd chosen(values.rows(), n), result(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    chosen.col(i) = values.col(static_cast<Eigen::Index>(columns[static_cast<std::size_t>(i)]));
  for(Eigen::Index i = 0; i < n; ++i)
    result.col(i) = descriptor.distances(chosen.col(i), chosen);
  return result;
}

std::vector<Named_evaluation> evaluations(const Arguments& arguments,
                                          const std::vector<Weighted_descriptor>& chosen,
                                          const Described_collection& shapes,
                                          const Classified_shapes& classified)
{
  namespace CP = CGAL::Canonical_pose_3;
  std::vector<std::pair<std::string, Eigen::MatrixXd>> matrices;
  std::vector<Eigen::MatrixXd> distances;
  std::vector<double> weights;
  for(std::size_t k = 0; k < chosen.size(); ++k)
  {
    distances.push_back(
      distances_of_pairs(chosen[k].descriptor, shapes.values[k], classified.columns));
    weights.push_back(chosen[k].weight);
    matrices.emplace_back(chosen[k].descriptor.name, distances.back());
  }
  if(chosen.size() > 1)
    matrices.emplace_back("fused", CP::fused_distances(distances, weights));
  std::vector<Named_evaluation> result;
  for(const auto& [name, matrix] : matrices)
    result.push_back({name, Retrieval_evaluation(matrix, classified.classes)});
  if(arguments.rerank == "manifold")
    for(const auto& [name, matrix] : matrices)
      result.push_back({name + "+manifold",
                        Retrieval_evaluation(CP::manifold_ranking(matrix), classified.classes)});
  return result;
}

void write_line(std::ostream& out, const std::string& name, const Retrieval_measures& m)
{
  out << name;
  for(const double value : {m.nearest_neighbor, m.first_tier, m.second_tier, m.e_measure,
                            m.discounted_cumulative_gain, m.average_precision})
  {
    std::array<char, 16> text;
    std::snprintf(text.data(), text.size(), " %.4f", value);
    out << text.data();
  }
  out << '\n';
}

// The classes to which queries belong.
std::vector<std::size_t> classes_of_queries(const Classified_shapes& shapes)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < shapes.names.size(); ++c)
    if(std::count(shapes.classes.begin(), shapes.classes.end(), c) > 1)
      result.push_back(c);
  return result;
}

void write_tables(std::ostream& out, const std::vector<Named_evaluation>& evaluations,
                  const Classified_shapes& shapes)
{
  const std::string measures = " NN FT ST E DCG mAP\n";
  out << "name" << measures;
  for(const auto& [name, evaluation] : evaluations)
    write_line(out, name, evaluation.mean());
  out << "\nname class" << measures;
  for(const auto& [name, evaluation] : evaluations)
    for(const std::size_t c : classes_of_queries(shapes))
      write_line(out, name + ' ' + shapes.names[c], evaluation.mean_of_class(c));
}

// A field of CSV.
std::string quoted(const std::string& text)
{
  if(text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for(const char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

// Curves and class confusion, a line per value.
void write_csv(std::ostream& out, const std::vector<Named_evaluation>& evaluations,
               const Classified_shapes& shapes)
{
  out << "table,descriptor,row,column,value\n";
  for(const auto& [name, evaluation] : evaluations)
  {
    const std::vector<double>& precision = evaluation.precision();
    for(std::size_t i = 0; i < precision.size(); ++i)
    {
      std::array<char, 64> text;
      std::snprintf(text.data(), text.size(), "recall,%.2f,%.4f",
                    static_cast<double>(i + 1) / static_cast<double>(precision.size()),
                    precision[i]);
      out << "precision," << name << ',' << text.data() << '\n';
    }
  }
  for(const auto& [name, evaluation] : evaluations)
    for(const std::size_t a : classes_of_queries(shapes))
      for(std::size_t b = 0; b < shapes.names.size(); ++b)
        if(const std::size_t number = evaluation.confusion(a, b); number > 0)
          out << "nearest," << name << ',' << quoted(shapes.names[a]) << ','
              << quoted(shapes.names[b]) << ',' << number << '\n';
}

nlohmann::ordered_json json_of(const Retrieval_measures& m)
{
  return {{"nearest_neighbor", m.nearest_neighbor},
          {"first_tier", m.first_tier},
          {"second_tier", m.second_tier},
          {"e_measure", m.e_measure},
          {"discounted_cumulative_gain", m.discounted_cumulative_gain},
          {"average_precision", m.average_precision}};
}

// The tables and the curves.
void write_evaluations(std::ostream& out, const std::vector<Named_evaluation>& evaluations,
                       const Classified_shapes& shapes)
{
  Json report;
  for(const auto& [name, evaluation] : evaluations)
  {
    Json classes, nearest;
    for(const std::size_t a : classes_of_queries(shapes))
    {
      classes[shapes.names[a]] = json_of(evaluation.mean_of_class(a));
      for(std::size_t b = 0; b < shapes.names.size(); ++b)
        if(const std::size_t number = evaluation.confusion(a, b); number > 0)
          nearest[shapes.names[a]][shapes.names[b]] = number;
    }
    report[name] = {{"mean", json_of(evaluation.mean())},
                    {"classes", classes},
                    {"precision", evaluation.precision()},
                    {"nearest", nearest}};
  }
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

// A file that is removed at the end.
class Temporary_file
{
public:
  Temporary_file() : m_path((fs::temp_directory_path() / "canonical-pose-XXXXXX").string())
  {
    const int file = mkstemp(m_path.data());
    if(file < 0)
      throw std::runtime_error("a temporary file cannot be created");
    close(file);
  }
  ~Temporary_file() { std::remove(m_path.c_str()); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

// Draws the precision-recall curves by gnuplot.
void draw(std::ostream& out, const std::vector<Named_evaluation>& evaluations)
{
  const Temporary_file picture;
  FILE* const gnuplot = popen("gnuplot 2>/dev/null", "w");
  if(!gnuplot)
    throw std::runtime_error("gnuplot cannot be started");
  std::ostringstream script;
  script << "set terminal pngcairo size 800,600\nset output '" << picture.path()
         << "'\nset xlabel 'recall'\nset ylabel 'precision'\nset xrange [0:1]\nset yrange [0:1]\n"
            "set grid\nset key bottom left noenhanced\nplot ";
  for(const auto& [name, evaluation] : evaluations)
    script << (&name == &evaluations.front().name ? "" : ", ") << "'-' with linespoints title '"
           << name << "'";
  script << '\n';
  for(const auto& [name, evaluation] : evaluations)
  {
    const std::vector<double>& precision = evaluation.precision();
    for(std::size_t i = 0; i < precision.size(); ++i)
      script << static_cast<double>(i + 1) / static_cast<double>(precision.size()) << ' '
             << precision[i] << '\n';
    script << "e\n";
  }
  std::fputs(script.str().c_str(), gnuplot);
  if(pclose(gnuplot) != 0 || fs::file_size(picture.path()) == 0)
    throw std::runtime_error("gnuplot (Debian: gnuplot-nox) failed to draw the picture");
  out << std::ifstream(picture.path(), std::ios::binary).rdbuf();
}

void add_evaluate_options(Command_options& o)
{
  add_database(o);
  add_path(o, "--classes", o.arguments.classes,
           "the classes: lines \"stem class\", or with a tab between them")
    ->required();
  add_weighted_descriptors(o);
  o.app
    .add_option("--rerank", o.arguments.rerank, "also evaluate the answers ranked again: manifold")
    ->check(CLI::IsMember({"manifold"}));
  add_path(o, "--csv", o.arguments.csv,
           "write precision-recall curves and the classes of nearest shapes");
  add_path(o, "--plot", o.arguments.plot, "draw the precision-recall curves (.png)");
  add_report(o);
  add_recorded_method_options(o);
}

int run_evaluate(Arguments& arguments)
{
  if(!arguments.plot.empty())
    check_extension(arguments.plot, ".png");
  const std::vector<std::string> outputs = {arguments.csv, arguments.plot, arguments.report};
  Output_files files(outputs, {arguments.classes, arguments.database});
  Collection_database database(arguments.database, false);
  const std::vector<std::string> options = database.options();
  const bool is_only_one = options.size() == 1 && arguments.pose_options.empty();
  const std::vector<Weighted_descriptor> chosen = chosen_descriptors(arguments, database);
  const Described_collection shapes
    = values_of(database, chosen, is_only_one ? options.front() : arguments.pose_options);
  warn_of_missing(std::cerr, database, shapes);
  const std::map<std::string, std::string> class_of = read_classes(arguments.classes);
  const Classified_shapes classes = classified(shapes, class_of);
  arguments.say("comparing all pairs of shapes");
  const std::vector<Named_evaluation> all = evaluations(arguments, chosen, shapes, classes);
  arguments.say("");
  warn_of_names(class_of, shapes, classes);
  files.write(arguments.csv, [&](std::ostream& out) { write_csv(out, all, classes); });
  files.write(arguments.plot, [&](std::ostream& out) { draw(out, all); });
  files.write(arguments.report, [&](std::ostream& out) { write_evaluations(out, all, classes); });
  files.commit();
  if(!arguments.quiet)
    write_tables(messages_beside(outputs), all, classes);
  return EXIT_SUCCESS;
}

} // namespace

const Command EVALUATE_COMMAND
  = {"evaluate",
     "evaluates the retrieval of shapes of the same class",
     {"evaluate --database meshes.db --classes classes.txt",
      "evaluate --database meshes.db --classes classes.txt --rerank manifold --plot curves.png"},
     add_evaluate_options,
     run_evaluate};

} // namespace Canonical_pose_tool
