// FCL's broad phase, two dynamic trees against each other, and its mesh models for each pair whose
// boxes meet, up to the first contact; in float. ifcclash did so until 2023, by HPP-FCL, a fork of
// FCL, with OBB (its collider.py), but searched a tree of boxes element by element in Python.
#include "bench/clash/clash_peers.h"
#include "bench/peers/libraries/fcl_mesh.h"

namespace soms::bench {

namespace {

using FclObject = fcl::CollisionObject<float>;

template <class Volume, class Traversal>
class FclClash final : public ClashPeer {
 public:
  FclClash(std::span<const FloatMesh> a, std::span<const FloatMesh> b) : a_(a), b_(b) {}

  void find(PartPairs& pairs) override {
    Found found{pairs};
    a_.manager.collide(&b_.manager, &found, &decide);
  }

 private:
  struct Set {
    explicit Set(std::span<const FloatMesh> parts) {
      std::vector<FclObject*> pointers;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        models.push_back(std::make_shared<fcl::BVHModel<Volume>>());
        fill(*models.back(), parts[k]);
        models.back()->computeLocalAABB();
        objects.push_back(std::make_unique<FclObject>(models.back()));
        objects.back()->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(k)));
        pointers.push_back(objects.back().get());
        place(*objects.back(), *models.back());
      }
      manager.registerObjects(pointers);
      manager.setup();
    }

    // FCL would take a cube around the sphere that holds the part; its very box is better.
    static void place(FclObject& object, const fcl::BVHModel<Volume>& model) {
      const_cast<fcl::AABB<float>&>(object.getAABB()) = model.aabb_local;
    }

    std::vector<std::shared_ptr<fcl::BVHModel<Volume>>> models;
    std::vector<std::unique_ptr<FclObject>> objects;
    fcl::DynamicAABBTreeCollisionManager<float> manager;
  };

  struct Found {
    PartPairs& pairs;
  };

  static const fcl::BVHModel<Volume>& model(const FclObject& object) {
    return static_cast<const fcl::BVHModel<Volume>&>(*object.collisionGeometry());
  }

  static bool decide(FclObject* a, FclObject* b, void* sink) {
    if (!a->getAABB().overlap(b->getAABB())) {
      return false;
    }
    Traversal node;
    const fcl::CollisionRequest<float> request(1, false);
    fcl::CollisionResult<float> result;
    fcl::detail::initialize(node, model(*a), fcl::Transform3f::Identity(), model(*b),
                            fcl::Transform3f::Identity(), request, result);
    fcl::detail::collide(&node);
    if (result.isCollision()) {
      static_cast<Found*>(sink)->pairs.emplace_back(
          static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(a->getUserData())),
          static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(b->getUserData())));
    }
    return false;
  }

  Set a_;
  Set b_;
};

template <class Clash>
std::unique_ptr<ClashPeer> make_fcl(std::span<const FloatMesh> a, std::span<const FloatMesh> b,
                                    const Loan&) {
  return std::make_unique<Clash>(a, b);
}

}  // namespace

void add_fcl_clash(std::vector<ClashPeerMaker>& makers) {
  using Obb = FclClash<fcl::OBB<float>, fcl::detail::MeshCollisionTraversalNodeOBB<float>>;
  using ObbRss = FclClash<fcl::OBBRSS<float>, fcl::detail::MeshCollisionTraversalNodeOBBRSS<float>>;
  makers.push_back({"fcl-obb", &make_fcl<Obb>});
  makers.push_back({"fcl-obbrss", &make_fcl<ObbRss>});
}

}  // namespace soms::bench
