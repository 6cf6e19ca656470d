/// \file
/// One of several shares of the rows of a file, for one of several machines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soms::command {

/// Rows from `begin` to before `end`.
struct RowRange {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  [[nodiscard]] std::uint64_t size() const { return end - begin; }
};

/// Share `number`, from 1 on, of `of` shares.
struct Shard {
  std::uint64_t number = 1;
  std::uint64_t of = 1;

  /// Its rows of `rows`: all shares together are all rows, in order, and differ by a row at most.
  [[nodiscard]] RowRange rows_of(std::uint64_t rows) const;

  /// "3/8"
  [[nodiscard]] std::string text() const;
};

/// "3/8" as an option has it. \errors ErrorKind::usage.
[[nodiscard]] Shard parse_shard(std::string_view option, std::string_view text);

}  // namespace soms::command
