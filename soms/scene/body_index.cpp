#include "soms/scene/body_index.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/describe/columns.h"
#include "soms/scene/detail/residents.h"
#include "soms/scene/detail/search/body_search.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace soms {

struct BodyIndex::Content {
  std::vector<Body> bodies;
  detail::BodySet set;
  std::array<const detail::BodySet*, 1> sets = {&set};

  Content() = default;
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  ~Content() = default;
};

BodyClosest BodyClosestBatch::at(std::size_t i) const {
  return row_of<BodyClosest>(*this, i);
}

BodyHit BodyHitBatch::at(std::size_t i) const {
  return row_of<BodyHit>(*this, i);
}

BodyIndex::BodyIndex() : BodyIndex(std::span<const Body>()) {
}

BodyIndex::BodyIndex(std::span<const Body> bodies) {
  const PlainArithmetic plain;
  if (bodies.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::out_of_range, "body index: 2^32 bodies or more", "make several indexes");
  }
  auto content = std::make_shared<Content>();
  content->bodies.assign(bodies.begin(), bodies.end());
  std::vector<const Body*> places;
  std::vector<Box> boxes;
  for (const Body& body : content->bodies) {
    boxes.push_back(detail::world_box(body, body.shape, body.pose, "body",
                                      static_cast<std::uint32_t>(places.size())));
    places.push_back(&body);
  }
  content->set.build(std::move(places), boxes);
  content_ = std::move(content);
}

std::size_t BodyIndex::size() const {
  return content_->bodies.size();
}

const Body& BodyIndex::body(std::uint32_t number) const {
  if (number >= size()) {
    throw Error(ErrorKind::usage, "body index: there is no body " + std::to_string(number),
                "bodies are numbered from 0");
  }
  return content_->bodies[number];
}

std::size_t BodyIndex::memory() const {
  return sizeof(Content) + detail::bytes(content_->bodies) + content_->set.memory();
}

BodyClosest BodyIndex::closest(const Vec3& point, const ClosestOptions& options,
                               const BodyFilter& filter, const Limits& limits) const {
  return detail::closest(content_->sets, point, options, filter.except, limits);
}

BodyClosestBatch BodyIndex::closest(std::span<const Vec3> points, const ClosestOptions& options,
                                    const BodyFilter& filter, const Limits& limits) const {
  return detail::closest(content_->sets, points, options, filter.except, limits);
}

BodyHit BodyIndex::closest_hit(const Ray& ray, const RayOptions& options, const BodyFilter& filter,
                               const Limits& limits) const {
  return detail::closest_hit(content_->sets, ray, options, filter.except, limits);
}

BodyHitBatch BodyIndex::closest_hit(std::span<const Ray> rays, const RayOptions& options,
                                    const BodyFilter& filter, const Limits& limits) const {
  return detail::closest_hit(content_->sets, rays, options, filter.except, limits);
}

AnyHit BodyIndex::any_hit(const Ray& ray, const RayOptions& options, const BodyFilter& filter,
                          const Limits& limits) const {
  return detail::any_hit(content_->sets, ray, options, filter.except, limits);
}

AnyHitBatch BodyIndex::any_hit(std::span<const Ray> rays, const RayOptions& options,
                               const BodyFilter& filter, const Limits& limits) const {
  return detail::any_hit(content_->sets, rays, options, filter.except, limits);
}

BodyAllHits BodyIndex::all_hits(std::span<const Ray> rays, const RayOptions& options,
                                const BodyFilter& filter, const Limits& limits) const {
  return detail::all_hits(content_->sets, rays, options, filter.except, limits);
}

}  // namespace soms
