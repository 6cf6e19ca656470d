/// \file
/// Builds that are timed, as rows of tables and bars of charts.
#pragma once

#include "thesis/run/counts.h"
#include "thesis/run/experiment.h"
#include "thesis/run/steps.h"
#include "thesis/trips/timing.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Whose the times of the rules are, for the remarks of the experiments that compare them.
inline constexpr std::string_view kWhoseTimes =
    "These are times of the library's builder, which serves many rules: it grows the box of the "
    "midpoints for all of them, and gives spatial median one more pass over each node for the "
    "outer box. What is the rule's own and what the builder's, the items claim-build-8-percent and "
    "claim-build-city tell apart.";

/// Columns of a timed build, before its times.
inline constexpr std::array<std::string_view, 4> kBuildColumns{"model", "rule", "level", "nodes"};

/// Last, so that a reader meets the times before them.
inline constexpr std::array<std::string_view, 5> kBuildOptionColumns{
    "triangles", "origin", "midpoint", "axis_from", "empty_side"};

/// A build, what it counted and how long it took.
struct TimedBuild {
  Counted counted = {};
  Timing timing = {};
};

/// `context.repetitions(whole)`, and in proportion fewer (at least 5) for models of more than
/// 10,000 triangles, which are larger than the thesis': so a city of the user's ends too.
[[nodiscard]] int repetitions(const Context& context, int whole, const Model& model);

/// Whose a number of repetitions is.
enum class RepetitionsOf { thesis, ours };

/// " Each tree is built 100 times (1,000 in a whole run), ...": how often `time_builds` builds each
/// tree of these models, whose number that is, and that large models get fewer, if one is.
[[nodiscard]] std::string words_on_repetitions(const Context& context, int whole,
                                               RepetitionsOf whose, std::span<const Model> models);

/// Steps that `time_builds` takes: the repetitions and the warm-up before them.
[[nodiscard]] std::size_t rounds(int repetitions);

/// Times builds of a model's tree in turn: from the triangles in memory to the finished tree, the
/// midpoints included, on one thread. \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<TimedBuild> time_builds(const Model& model,
                                                  std::span<const Contender> contenders,
                                                  int repetitions, Steps& steps);

/// A row for each build: model, rule, level, nodes and the number of builds; then, timed, median,
/// quartiles, mean, least time, standard deviation and the 95 % interval of the median in ms, mean
/// and median time for a node in us, and by how much the median is above that of spatial median at
/// the same level (builds without a limit: at the greatest level that was timed; empty where it was
/// not timed); then the options.
[[nodiscard]] Table time_table(std::string id, std::string caption,
                               std::span<const TimedBuild> builds);

/// The build of a rule of the thesis on a model at a level; nullptr if it was not timed.
[[nodiscard]] const TimedBuild* find_build(std::span<const TimedBuild> builds, const Model& model,
                                           Rule rule, int level);

}  // namespace soms::reproduce
