// FCL's mesh models in float, queried through its traversal nodes directly: what fcl::collide does
// for them after its dispatch, without the dispatch, and no contact points. Its dynamic tree of
// boxes as a broad phase.
#include "bench/peers/libraries/fcl_headers.h"
#include "bench/peers/libraries/library.h"

namespace soms::bench {

namespace {

template <class Volume>
void fill(fcl::BVHModel<Volume>& model, const FloatMesh& mesh) {
  std::vector<fcl::Vector3f> points;
  points.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    points.emplace_back(v[0], v[1], v[2]);
  }
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  model.addSubModel(points, triangles);
  model.endModel();
}

fcl::Transform3f placed(const Pose& pose) {
  fcl::Transform3f transform = fcl::Transform3f::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      transform.linear()(i, j) = static_cast<float>(pose.m[static_cast<std::size_t>(4 * i + j)]);
    }
    transform.translation()(i) = static_cast<float>(pose.m[static_cast<std::size_t>(4 * i + 3)]);
  }
  return transform;
}

template <class Volume, class Traversal>
class FclMatch final : public Match {
 public:
  FclMatch(const FloatMesh& mover, const FloatMesh& fixed) {
    fill(mover_, mover);
    fill(fixed_, fixed);
  }

  void answer(Job job, std::span<const Pose> poses, std::span<std::uint64_t> answers) override {
    constexpr std::size_t kNoLimit = std::size_t{1} << 40;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      Traversal node;
      const fcl::CollisionRequest<float> request(job == Job::any ? 1 : kNoLimit, false);
      fcl::CollisionResult<float> result;
      fcl::detail::initialize(node, mover_, placed(poses[i]), fixed_, fcl::Transform3f::Identity(),
                              request, result);
      fcl::detail::collide(&node);
      answers[i] = result.numContacts();
    }
  }

 private:
  fcl::BVHModel<Volume> mover_;
  fcl::BVHModel<Volume> fixed_;
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

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan&) {
  using namespace soms::bench;
  roster.push_back(std::make_unique<FclMesh<Obb>>("fcl-obb"));
  roster.push_back(std::make_unique<FclMesh<ObbRss>>("fcl-obbrss"));
  roster.push_back(std::make_unique<FclBroad<Tree>>("fcl-dynamic-tree"));
  roster.push_back(std::make_unique<FclBroad<TreeArray>>("fcl-dynamic-array"));
}
