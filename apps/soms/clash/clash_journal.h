/// \file
/// What was decided so far of a long clash run, kept in a file, so that the run can go on.
#pragma once

#include "soms/clash/clash.h"

#include "apps/soms/clash/clash_models.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

/// Clashes among the first `done` candidates.
struct DecidedClashes {
  std::vector<Clash> clashes;
  std::size_t done = 0;
  Cost cost;
};

/// A file of lines: a head that names the inputs, then a line for each block of candidates. A line
/// that was cut off while it was written, and what follows it, is dropped.
class ClashJournal {
 public:
  /// Opens the file, or makes it.
  /// \errors ErrorKind::usage where it belongs to other models or options; bad_file where it is no
  ///         journal; cannot_open, cannot_write.
  ClashJournal(std::string file, const ClashModels& models, const ClashOptions& options,
               std::span<const PartNumbers> candidates);

  /// What the file holds.
  [[nodiscard]] const DecidedClashes& kept() const { return kept_; }

  /// Adds a block whose pairs are all decided. When it returns, the operating system has it.
  /// \errors ErrorKind::cannot_write.
  void add(std::size_t done, const ClashList& block);

 private:
  void read(std::ifstream& in, const std::string& head, const ClashModels& models,
            std::size_t candidates);

  std::string file_;
  DecidedClashes kept_;
  std::ofstream out_;
};

}  // namespace soms::command
