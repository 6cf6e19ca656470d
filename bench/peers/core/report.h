/// \file
/// Results of a run: cells, and which ratio may be reported.
#pragma once

#include "bench/peers/core/goals.h"
#include "bench/peers/core/judge.h"
#include "bench/peers/core/race.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::bench {

/// One library's figures in a cell.
struct Entry {
  std::string library;
  std::string version;
  double build = 0;  ///< seconds to prepare both bodies
  double bytes = 0;  ///< held afterwards, for each triangle of both
  bool keeps_tree = false;
  bool watertight = false;
  std::size_t answered = 0;  ///< questions
  Timing timing;
  Verdict verdict;
};

/// One job on one set of one scene, all libraries.
struct Cell {
  Job job = Job::any;
  std::string scene;
  std::string set;
  std::uint64_t triangles = 0;  ///< of the fixed body, or boxes
  std::uint64_t mover = 0;      ///< triangles of the mover
  std::size_t questions = 0;    ///< the same for all
  double sum =
      0;  ///< of the answers that are finite: poses, pairs, distances, points, hits, numbers
  std::vector<Entry> entries;
};

/// A peer wrong in more than this share of its answers is not ranked; soms must have none.
inline constexpr double kMostWrong = 0.02;

[[nodiscard]] std::string name(Job job);

/// What one answer is about: a pose, a frame, a point or a ray.
[[nodiscard]] std::string question(Job job);

/// True for soms used in a way that only shows what another way is worth.
[[nodiscard]] bool is_measure(const std::string& library);

/// False for a library whose time counts for nothing: too many wrong answers, or fewer questions
/// than the others.
[[nodiscard]] bool ranked(const Cell& cell, const Entry& entry);

/// The fastest ranked peer, or null where there is none. Against::by_distance: soms's own distance;
/// by_overlap: its own overlap.
[[nodiscard]] const Entry* best_peer(const Cell& cell, Against against = Against::all);

/// How many times as fast as the best peer a library is; nothing where there is none or where
/// the library's own time counts for nothing: a ratio at a wrong answer is void. Against::clock:
/// its millions of answers a second.
[[nodiscard]] std::optional<double> ratio(const Cell& cell, const std::string& library,
                                          Against against = Against::all);

/// The median of the ratios of several cells.
struct Median {
  std::size_t rows = 0;         ///< cells that have a peer to compare with
  std::optional<double> ratio;  ///< nothing without such cells, or where a ratio is void
};

[[nodiscard]] Median median_ratio(const std::vector<Cell>& cells, const MedianGoal& goal);

/// True if soms gave no wrong answer in any cell.
[[nodiscard]] bool sound(const std::vector<Cell>& cells);

}  // namespace soms::bench
