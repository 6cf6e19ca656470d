// CGAL's box_self_intersection_d, which keeps nothing from step to step.
#include "bench/scene/broad_phase_peers.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <cstddef>

namespace soms::bench {

namespace {

class CgalMovingBoxes final : public BroadPhasePeer {
 public:
  void step(std::span<const Box> boxes, PairList& pairs) override {
    boxes_.clear();
    order_.clear();
    std::uint64_t number = 0;
    for (const Box& box : boxes) {
      float lower[3];
      float upper[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lower[axis] = static_cast<float>(box.lower[axis]);
        upper[axis] = static_cast<float>(box.upper[axis]);
      }
      boxes_.emplace_back(lower, upper, number++);
    }
    for (Entry& entry : boxes_) {  // pointers are sorted faster than boxes
      order_.push_back(&entry);
    }
    CGAL::box_self_intersection_d(
        order_.begin(), order_.end(),
        [&](const Entry* a, const Entry* b) { pairs.push_back(packed(a->info(), b->info())); },
        std::ptrdiff_t(100));
  }

 private:
  using Entry = CGAL::Box_intersection_d::Box_with_info_d<float, 3, std::uint64_t>;

  std::vector<Entry> boxes_;
  std::vector<Entry*> order_;
};

}  // namespace

void add_cgal(std::vector<BroadPhasePeerMaker>& makers) {
  makers.push_back({"cgal-box", false, [](std::span<const Box>) {
                      return std::unique_ptr<BroadPhasePeer>(std::make_unique<CgalMovingBoxes>());
                    }});
}

}  // namespace soms::bench
