#include "thesis/races/until_hit.h"

namespace soms::reproduce {

namespace {

/// Watches one frame until its hit.
class Watcher {
 public:
  Watcher(const MovedTrip& moved, Hit hit, bool stops) : moved_(moved), hit_(hit), stops_(stops) {}

  /// Traverses a frame; true if it has a hit.
  [[nodiscard]] bool look(FrameTraversal& traversal, std::size_t frame) {
    box_tests = entered = 0;
    found_ = false;
    const TraversalVisitor visitor{.leaf_pair =
                                       [&](NodePair leaves) {
                                         found_ = found_ || hit_ == Hit::leaf_pair ||
                                                  moved_.contacts(frame, leaves, 1) > 0;
                                         return !(found_ && stops_);
                                       },
                                   .tested = [&](NodePair, bool) { box_tests += found_ ? 0U : 1U; },
                                   .entered = [&](NodePair) { entered += found_ ? 0U : 1U; }};
    traversal.run(frame, visitor);
    return found_;
  }

  std::uint64_t box_tests = 0;
  std::uint64_t entered = 0;

 private:
  const MovedTrip& moved_;
  Hit hit_;
  bool stops_;
  bool found_ = false;
};

}  // namespace

UntilHit until_hit(const MovedTrip& moved, const TripRacer& racer, Hit hit, bool stops,
                   std::span<const std::size_t> frames, const Limits& limits) {
  FrameTraversal traversal(moved, racer);
  Watcher watcher(moved, hit, stops);
  UntilHit sum;
  for (const std::size_t k : frames) {
    check_stop(limits);
    if (watcher.look(traversal, k)) {
      sum.box_tests += watcher.box_tests;
      sum.entered += watcher.entered;
      sum.frames.push_back(k);
    }
  }
  return sum;
}

}  // namespace soms::reproduce
