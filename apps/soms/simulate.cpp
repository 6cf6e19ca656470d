#include "apps/soms/simulate.h"

#include "soms/base/error.h"

#include "apps/soms/map.h"
#include "apps/soms/simulate_record.h"
#include "apps/soms/simulate_report.h"
#include "apps/soms/simulate_run.h"
#include "apps/support/console.h"
#include "apps/support/output.h"
#include "apps/support/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr int kHolds = 1;
constexpr int kDiffers = 6;
constexpr int kInterrupted = 130;

using Named = std::pair<const char*, std::string>;  ///< an option and its file

std::filesystem::path real_path(const std::string& path) {
  std::error_code failed;
  const std::filesystem::path real =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path), failed);
  return failed ? std::filesystem::path(path) : real;
}

/// Throws ErrorKind::usage if an output would mix with the table or overwrite another file of ours.
void check_outputs(const SimulateOptions& options) {
  std::vector<Named> taken;
  for (const std::string& path : options.world.cities) {
    taken.emplace_back("CITY", path);
  }
  for (const std::string& path : options.world.movers) {
    taken.emplace_back("--mover", path);
  }
  for (const std::string& path : options.world.routes) {
    taken.emplace_back("--route", path);
  }
  for (const Named& output : {Named("--events", options.events), Named("--map", options.map),
                              Named("--record", options.record)}) {
    const auto& [name, path] = output;
    if (path.empty() || path == "/dev/null") {
      continue;
    }
    if (path == "-" || path == "/dev/stdout") {
      throw Error(ErrorKind::usage,
                  fmt::format("{} {}: standard output holds the table", name, path), "give a file");
    }
    for (const auto& [other, other_path] : taken) {
      if (other_path != "-" && real_path(path) == real_path(other_path)) {
        throw Error(ErrorKind::usage,
                    fmt::format("{} {}: {} names the same file", name, path, other),
                    "give another file");
      }
    }
    taken.push_back(output);
  }
}

/// Throws ErrorKind::usage for a recording of models that nobody could find again.
void check_recording(const SimulateOptions& options) {
  const WorldOptions& world = options.world;
  for (const auto* const files : {&world.cities, &world.movers}) {
    if (!options.record.empty() && std::find(files->begin(), files->end(), "-") != files->end()) {
      throw Error(ErrorKind::usage, "--record with a model from standard input",
                  "give the model as a file, which a player can find again");
    }
  }
}

RecordingEnding ending_of(const Outcome& outcome) {
  switch (outcome.ending) {
    case Ending::whole:
      return RecordingEnding::complete;
    case Ending::timed_out:
      return RecordingEnding::timed_out;
    case Ending::interrupted:
      break;
  }
  return RecordingEnding::interrupted;
}

void open(std::optional<OutputFile>& file, const std::string& path) {
  if (!path.empty()) {
    file.emplace(path);
  }
}

int status_of(const Outcome& outcome, const SimulateOptions& options) {
  if (outcome.verified && outcome.verified->wrong > 0) {
    return kDiffers;
  }
  if (outcome.ending == Ending::interrupted) {
    return kInterrupted;
  }
  return options.fail_if_contact && !outcome.contacts.contacts().empty() ? kHolds : 0;
}

}  // namespace

int run_simulate(const SimulateOptions& options, Console& console) {
  check_outputs(options);
  check_recording(options);
  // Places that cannot be written to are told before the work, not after it.
  std::optional<OutputFile> events;
  std::optional<OutputFile> map;
  open(events, options.events);
  open(map, options.map);
  std::optional<OutputFile> record;
  open(record, options.record);
  const World world = load_world(options.world, console);
  std::optional<Recorder> recorder;
  if (record) {
    recorder.emplace(*record, world, options.frames);
  }
  const Outcome outcome = run_frames(world, options, console, recorder ? &*recorder : nullptr);
  if (recorder) {
    recorder->finish(ending_of(outcome));
  }
  if (events) {
    write_events(events->stream(), world, outcome);
    events->commit();
  }
  if (map) {
    draw_map(map->stream(), world, outcome);
    map->commit();
  }
  console.print(console.shared().json ? json_of(world, outcome, options)
                                      : table_of(world, outcome, options));
  return status_of(outcome, options);
}

}  // namespace soms::command
