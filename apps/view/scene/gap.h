/// \file
/// The gap of a shown scene: how far its two bodies are from each other, and where they are
/// nearest.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/query/body.h"
#include "soms/query/distance.h"

#include "apps/view/scene/touch.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

/// Two bodies that share no point, and where they are nearest.
struct Gap {
  BodyRef a;
  BodyRef b;
  Distance distance;  ///< of `a` to `b`, above 0; it names triangles and points

  /// False where time ran out: then they are at most as far apart as `distance.distance.upper`.
  [[nodiscard]] bool known() const { return distance.coverage == Coverage::complete; }

  [[nodiscard]] bool operator==(const Gap&) const = default;
};

/// As it is written beside its line: four digits.
[[nodiscard]] std::string length_in_text(const Gap& gap);

/// The middle of a gap and what is worth seeing around it: all of the segment, and enough of the
/// bodies to tell what is near what. `a` and `b` are the bodies' bounds, `scene` those of all.
[[nodiscard]] Box surroundings(const Gap& gap, const Box& a, const Box& b, const Box& scene);

/// Bodies whose gap is sought: the nearest of `a` to `b`; of equally near ones the first.
struct GapQuestion {
  std::vector<BodyRef> a;
  BodyRef b;

  [[nodiscard]] bool operator==(const GapQuestion&) const = default;
};

/// Whose gap a scene shows: that of its pair, for a part of the city with all of the city; without
/// movers that of the parts of a city of two. Nothing of other scenes, and where `touches`, which
/// are sorted, say that they touch.
[[nodiscard]] std::optional<GapQuestion> gap_question(
    const std::optional<std::pair<BodyRef, BodyRef>>& pair, std::uint32_t city_parts,
    std::uint32_t movers, std::span<const Touch> touches);

/// Keeps the last answer: a query again while nothing moved costs a comparison of poses.
class GapStore {
 public:
  using BodyOf = std::function<const Body&(BodyRef)>;
  using Patience = std::optional<std::chrono::steady_clock::duration>;

  /// Ends a search after this time, whose answer may not be `known` then; nothing: never.
  void set_patience(Patience patience) { patience_ = patience; }

  /// Nothing where they share a point, or where a mesh is empty. \errors As `distance`.
  [[nodiscard]] const std::optional<Gap>& find(const GapQuestion& question, const BodyOf& body,
                                               const Limits& limits);

  /// Distance queries so far.
  [[nodiscard]] std::uint64_t queries() const { return queries_; }

 private:
  std::optional<GapQuestion> question_;
  std::vector<Pose> poses_;
  std::optional<Gap> gap_;
  std::uint64_t queries_ = 0;
  Patience patience_;
};

}  // namespace soms::view
