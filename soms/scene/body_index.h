/// \file
/// Which of many bodies is nearest to a point, and which does a ray hit first?
///
/// \code
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const std::vector<soms::Body> bodies{soms::Body(ball, soms::Pose::translation(5, 0, 0)),
///                                      soms::Body(ball, soms::Pose::translation(0, 0, 3))};
/// const soms::BodyIndex index(bodies);
/// const soms::BodyClosest near = index.closest({0, 0, 0});
/// std::cout << "body " << *near.body << " is nearest, " << near.distance.lower << " away\n";
/// const soms::BodyHit hit = index.closest_hit(soms::Ray{{0, 0, 0}, {1, 0, 0}});
/// std::cout << "body " << *hit.body << " is hit first, at t = " << hit.t.lower << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// body 1 is nearest, 2 away
/// body 0 is hit first, at t = 4.01519
/// \endverbatim
#pragma once

#include "soms/query/body.h"
#include "soms/scene/body_queries.h"
#include "soms/scene/of_bodies.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace soms {

/// Which bodies take part in a query of many.
struct BodyFilter {
  /// This body does not: the one that looks, say. With RayOptions::skip, which is then a triangle
  /// of this body, only that triangle does not: the one that a reflected ray starts on.
  std::optional<std::uint32_t> except = std::nullopt;

  [[nodiscard]] bool operator==(const BodyFilter&) const = default;
};

/// Bodies at rest, and an index of their world boxes. Immutable; copies share everything. Its
/// queries are those of BodyQueries: `closest`, `closest_hit`, `any_hit` and `all_hits`.
///
/// \threads Any number of callers; batches are shared by as many threads as `Limits` says.
class BodyIndex : public BodyQueries<BodyIndex, std::uint32_t, BodyFilter> {
 public:
  /// No bodies.
  BodyIndex();

  /// Copies the bodies; shapes are shared. Their numbers are their places. A body without triangles
  /// keeps its number and is never met.
  /// \errors  As `overlap` for a pose, with the body named.
  /// \cost    O(n log n), n bodies.
  explicit BodyIndex(std::span<const Body> bodies);

  /// The number of bodies.
  [[nodiscard]] std::size_t size() const;

  /// \errors ErrorKind::usage for a body that is not there.
  [[nodiscard]] const Body& body(std::uint32_t number) const;

  /// Bytes held, shapes and names not counted.
  [[nodiscard]] std::size_t memory() const;

 private:
  friend BodyQueries<BodyIndex, std::uint32_t, BodyFilter>;
  struct Content;
  class View;
  [[nodiscard]] View view(const BodyFilter& filter) const;

  std::shared_ptr<const Content> content_;
};

}  // namespace soms
