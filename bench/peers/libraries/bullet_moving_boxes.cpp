// Bullet's dynamic tree: the leaves receive their new boxes, then the tree meets itself. Its boxes
// carry a margin in which a box may move for nothing; exactly overlapping pairs are counted. The
// broad phase of its physics loop (with a cache of pairs) is several times slower and left out.
#include "bench/peers/libraries/bullet_mesh.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

namespace soms::bench {

namespace {

class DbvtMovingBoxes final : public MovingBoxes, private btDbvt::ICollide {
 public:
  DbvtMovingBoxes(std::span<const FloatBox> boxes, btScalar margin) : margin_(margin) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      leaves_.push_back(tree_.insert(volume(boxes[i]), reinterpret_cast<void*>(i)));
    }
    tree_.optimizeTopDown();
  }

  std::uint64_t step(std::span<const FloatBox> boxes) override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      btDbvtVolume box = volume(boxes[i]);
      tree_.update(leaves_[i], box, margin_);
    }
    boxes_ = boxes;
    count_ = 0;
    tree_.collideTT(tree_.m_root, tree_.m_root, *this);
    return count_;
  }

 private:
  static btDbvtVolume volume(const FloatBox& b) {
    return btDbvtVolume::FromMM(to_bullet(b.lower), to_bullet(b.upper));
  }

  void Process(const btDbvtNode* a, const btDbvtNode* b) override {
    const auto number = [](const btDbvtNode* leaf) {
      return reinterpret_cast<std::size_t>(leaf->data);
    };
    count_ += a != b && overlaps(boxes_[number(a)], boxes_[number(b)]) ? 1U : 0U;
  }

  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;
  btScalar margin_;
  std::span<const FloatBox> boxes_;
  std::uint64_t count_ = 0;
};

class BulletBroad final : public Library {
 public:
  BulletBroad(std::string name, btScalar margin) : name_(std::move(name)), margin_(margin) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::string version() const override { return bullet_version(); }

  [[nodiscard]] bool does(Job job) const override { return job == Job::broad; }

  [[nodiscard]] bool keeps_tree() const override { return true; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> boxes) const override {
    return std::make_unique<DbvtMovingBoxes>(boxes, margin_);
  }

 private:
  std::string name_;
  btScalar margin_;
};

}  // namespace

void add_bullet_moving_boxes(Roster& roster) {
  roster.push_back(std::make_unique<BulletBroad>("bullet-dbvt-0.2m", btScalar(0.2)));
  roster.push_back(std::make_unique<BulletBroad>("bullet-dbvt-2m", btScalar(2)));
}

}  // namespace soms::bench
