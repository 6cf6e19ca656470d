/// \file
/// The referee's command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::bench {

struct Options {
  std::vector<std::string> scenes{"city-car", "city-drone", "streets", "knot"};
  std::uint64_t most = 1'000'000;  ///< larger scenes are left out
  int passes = 7;
  double judge = 2e9;  ///< pairs of triangles that brute force may look at in a set
  std::string out = "peers";
  std::string city;
  std::string mover;
};

/// Nothing when help was asked for; it was printed.
/// \errors  ErrorKind::usage.
[[nodiscard]] std::optional<Options> parse(int argc, char** argv);

}  // namespace soms::bench
