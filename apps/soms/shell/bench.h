/// \file
/// The verb `bench`: soms and the peers that are installed, on the user's own two models. It runs
/// a program of its own, soms-bench, so that the command never links a peer.
#pragma once

#include "apps/cli/verb.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `bench`.
struct BenchOptions {
  std::string a;
  std::string b;
  std::optional<std::string> pose;  ///< unset: random ones
  std::uint64_t random = 1000;
  std::uint64_t rounds = 7;
  std::string jobs = "any,all";
  std::string out;  ///< folder; empty: none
  bool strict = false;
};

[[nodiscard]] Action add_bench(Parser& parser, Shared& shared);
[[nodiscard]] int run_bench(const BenchOptions& options, Console& console);

/// The program soms-bench, sought as `find_program` does. \errors As there.
[[nodiscard]] std::filesystem::path bench_program();

}  // namespace soms::command
