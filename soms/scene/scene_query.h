/// \file
/// What queries of points and rays say of the bodies of a scene.
#pragma once

#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/scene/of_bodies.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <tuple>

namespace soms {

/// The list of a scene that a body is of.
enum class SceneBodyKind : std::uint8_t {
  environment,  ///< a part of the environment
  mover,
};

template <>
inline constexpr auto kWords<SceneBodyKind> = words("SceneBodyKind",
                                                    "Of which list of a scene a body is.",
                                                    "environment", "mover");

/// A body of a scene. Parts of the environment are before movers, then ids decide.
struct SceneBody {
  SceneBodyKind kind = SceneBodyKind::environment;
  std::uint32_t id = 0;  ///< an EnvironmentId or a MoverId

  [[nodiscard]] auto operator<=>(const SceneBody&) const = default;
};

template <>
struct Fields<SceneBody> {
  static constexpr const char* kName = "SceneBody";
  static constexpr const char* kMeaning = "A body of a scene.";
  static constexpr auto kList =
      std::tuple(field("kind", &SceneBody::kind, "Part of the environment, or mover."),
                 field("id", &SceneBody::id, "The number of the part, or of the mover."));
};

/// Which bodies of a scene take part in a query.
struct SceneFilter {
  bool environment = true;
  bool movers = true;
  /// As BodyFilter::except: the mover that looks, say, or with RayOptions::skip the body whose
  /// triangle a ray starts on.
  std::optional<SceneBody> except = std::nullopt;

  [[nodiscard]] bool operator==(const SceneFilter&) const = default;
};

/// The answers of a Scene name a body by its list and its id in that.
using SceneClosest = OfBodies<Closest, SceneBody>;
using SceneClosestBatch = OfBodies<ClosestBatch, SceneBody>;
using SceneHit = OfBodies<ClosestHit, SceneBody>;
using SceneHitBatch = OfBodies<ClosestHitBatch, SceneBody>;
using SceneAllHits = OfBodies<AllHits, SceneBody>;

template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<Closest, SceneBody> = {
    "SceneClosest", "Answer of closest about a Scene.", "SceneClosestBatch",
    "Answers of closest about a Scene."};
template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<ClosestHit, SceneBody> = {
    "SceneHit", "Answer of closest_hit about a Scene.", "SceneHitBatch",
    "Answers of closest_hit about a Scene."};
template <>
inline constexpr std::array<const char*, 4> kNamesOfBodies<AllHits, SceneBody> = {
    "SceneAllHits", "All places where n rays meet a scene."};

}  // namespace soms
