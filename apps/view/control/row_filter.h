/// \file
/// The rows of the list of events that have the words searched for.
#pragma once

#include "apps/view/control/subject.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::view {

/// Keeps its choice from frame to frame: a row is looked at once, until other words are wanted.
class RowFilter {
 public:
  /// Takes in the rows that came since the last call; all of them where the words or the edition
  /// changed. Returns how many it looked at.
  std::size_t update(const EventList& list, const std::string& wanted);

  /// Numbers of the rows whose titles have all words wanted, in order.
  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }

 private:
  std::vector<std::size_t> rows_;
  std::string wanted_;
  std::uint64_t edition_ = 0;
  std::size_t looked_at_ = 0;
};

}  // namespace soms::view
