/// \file
/// The gap of a shown scene: how far its two bodies are from each other, and where they are
/// nearest.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/query/body.h"
#include "soms/query/distance.h"

#include "apps/view/scene/touch.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// Two bodies that share no point, and where they are nearest.
struct Gap {
  BodyRef a;
  BodyRef b;
  Distance distance;  ///< of `a` to `b`, complete and above 0; it names triangles and points

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

/// Keeps the last answer: asking again while nothing moved costs a comparison of poses.
class GapStore {
 public:
  using BodyOf = std::function<const Body&(BodyRef)>;

  /// Nothing where they share a point, or where a mesh is empty. \errors As `distance`.
  [[nodiscard]] const std::optional<Gap>& find(const GapQuestion& question, const BodyOf& body,
                                               const Parallel& parallel);

  /// How often bodies were asked for their distance.
  [[nodiscard]] std::uint64_t questions() const { return questions_; }

 private:
  std::optional<GapQuestion> question_;
  std::vector<Pose> poses_;
  std::optional<Gap> gap_;
  std::uint64_t questions_ = 0;
};

}  // namespace soms::view
