#include "apps/soms/simulate.h"

#include "apps/soms/console.h"
#include "apps/soms/map.h"
#include "apps/soms/output.h"
#include "apps/soms/simulate_report.h"
#include "apps/soms/simulate_run.h"
#include "apps/soms/simulate_world.h"

#include <optional>

namespace soms::command {

namespace {

constexpr int kHolds = 1;
constexpr int kDiffers = 6;
constexpr int kInterrupted = 130;

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
  // Places that cannot be written to are told before the work, not after it.
  std::optional<OutputFile> events;
  std::optional<OutputFile> map;
  open(events, options.events);
  open(map, options.map);
  const World world = load_world(options, console);
  const Outcome outcome = run_frames(world, options, console);
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
