/// \file
/// The table of experiments: one for each table and figure of the thesis, and those that go beyond.
#pragma once

#include "soms/base/limits.h"

#include "thesis/races/race_process.h"
#include "thesis/run/result.h"
#include "thesis/trips/drawn_frames.h"
#include "thesis/trips/models.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

class TouchingDrives;

/// What an experiment gets.
struct Context {
  const Models& models;
  /// Fewer repetitions and smaller sweeps; counts of the thesis' own tables are the same.
  bool quick = false;
  /// One thread for all that is timed; `stop` and `progress` (0 to 1 of this experiment) are
  /// heeded.
  Limits limits = {};
  DrawFrames draw = {};                  ///< what draws; empty where nothing does
  TouchingDrives* touching = nullptr;    ///< those that the run has found; may be null
  RaceProcess* races = &sole_process();  ///< how rounds of races are shared; never null
  int counting_threads = 1;              ///< for what is only counted; nothing is timed meanwhile

  /// For work that is only counted: all its threads, heeds a stop request, reports nothing.
  [[nodiscard]] Limits counting() const {
    return {.threads = counting_threads, .stop = limits.stop};
  }

  /// `whole` repetitions, or a tenth of them (at least 5) in a quick run.
  [[nodiscard]] int repetitions(int whole) const;

  /// Every so many frames of a trip are timed: in a quick run not all. Counts are of all.
  [[nodiscard]] std::size_t timed_step(bool drive) const { return !quick ? 1 : drive ? 16 : 8; }

  /// That, in a sentence; empty in a whole run.
  [[nodiscard]] std::string timed_step_words() const;

  /// Paired rounds behind an interval of 95 %: 100, in a quick run 10.
  [[nodiscard]] int rounds() const { return quick ? 10 : 100; }
};

/// Part of the report that an experiment belongs to.
enum class Chapter {
  claims,  ///< a claim of the thesis, by all its readings and metrics
  thesis,  ///< a table or figure of the thesis
  beyond,  ///< what we add
};

/// A row of the table of experiments.
struct Experiment {
  std::string_view item;   ///< "table-5.3", "figure-5.2", or a word of our own: "spread"
  std::string_view title;  ///< of the thesis' caption, in our words
  Chapter chapter = Chapter::thesis;
  Needs needs = {};
  int weight = 1;  ///< share of a whole run's time, for the progress bar
  /// \errors ErrorKind::cancelled.
  Result (*run)(const Context& context) = nullptr;
};

/// All experiments, in the order of the report.
[[nodiscard]] std::span<const Experiment> experiments();

/// The experiments that words name: an item ("table-5.3"), a number ("5.3": the table and the
/// figure), or "claims", "thesis" and "beyond". Each once, in the order of the report; all if
/// `words` is empty. \errors ErrorKind::usage, which lists the items.
[[nodiscard]] std::vector<const Experiment*> experiments_named(
    std::span<const std::string_view> words);

}  // namespace soms::reproduce
