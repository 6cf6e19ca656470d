/// \file
/// The results: CSV for machines, Markdown for people.
#pragma once

#include "bench/peers/core/judge.h"
#include "bench/peers/core/timing.h"

#include <string>
#include <vector>

namespace soms::bench {

/// One contestant's figures.
struct Entry {
  std::string contestant;
  double build = 0;  ///< seconds to prepare both bodies
  Timing timing;
  Verdict verdict;
};

/// One set of poses in one scene, all contestants.
struct Cell {
  std::string scene;
  std::string set;
  std::size_t triangles = 0;  ///< of the body that stands still
  std::size_t mover = 0;      ///< triangles of the mover
  std::size_t poses = 0;
  std::size_t touching = 0;
  std::vector<Entry> entries;
};

/// A contestant wrong in more than this share of the checked poses is not ranked.
inline constexpr double kMostWrong = 0.02;

/// Median time of the fastest ranked entry whose name starts with `family`; 0 if there is none.
[[nodiscard]] double fastest(const Cell& cell, const std::string& family);

/// How many times faster than the fastest FCL a contestant is: 0 where there is no FCL, where
/// either is not ranked, or where soms gave a single wrong answer.
[[nodiscard]] double ratio(const Cell& cell, const std::string& contestant);

void write_csv(const std::string& path, const std::vector<Cell>& cells);
void write_markdown(const std::string& path, const std::vector<Cell>& cells, int passes);

}  // namespace soms::bench
