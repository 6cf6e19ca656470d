/// \file
/// SOMS against spatial median: builds timed in pairs by several builders, and what they did.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/build_options.h"
#include "soms/tree/statistics.h"

#include "thesis/races/race_process.h"
#include "thesis/run/result.h"
#include "thesis/run/steps.h"
#include "thesis/trees/neutral_builders.h"
#include "thesis/trips/models.h"
#include "thesis/trips/statistics.h"
#include "thesis/trips/timing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Who builds the tree.
enum class Builder {
  library,      ///< `soms::build`
  thesis_like,  ///< NeutralWay::thesis_like
  in_place,     ///< NeutralWay::in_place
};

inline constexpr std::array kBuilders{Builder::library, Builder::thesis_like, Builder::in_place};

/// "library", "thesis_like", "in_place", for tables; and for people "library's builder", ...
[[nodiscard]] std::string_view name_of(Builder builder);
[[nodiscard]] std::string_view title_of(Builder builder);

/// The title with what is not alike for both rules: "library's builder, gives spatial median one
/// pass more". The library's builder grows the boxes of the midpoints for every rule, and those of
/// the corners, in a pass of its own, only for a rule that divides them.
[[nodiscard]] std::string_view reading_of(Builder builder);

/// What can become of a node that a rule leaves a side of empty.
inline constexpr std::array kFallbacks{EmptySide::stop, EmptySide::next_axis,
                                       EmptySide::object_median, EmptySide::chain};

/// "a node stays whole where a side is empty", "other axes where a side is empty", ...
[[nodiscard]] std::string_view fallback_words(EmptySide empty_side);

/// True if spatial median or SOMS leaves a side empty somewhere in the model's tree of this level:
/// else every empty side gives the same trees. \errors cancelled.
[[nodiscard]] bool has_empty_sides(const Model& model, int level, const Limits& limits);

/// One rule's half of a race.
struct RaceHalf {
  TreeStatistics counts = {};
  /// What the build did; of the library's builder only `compared`, which depends on rule and
  /// options alone.
  BuildWork work = {};
  Timing timing = {};  ///< of one build
};

/// Both rules by one builder, on one model at one level.
struct Race {
  const Model* model = nullptr;
  int level = 0;
  EmptySide empty_side = EmptySide::stop;
  Builder builder = Builder::library;
  RaceHalf spatial_median = {};
  RaceHalf soms = {};
};

/// What a race of one model is run for.
struct RaceTask {
  const Model* model = nullptr;
  int level = 0;
  EmptySide empty_side = EmptySide::stop;
};

/// Steps that `race` takes in this process.
[[nodiscard]] std::size_t race_steps(const RaceProcess& process, int rounds);

/// Races both rules by all builders, in the order of `kBuilders`: from the triangles in memory to
/// the finished tree, midpoints included, on one thread. A round has up to four builds of each
/// kind between two readings of the clock, for small models. \errors cancelled.
[[nodiscard]] std::vector<Race> race(RaceProcess& process, const RaceTask& task, int rounds,
                                     Steps& steps);

/// How much less time SOMS takes than spatial median, in percent of the latter's: 100 * (1 - SOMS /
/// spatial median), over pairs of rounds; for the whole tree, or for a node of each tree.
[[nodiscard]] Estimate gain(const Race& race);
[[nodiscard]] Estimate gain_per_node(const Race& race);

/// The same of triangles compared with planes: counted.
[[nodiscard]] double gain_in_work(const Race& race);

/// A row for each rule of each race: what was built and counted; then, timed, the median of a build
/// with its 95 % interval, and in the rows of SOMS both gains with theirs.
[[nodiscard]] Table race_table(std::string id, std::string caption, std::span<const Race> races);

/// The race of this model, level and empty side by this builder; nullptr if it was not run.
[[nodiscard]] const Race* find_race(std::span<const Race> races, const RaceTask& task,
                                    Builder builder);

}  // namespace soms::reproduce
