/// \file
/// What queries of points and rays say of the bodies of a scene.
#pragma once

#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/closest.h"
#include "soms/query/ray.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

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

/// The nearest point of a scene, as BodyClosest.
struct SceneClosest : Closest {
  std::optional<SceneBody> body = std::nullopt;

  [[nodiscard]] bool operator==(const SceneClosest&) const = default;
};

/// Answers for a batch of points, as BodyClosestBatch.
struct SceneClosestBatch : ClosestBatch {
  std::vector<std::optional<SceneBody>> body;  ///< n

  [[nodiscard]] bool operator==(const SceneClosestBatch&) const = default;

  /// The answer for a point.
  [[nodiscard]] SceneClosest at(std::size_t point) const;
};

template <>
struct Fields<SceneClosest> {
  static constexpr const char* kName = "SceneClosest";
  static constexpr const char* kMeaning = "Answer of closest about a Scene.";
  static constexpr const char* kBatchName = "SceneClosestBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest about a Scene.";
  static constexpr const char* kRows = "points";
  using Base = Closest;
  using Batch = SceneClosestBatch;
  static constexpr auto kList =
      std::tuple(field("body", &SceneClosest::body, &Batch::body, "Which body it is."));
};

/// The first hit of a ray in a scene, as BodyHit.
struct SceneHit : ClosestHit {
  std::optional<SceneBody> body = std::nullopt;

  [[nodiscard]] bool operator==(const SceneHit&) const = default;
};

/// Answers for a batch of rays, as BodyHitBatch.
struct SceneHitBatch : ClosestHitBatch {
  std::vector<std::optional<SceneBody>> body;  ///< n

  [[nodiscard]] bool operator==(const SceneHitBatch&) const = default;

  /// The answer for a ray.
  [[nodiscard]] SceneHit at(std::size_t ray) const;
};

template <>
struct Fields<SceneHit> {
  static constexpr const char* kName = "SceneHit";
  static constexpr const char* kMeaning = "Answer of closest_hit about a Scene.";
  static constexpr const char* kBatchName = "SceneHitBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest_hit about a Scene.";
  static constexpr const char* kRows = "rays";
  using Base = ClosestHit;
  using Batch = SceneHitBatch;
  static constexpr auto kList =
      std::tuple(field("body", &SceneHit::body, &Batch::body, "Which body it is."));
};

/// All places where rays meet a scene, as BodyAllHits.
struct SceneAllHits : AllHits {
  std::vector<SceneBody> body = {};  ///< m

  [[nodiscard]] bool operator==(const SceneAllHits&) const = default;
};

template <>
struct Fields<SceneAllHits> {
  static constexpr const char* kName = "SceneAllHits";
  static constexpr const char* kMeaning = "All places where n rays meet a scene.";
  using Base = AllHits;
  static constexpr auto kList =
      std::tuple(list("body", &SceneAllHits::body, "m", "The body of each crossing."));
};

}  // namespace soms
