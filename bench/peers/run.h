/// \file
/// Runs the jobs of scenes: prepares the libraries, races them, lets the judge compare.
#pragma once

#include "bench/peers/core/report.h"
#include "bench/peers/libraries/library.h"
#include "bench/peers/scenarios/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace soms::bench {

/// What is queried of a scene, and how long.
struct RunOptions {
  std::vector<Job> jobs{Job::any,      Job::all,         Job::still,  Job::broad,
                        Job::distance, Job::within,      Job::solid,  Job::closest,
                        Job::contains, Job::closest_hit, Job::any_hit};
  std::vector<std::string> sets;       ///< empty: all
  std::vector<std::string> libraries;  ///< names or beginnings of names; empty: all
  RaceOptions race;
  double judge = 5e6;  ///< triangles of the mover that the judge looks at in a set
};

/// Gets each cell when it is done.
using Sink = std::function<void(Cell cell)>;

/// Runs every job of `options` that the scene has sets for.
void run_scene(const Scene& scene, const Roster& roster, const RunOptions& options,
               const Sink& sink);

}  // namespace soms::bench
