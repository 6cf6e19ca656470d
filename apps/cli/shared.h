/// \file
/// Options that every verb has.
#pragma once

#include "soms/base/error.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

class Parser;

/// Heading of the options that every verb has.
inline constexpr const char* kSharedGroup = "Shared options";

/// Values of the options that every verb has.
struct Shared {
  bool json = false;
  bool quiet = false;
  int threads = 0;  ///< 0: one for each processor
  std::uint64_t seed = 1;
  std::optional<double> timeout = std::nullopt;  ///< seconds
  std::uint64_t max_memory = 0;                  ///< bytes; 0: no limit of ours
};

/// Adds --help.
void add_help_option(Parser& parser);

/// Adds --json, --quiet, --threads, --seed, --timeout and --max-memory.
void add_shared_options(Parser& parser, Shared& shared);

/// A number of bytes as --max-memory takes it: "200M".
[[nodiscard]] std::string size_words(std::uint64_t bytes);

/// What a verb says when memory ran out: of the limit, where there is one, else of the machine.
/// `place` names what it was needed for, and may be empty.
[[nodiscard]] Error out_of_memory(const Shared& shared, const std::string& place = {});

}  // namespace soms::command
