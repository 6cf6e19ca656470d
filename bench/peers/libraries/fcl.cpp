// FCL's mesh models in float, queried through its traversal nodes directly: what fcl::collide does
// for them after its dispatch, without the dispatch, and no contact points. Its dynamic tree of
// boxes as a broad phase.
#include "bench/peers/libraries/fcl_mesh.h"

namespace soms::bench {

namespace {

template <class Volume, class Traversal>
class FclMatch final : public Match {
 public:
  using Model = fcl::BVHModel<Volume>;

  FclMatch(const FloatMesh& mover, const FloatMesh& fixed)
      : FclMatch(mover, std::make_shared<Model>()) {
    fill(*fixed_, fixed);
  }

  FclMatch(const FloatMesh& mover, std::shared_ptr<Model> fixed) : fixed_(std::move(fixed)) {
    fill(mover_, mover);
  }

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<FclMatch>(mover, fixed_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    constexpr std::size_t kNoLimit = std::size_t{1} << 40;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      Traversal node;
      const fcl::CollisionRequest<float> request(questions.job == Job::any ? 1 : kNoLimit, false);
      fcl::CollisionResult<float> result;
      fcl::detail::initialize(node, mover_, placed<float>(questions.poses[i]), *fixed_,
                              fcl::Transform3f::Identity(), request, result);
      fcl::detail::collide(&node);
      answers[i] = static_cast<double>(result.numContacts());
    }
  }

 private:
  Model mover_;
  std::shared_ptr<Model> fixed_;
};

template <class FclPair>
class FclMesh final : public Library {
 public:
  explicit FclMesh(std::string name) : name_(std::move(name)) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::string version() const override { return FCL_VERSION; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::all; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<FclPair>(mover, fixed);
  }

 private:
  std::string name_;
};

using Object = fcl::CollisionObject<float>;

template <class Manager>
class FclMovingBoxes final : public MovingBoxes {
 public:
  explicit FclMovingBoxes(std::span<const FloatBox> boxes) {
    for (const FloatBox& b : boxes) {
      const auto shape = std::make_shared<fcl::Box<float>>(
          b.upper[0] - b.lower[0], b.upper[1] - b.lower[1], b.upper[2] - b.lower[2]);
      objects_.push_back(std::make_unique<Object>(shape));
      place(*objects_.back(), b);
      pointers_.push_back(objects_.back().get());
    }
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  std::uint64_t step(std::span<const FloatBox> boxes) override {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      place(*objects_[i], boxes[i]);
    }
    manager_.update();
    std::uint64_t count = 0;
    manager_.collide(&count, [](Object* a, Object* b, void* sink) {
      *static_cast<std::uint64_t*>(sink) += a->getAABB().overlap(b->getAABB()) ? 1 : 0;
      return false;
    });
    return count;
  }

 private:
  /// computeAABB() would recompute the box from center and sides, rounded; it is set as it is.
  static void place(Object& object, const FloatBox& b) {
    auto& box = const_cast<fcl::AABB<float>&>(object.getAABB());
    box.min_ = fcl::Vector3f(b.lower[0], b.lower[1], b.lower[2]);
    box.max_ = fcl::Vector3f(b.upper[0], b.upper[1], b.upper[2]);
  }

  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<Object*> pointers_;
  Manager manager_;
};

template <class Manager>
class FclBroad final : public Library {
 public:
  explicit FclBroad(std::string name) : name_(std::move(name)) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::string version() const override { return FCL_VERSION; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::broad; }

  [[nodiscard]] bool keeps_tree() const override { return true; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> boxes) const override {
    return std::make_unique<FclMovingBoxes<Manager>>(boxes);
  }

 private:
  std::string name_;
};

using Obb = FclMatch<fcl::OBB<float>, fcl::detail::MeshCollisionTraversalNodeOBB<float>>;
using ObbRss = FclMatch<fcl::OBBRSS<float>, fcl::detail::MeshCollisionTraversalNodeOBBRSS<float>>;
using Tree = fcl::DynamicAABBTreeCollisionManager<float>;
using TreeArray = fcl::DynamicAABBTreeCollisionManager_Array<float>;

}  // namespace

void add_fcl_overlap(Roster& roster) {
  roster.push_back(std::make_unique<FclMesh<Obb>>("fcl-obb"));
  roster.push_back(std::make_unique<FclMesh<ObbRss>>("fcl-obbrss"));
  roster.push_back(std::make_unique<FclBroad<Tree>>("fcl-dynamic-tree"));
  roster.push_back(std::make_unique<FclBroad<TreeArray>>("fcl-dynamic-array"));
}

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan&) {
  soms::bench::add_fcl_overlap(roster);
  soms::bench::add_fcl_distance(roster);
}
