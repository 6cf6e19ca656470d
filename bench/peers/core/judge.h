/// \file
/// Who is right? Brute force, before any time counts.
#pragma once

#include "bench/peers/contestants/contestant.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::bench {

/// What the judge found about one contestant's answers to a set of poses.
struct Verdict {
  std::size_t checked = 0;  ///< poses that brute force decided
  std::size_t wrong = 0;    ///< of these, answered wrongly
  std::vector<std::size_t> wrong_poses;
};

/// Decides poses by brute force (`soms::reference`, no tree): every pose on which two contestants
/// differ, and as many others, evenly spread, as fit in about `budget` pairs of triangles.
[[nodiscard]] std::vector<Verdict> judge(const FloatMesh& mover, const FloatMesh& fixed,
                                         std::span<const Pose> poses,
                                         std::span<const std::vector<std::uint8_t>> answers,
                                         double budget);

}  // namespace soms::bench
