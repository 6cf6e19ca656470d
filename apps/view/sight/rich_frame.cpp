#include "apps/view/sight/rich_frame.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace soms::view {

namespace {

constexpr std::uint64_t kEvenly = 48;

/// Steps through frames of a scene in any order, and keeps the richest.
class FrameSearch {
 public:
  FrameSearch(ViewScene& scene, std::uint64_t most, const Limits& limits)
      : scene_(scene), most_(most), limits_(limits) {}

  void look_at(std::uint64_t frame) {
    if (is_over() || !searched_.insert(frame).second) {
      return;
    }
    soms::check(limits_);
    scene_.go_to(frame);
    const std::size_t movers = touching_movers(scene_.contacts()).size();
    const std::pair here(movers, scene_.contacts().size());
    if (here > most_touching_) {
      most_touching_ = here;
      frame_ = frame;
    }
  }

  [[nodiscard]] bool is_over() const { return searched_.size() >= most_; }

  [[nodiscard]] bool found() const { return most_touching_.first > 0; }

  [[nodiscard]] std::uint64_t frame() const { return frame_; }

  [[nodiscard]] RichFrame result(std::uint64_t frames) const {
    return {frame_, most_touching_.first, frames, searched_.size()};
  }

 private:
  ViewScene& scene_;
  std::uint64_t most_;
  const Limits& limits_;
  std::set<std::uint64_t> searched_;
  std::pair<std::size_t, std::size_t> most_touching_{0, 0};
  std::uint64_t frame_ = 0;
};

}  // namespace

std::set<std::uint32_t> touching_movers(const std::vector<Touch>& touches) {
  std::set<std::uint32_t> touching;
  for (const Touch& touch : touches) {
    for (const BodyRef& body : {touch.a, touch.b}) {
      if (body.role == Role::mover) {
        touching.insert(body.index);
      }
    }
  }
  return touching;
}

RichFrame go_to_richest(ViewScene& scene, std::uint64_t frames, std::uint64_t most,
                        const Limits& limits) {
  FrameSearch search(scene, most, limits);
  std::uint64_t step = (frames + kEvenly - 1) / kEvenly;
  for (std::uint64_t frame = 0; frame < frames; frame += step) {
    search.look_at(frame);
  }
  for (; step > 1 && !search.found() && !search.is_over(); step = (step + 1) / 2) {
    const std::uint64_t half = (step + 1) / 2;
    for (std::uint64_t frame = 0; frame < frames && !search.is_over(); frame += half) {
      if (frame % step != 0) {
        search.look_at(frame);
      }
    }
  }
  while (search.found() && step > 1) {
    step /= 2;
    const std::uint64_t middle = search.frame();
    search.look_at(middle >= step ? middle - step : 0);
    search.look_at(std::min(middle + step, frames - 1));
  }
  scene.go_to(search.frame());
  return search.result(frames);
}

std::optional<std::uint64_t> nearest_touching_frame(ViewScene& scene, std::uint64_t frames,
                                                    const Limits& limits) {
  const std::uint64_t here = scene.frame();
  std::optional<std::uint64_t> nearest;
  const auto touches = [&](std::uint64_t frame) {
    soms::check(limits);
    scene.go_to(frame);
    return !scene.contacts().empty();
  };
  for (std::uint64_t off = 1; !nearest && (off <= here || here + off < frames); ++off) {
    if (off <= here && here - off < frames && touches(here - off)) {
      nearest = here - off;
    } else if (here + off < frames && touches(here + off)) {
      nearest = here + off;
    }
  }
  scene.go_to(here);
  return nearest;
}

}  // namespace soms::view
