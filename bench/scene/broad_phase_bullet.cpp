// Bullet's dynamic tree: with its pair cache, as its worlds use it, and bare with two margins.
#include "bench/scene/broad_phase_peers.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

namespace soms::bench {

namespace {

btVector3 vector_of(const Vec3& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

std::uint64_t number_of(const void* data) {
  return reinterpret_cast<std::uintptr_t>(data);
}

void* data_of(std::size_t number) {
  return reinterpret_cast<void*>(number);
}

class CachedMovingBoxes final : public BroadPhasePeer {
 public:
  explicit CachedMovingBoxes(std::span<const Box> boxes) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      proxies_.push_back(phase_.createProxy(vector_of(boxes[k].lower), vector_of(boxes[k].upper), 0,
                                            data_of(k), 1, -1, nullptr));
    }
  }

  ~CachedMovingBoxes() override {
    for (btBroadphaseProxy* proxy : proxies_) {
      phase_.destroyProxy(proxy, nullptr);
    }
  }

  void step(std::span<const Box> boxes, PairList& pairs) override {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      phase_.setAabb(proxies_[k], vector_of(boxes[k].lower), vector_of(boxes[k].upper), nullptr);
    }
    phase_.calculateOverlappingPairs(nullptr);
    // The tree's boxes are larger: its pairs are decided here.
    const auto& cached = phase_.getOverlappingPairCache()->getOverlappingPairArray();
    for (int k = 0; k < cached.size(); ++k) {
      const std::uint64_t a = number_of(cached[k].m_pProxy0->m_clientObject);
      const std::uint64_t b = number_of(cached[k].m_pProxy1->m_clientObject);
      if (overlaps(boxes[a], boxes[b])) {
        pairs.push_back(packed(a, b));
      }
    }
  }

 private:
  btDbvtBroadphase phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

class TreeMovingBoxes final : public BroadPhasePeer {
 public:
  TreeMovingBoxes(std::span<const Box> boxes, btScalar margin) : margin_(margin) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      leaves_.push_back(tree_.insert(volume_of(boxes[k]), data_of(k)));
    }
    tree_.optimizeTopDown();
  }

  void step(std::span<const Box> boxes, PairList& pairs) override {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      btDbvtVolume volume = volume_of(boxes[k]);
      tree_.update(leaves_[k], volume, margin_);
    }
    Sink sink(boxes, pairs);
    tree_.collideTT(tree_.m_root, tree_.m_root, sink);
  }

 private:
  struct Sink final : btDbvt::ICollide {
    Sink(std::span<const Box> b, PairList& p) : boxes(b), pairs(p) {}

    void Process(const btDbvtNode* x, const btDbvtNode* y) override {
      const std::uint64_t a = number_of(x->data);
      const std::uint64_t b = number_of(y->data);
      if (a != b && overlaps(boxes[a], boxes[b])) {
        pairs.push_back(packed(a, b));
      }
    }

    std::span<const Box> boxes;
    PairList& pairs;
  };

  static btDbvtVolume volume_of(const Box& box) {
    return btDbvtVolume::FromMM(vector_of(box.lower), vector_of(box.upper));
  }

  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;
  btScalar margin_;
};

}  // namespace

void add_bullet(std::vector<BroadPhasePeerMaker>& makers) {
  makers.push_back({"bullet-dbvt-cache", true, [](std::span<const Box> boxes) {
                      return std::unique_ptr<BroadPhasePeer>(
                          std::make_unique<CachedMovingBoxes>(boxes));
                    }});
  makers.push_back({"bullet-dbvt-0.2m", true, [](std::span<const Box> boxes) {
                      return std::unique_ptr<BroadPhasePeer>(
                          std::make_unique<TreeMovingBoxes>(boxes, btScalar(0.2)));
                    }});
  makers.push_back({"bullet-dbvt-2m", true, [](std::span<const Box> boxes) {
                      return std::unique_ptr<BroadPhasePeer>(
                          std::make_unique<TreeMovingBoxes>(boxes, btScalar(2)));
                    }});
}

}  // namespace soms::bench
