// FCL's two dynamic trees over box objects, in float.
#include "bench/peers/libraries/fcl_headers.h"
#include "bench/scene/broad_phase_peers.h"
#define extern
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>
#undef extern

namespace soms::bench {

namespace {

using Object = fcl::CollisionObject<float>;

template <class Manager>
class FclMovingBoxes final : public BroadPhasePeer {
 public:
  explicit FclMovingBoxes(std::span<const Box> boxes) {
    std::uintptr_t number = 0;
    for (const Box& box : boxes) {
      const Vec3 side = box.extent();
      objects_.push_back(std::make_unique<Object>(std::make_shared<fcl::Box<float>>(
          static_cast<float>(side.x), static_cast<float>(side.y), static_cast<float>(side.z))));
      objects_.back()->setUserData(reinterpret_cast<void*>(number++));
      place(*objects_.back(), box);
      pointers_.push_back(objects_.back().get());
    }
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  void step(std::span<const Box> boxes, PairList& pairs) override {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      place(*pointers_[k], boxes[k]);
    }
    manager_.update();
    manager_.collide(&pairs, [](Object* a, Object* b, void* sink) {
      if (a->getAABB().overlap(b->getAABB())) {
        static_cast<PairList*>(sink)->push_back(
            packed(reinterpret_cast<std::uintptr_t>(a->getUserData()),
                   reinterpret_cast<std::uintptr_t>(b->getUserData())));
      }
      return false;
    });
  }

 private:
  // As computeAABB() would, but to the very box instead of center and sides.
  static void place(Object& object, const Box& box) {
    auto& bounds = const_cast<fcl::AABB<float>&>(object.getAABB());
    for (int axis = 0; axis < 3; ++axis) {
      bounds.min_[axis] = static_cast<float>(box.lower[static_cast<std::size_t>(axis)]);
      bounds.max_[axis] = static_cast<float>(box.upper[static_cast<std::size_t>(axis)]);
    }
  }

  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<Object*> pointers_;
  Manager manager_;
};

template <class Manager>
std::unique_ptr<BroadPhasePeer> make(std::span<const Box> boxes) {
  return std::make_unique<FclMovingBoxes<Manager>>(boxes);
}

}  // namespace

void add_fcl(std::vector<BroadPhasePeerMaker>& makers) {
  makers.push_back({"fcl-dynamic-tree", true, &make<fcl::DynamicAABBTreeCollisionManager<float>>});
  makers.push_back(
      {"fcl-dynamic-array", true, &make<fcl::DynamicAABBTreeCollisionManager_Array<float>>});
}

}  // namespace soms::bench
