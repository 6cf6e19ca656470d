/// \file
/// Deciding all pairs of parts of two sets, a block at a time.
#pragma once

#include "soms/clash/clash.h"

#include "apps/soms/clash/clash_models.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// What was decided, and the pairs that were.
struct ClashRun {
  std::vector<Clash> clashes;
  std::vector<PartNumbers> candidates;
  std::size_t done = 0;  ///< candidates that were looked at
  std::uint64_t compared = 0;
  std::uint64_t left = 0;
  std::size_t resumed = 0;  ///< candidates that a journal had
  bool interrupted = false;
  Cost cost;
};

/// Decides block after block, until all are done, a signal comes or time ends. With a `journal`,
/// begins where that ends, and adds each block to it.
/// \errors As `clashes_of` and `ClashJournal`.
[[nodiscard]] ClashRun decide_clashes(const ClashModels& models, const ClashOptions& options,
                                      const std::string& journal, const Console& console);

/// Compares every pair of parts that options want with brute force. Returns the number of pairs
/// that differ, each named on standard error. \pre All candidates were decided.
[[nodiscard]] std::uint64_t count_wrong_clashes(const ClashModels& models, const ClashRun& run,
                                                const ClashOptions& options, Console& console);

}  // namespace soms::command
