/// \file
/// The referee's command line.
#pragma once

#include "bench/peers/run.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soms::bench {

struct Options {
  RunOptions run;
  std::string caller = "soms-bench";  ///< what messages begin with
  bool quick = false;
  bool list = false;
  bool json = false;
  bool quiet = false;
  bool strict = false;              ///< of own files: what is noted or warned of is an error
  std::vector<std::string> scenes;  ///< names or beginnings of names; empty: all
  std::uint64_t least = 0;          ///< smaller scenes are left out
  std::uint64_t most = 5'000'000;   ///< larger scenes are left out
  int cpu = -1;                     ///< processor to run on; -1: the last
  std::filesystem::path data;       ///< models and cities; default SOMS_DATA
  std::filesystem::path out;        ///< folder of the results
  std::vector<std::string> files;   ///< two meshes of the user's own, or none
  std::vector<Pose> poses;          ///< of the first of them
  std::size_t random = 1000;        ///< poses, where none are given
  std::uint64_t seed = 1;           ///< of poses, points and rays
};

/// Nothing when help was requested, which was printed.
/// \errors  ErrorKind::usage; as `parse_pose` and `read_poses`.
[[nodiscard]] std::optional<Options> parse(int argc, char** argv);

}  // namespace soms::bench
