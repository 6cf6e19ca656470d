/// \file
/// A run of experiments, whole or interrupted, and the files it makes.
#pragma once

#include "thesis/races/race_team.h"
#include "thesis/run/experiment.h"
#include "thesis/run/golden.h"
#include "thesis/run/load.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// The machine and the build, as the page shows them.
struct Machine {
  std::string processor;
  std::string system;
  std::string compiler;
  std::string version;  ///< of soms
  int processors = 0;
  std::string usable_processors = {};  ///< numbers of those that the program may use: "0-3,6"
  std::uint64_t memory = 0;            ///< bytes; 0 where the system does not say
  std::string instruction_set = {};    ///< of the kernels that run here: "avx2"
  std::string commit = {};             ///< as Build::commit
  std::string build_type = {};         ///< as Build::type
  std::string flags = {};              ///< as Build::flags
};

/// This machine and this build.
[[nodiscard]] Machine this_machine();

/// The command line of this process, as a shell takes it.
[[nodiscard]] std::string command_line();

/// Words as a line for a POSIX shell, quoted where needed.
[[nodiscard]] std::string shell_line(std::span<const std::string> words);

/// Ascending numbers in short: "0-3,6".
[[nodiscard]] std::string joined_ranges(std::span<const int> numbers);

/// An experiment that ran.
struct Entry {
  const Experiment* experiment = nullptr;
  Result result = {};
  double seconds = 0;            ///< wall time
  double processor_seconds = 0;  ///< of all threads
};

/// All of a run.
struct Report {
  Machine machine = {};
  std::string date;  ///< UTC, ISO 8601
  bool quick = false;
  Models models = {};
  std::vector<std::string> model_files = {};  ///< generated scenes as written: "scenes/u_mixed.3ds"
  std::vector<Entry> entries = {};
  std::vector<const Experiment*> missing = {};  ///< not run: the run was interrupted
  std::string ended = {};                       ///< as `date`
  std::string command = {};                     ///< command line
  double seconds = 0;                           ///< wall time, reading models included
  double processor_seconds = 0;                 ///< of all threads
  Load load = {};
  bool latex = false;                           ///< tables were also written for LaTeX
  std::optional<GoldenComparison> golden = {};  ///< nothing if it was not requested

  /// True if all that was requested was done.
  [[nodiscard]] bool whole() const { return missing.empty() && (!golden || golden->whole); }
};

/// How a run goes.
struct RunOptions {
  std::filesystem::path models = {};  ///< folder of models; empty for stand-ins
  std::vector<const Experiment*> experiments = {};
  bool quick = false;
  DrawFrames draw = {};  ///< what draws for experiments that do; empty where nothing does
  bool latex = false;    ///< also write tables for LaTeX (latex.h)
  std::optional<GoldenTables> golden = {};  ///< to compare with, after the experiments
};

/// What a run calls.
struct RunVisitor {
  /// The models, before the first experiment; may be empty.
  std::function<void(const Models& models)> found = {};
  /// A file that is to appear whole under the output folder: its name there and its bytes.
  std::function<void(const std::filesystem::path& name, std::string_view bytes)> write = {};
  /// The item of the experiment that runs now, or "golden tables", and the share of the whole run
  /// that is done.
  std::function<void(std::string_view now, double share)> progress = {};
};

/// Counts on the threads of `limits` where counting takes long; all else is on one thread.
///
/// Writes the generated scenes as scenes/NAME.3ds, runs experiments one after the other and writes
/// each one's files as soon as it ends, compares with the golden tables if there are any, then
/// writes the page and the list of files. A stop request ends it early: what is written is whole,
/// and the page names what is missing. \errors Those of find_models but cancelled; those of
/// `visitor` and of `leader`, which shares the rounds of races with other processes; without one
/// this process times all.
Report run(const RunOptions& options, const RunVisitor& visitor, const Limits& limits = {},
           RaceLeader* leader = nullptr);

/// Where the reader of the page finds tables as CSV and the list of files.
enum class PageFiles {
  beside,  ///< as files in the folder of the page
  inside,  ///< in the page itself, which then needs no folder
  paper,   ///< nowhere: the page is for printing, all open, and gives their names
};

/// The page: one HTML document without scripts or anything from a network.
[[nodiscard]] std::string page(const Report& report, PageFiles files = PageFiles::beside);

/// The list of files as JSON, schema "soms.reproduce/1": for each its experiment, and which columns
/// of a table, or whether a figure, differ from run to run.
[[nodiscard]] std::string manifest(const Report& report);

/// "tables/ID.csv" and "figures/ID.svg".
[[nodiscard]] std::filesystem::path file_of(const Table& table);
[[nodiscard]] std::filesystem::path file_of(const Figure& figure);

}  // namespace soms::reproduce
