/// \file
/// How near two surfaces are, as text: what `distance` and `within` print alike.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/answer.h"

#include "apps/soms/pairs/pair_report.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

/// The triangles that an answer names, and the points on them that are near.
struct NearPair {
  std::optional<TrianglePair> triangles;
  Vec3 point_a;
  Vec3 point_b;
};

/// ": triangle 3 (wall) of a.ply at (0, 0, 1) and triangle 5 of b.ply at (0, 0, 2)"; nothing where
/// no pair is named.
[[nodiscard]] std::string near_text(const PairReport& report, const NearPair& pair);

/// The table of many poses for people: its titles, of which `title` is that of the values, and the
/// row of a pose.
[[nodiscard]] std::string near_head(std::string_view title);
[[nodiscard]] std::string near_row(const PairReport& report, std::uint64_t pose,
                                   std::string_view value, const NearPair& pair);

}  // namespace soms::command
