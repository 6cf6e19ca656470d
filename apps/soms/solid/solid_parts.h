/// \file
/// `solid --by part`: the parts of two models, and how each pair of them stands to each other.
#pragma once

#include "soms/clash/part_bodies.h"
#include "soms/query/solid.h"

#include <chrono>
#include <vector>

namespace soms::command {

/// Two parts that are not clear of each other.
struct SolidPair {
  const PartBody* a;
  const PartBody* b;
  Solid answer;
};

/// The answer where one of two bodies is open: undecided, and whether their surfaces meet.
/// \errors As `overlap`.
[[nodiscard]] Solid open_answer(const Body& a, const Body& b, const Limits& limits = {});

/// The pairs of parts that are not clear, by part of a, then of b. An open part is undecided beside
/// every part whose box meets its own.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<SolidPair> solid_pairs(const std::vector<PartBody>& a, const Pose& pose_a,
                                                 const std::vector<PartBody>& b, const Pose& pose_b,
                                                 const Limits& limits);

}  // namespace soms::command
