#include "bench/peers/core/goals.h"

#include <array>
#include <limits>
#include <string_view>

namespace soms::bench {

namespace {

constexpr std::uint64_t kAnySize = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kBelow100k = 99'999;
constexpr double kShareOfOverlap = 1.0 / 3;  // a solid may take three times the time of an overlap

struct Row {
  Job job;
  std::string_view scene;  // a beginning of its name
  std::string_view set;    // a beginning of its name
  std::uint64_t most;      // triangles; the first row that fits counts
  std::string_view library;
  double times;
  Against against = Against::all;
};

constexpr std::array kRows{
    Row{Job::any, "twins", "random", kAnySize, "soms", 5},
    Row{Job::any, "twins", "deep", kAnySize, "soms", 5},
    Row{Job::any, "twins", "near", 10'000, "soms", 6},
    Row{Job::any, "twins", "near", 100'000, "soms", 4.5},
    Row{Job::any, "twins", "near", kAnySize, "soms", 4},
    Row{Job::any, "city-car", "", kAnySize, "soms", 5},
    Row{Job::any, "real", "", kAnySize, "soms", 5},
    Row{Job::any, "city-drone", "drone-path", kAnySize, "soms", 2},
    Row{Job::any, "city-drone", "drone", kAnySize, "soms", 3},
    Row{Job::any, "twins", "random", kAnySize, "soms-batch", 8},
    Row{Job::any, "twins", "near-0.001", 10'000, "soms-batch", 8},
    Row{Job::any, "twins", "near-0.001", 100'000, "soms-batch", 6},
    Row{Job::any, "twins", "near-0.001", kAnySize, "soms-batch", 5},
    Row{Job::any, "city-car", "car", kAnySize, "soms-batch", 8},
    Row{Job::any, "city-drone", "drone", kAnySize, "soms-batch", 4},
    Row{Job::all, "twins", "random", kAnySize, "soms", 6},
    Row{Job::all, "twins", "deep", kAnySize, "soms", 4},
    Row{Job::all, "city-car", "car", kAnySize, "soms", 5},
    Row{Job::all, "unlike", "", kAnySize, "soms", 4},
    Row{Job::still, "", "", kAnySize, "soms", 4},
    Row{Job::broad, "", "", kAnySize, "soms", 2, Against::keeps_tree},
    Row{Job::broad, "", "", kAnySize, "soms", 5, Against::from_scratch},
    Row{Job::distance, "twins", "", kAnySize, "soms", 10},
    Row{Job::distance, "city", "", kAnySize, "soms", 20},
    Row{Job::distance, "real", "", kAnySize, "soms", 20},
    Row{Job::distance, "twins", "", kAnySize, "soms-batch", 10},
    Row{Job::distance, "city", "", kAnySize, "soms-batch", 20},
    Row{Job::distance, "real", "", kAnySize, "soms-batch", 20},
    Row{Job::within, "", "half ", kAnySize, "soms", 2, Against::by_distance},
    Row{Job::within, "", "", kAnySize, "soms", 1, Against::by_distance},
    Row{Job::within, "", "", kAnySize, "soms", 0},
    Row{Job::solid, "", "", kAnySize, "soms", kShareOfOverlap, Against::by_overlap},
    Row{Job::solid, "", "", kAnySize, "soms-batch", kShareOfOverlap, Against::by_overlap_batch},
    Row{Job::closest, "probe-city", "", kAnySize, "soms", 1},
    Row{Job::closest, "probe-knot", "", kAnySize, "soms", 1.8},
    Row{Job::closest, "", "", kBelow100k, "soms-batch", 0},
    Row{Job::closest, "probe-city", "", kAnySize, "soms-batch", 2},
    Row{Job::closest, "probe-knot", "", kAnySize, "soms-batch", 4},
    Row{Job::contains, "probe-armadillo", "", kAnySize, "soms-batch", 2.5},
    Row{Job::contains, "probe-igea", "", kAnySize, "soms-batch", 6},
    Row{Job::contains, "probe-armadillo", "", kAnySize, "soms-batch", 3, Against::clock},
    Row{Job::contains, "probe-igea", "", kAnySize, "soms-batch", 3, Against::clock},
    Row{Job::closest_hit, "", "", kAnySize, "soms", 0.5, Against::watertight},
    Row{Job::closest_hit, "", "", kBelow100k, "soms-batch", 0, Against::watertight},
    Row{Job::closest_hit, "", "", kAnySize, "soms-batch", 1, Against::watertight},
    Row{Job::any_hit, "", "", kAnySize, "soms", 0.5, Against::watertight},
    Row{Job::any_hit, "", "", kBelow100k, "soms-batch", 0, Against::watertight},
    Row{Job::any_hit, "", "", kAnySize, "soms-batch", 1, Against::watertight},
};

/// The part of a goal that a machine with these instructions has to reach.
double share_of(const std::string& isa) {
  return isa == "avx512" ? 1 : 0.5;
}

/// Goals that compare soms with itself do not depend on the machine.
bool is_own(Against against) {
  return against == Against::by_distance || against == Against::by_overlap ||
         against == Against::by_overlap_batch;
}

bool fits(const Row& row, Job job, const std::string& scene, const std::string& set,
          std::uint64_t triangles) {
  // The goals of batches name sets of unlike poses, not paths.
  const bool path = job == Job::any && set.ends_with("-path") && row.library == "soms-batch";
  return row.job == job && scene.starts_with(row.scene) && set.starts_with(row.set) &&
         triangles <= row.most && !path;
}

}  // namespace

std::vector<MedianGoal> median_goals(const std::string& isa) {
  const double share = share_of(isa);
  return {{Job::any, "unlike", "soms", 5 * share}, {Job::all, "unlike", "soms", 6 * share}};
}

std::vector<Goal> goals_of(Job job, const std::string& scene, const std::string& set,
                           std::uint64_t triangles, const std::string& isa) {
  const double share = share_of(isa);
  std::vector<Goal> goals;
  for (const Row& row : kRows) {
    bool first = true;
    for (const Goal& goal : goals) {
      first = first && (goal.library != row.library || goal.against != row.against);
    }
    if (first && fits(row, job, scene, set, triangles)) {
      const double part = is_own(row.against) ? 1 : share;
      goals.push_back({std::string(row.library), part * row.times, row.against});
    }
  }
  return goals;
}

}  // namespace soms::bench
