#include "soms/scene/body_index.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/detail/residents.h"
#include "soms/scene/detail/search/answer_queries.h"

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

/// The bodies that take part in a query; a body's name is its number in the search.
class BodyIndex::View {
 public:
  View(const Content& content, const BodyFilter& filter) : content_(content), filter_(filter) {}

  [[nodiscard]] detail::BodySets sets() const { return content_.sets; }

  [[nodiscard]] detail::LeftOut left_out() const { return filter_.except; }

  [[nodiscard]] const RayOptions& options(const RayOptions& options) const { return options; }

  template <class Answer>
  [[nodiscard]] Answer named(Answer found) const {
    return found;
  }

 private:
  const Content& content_;
  const BodyFilter& filter_;
};

BodyIndex::View BodyIndex::view(const BodyFilter& filter) const {
  return {*content_, filter};
}

template class BodyQueries<BodyIndex, std::uint32_t, BodyFilter>;

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

}  // namespace soms
