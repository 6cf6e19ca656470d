// FCL's mesh models, asked through its traversal nodes directly: what fcl::collide does for them
// after its dispatch, without the dispatch. First contact only, no contact points.
#include "bench/peers/contestants/contestant.h"
#include "bench/peers/contestants/fcl_headers.h"

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

  void any(std::span<const Pose> poses, std::span<std::uint8_t> touches) override {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      Traversal node;
      const fcl::CollisionRequest<float> request(1, false);
      fcl::CollisionResult<float> result;
      fcl::detail::initialize(node, mover_, placed(poses[i]), fixed_, fcl::Transform3f::Identity(),
                              request, result);
      fcl::detail::collide(&node);
      touches[i] = result.numContacts() > 0 ? 1 : 0;
    }
  }

 private:
  fcl::BVHModel<Volume> mover_;
  fcl::BVHModel<Volume> fixed_;
};

template <class FclPair>
class Fcl final : public Contestant {
 public:
  explicit Fcl(std::string name) : name_(std::move(name)) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<FclPair>(mover, fixed);
  }

 private:
  std::string name_;
};

using Obb = FclMatch<fcl::OBB<float>, fcl::detail::MeshCollisionTraversalNodeOBB<float>>;
using ObbRss = FclMatch<fcl::OBBRSS<float>, fcl::detail::MeshCollisionTraversalNodeOBBRSS<float>>;

}  // namespace

}  // namespace soms::bench

extern "C" void soms_bench_fcl(soms::bench::Roster& roster) {
  using namespace soms::bench;
  roster.push_back(std::make_unique<Fcl<Obb>>("fcl-obb"));
  roster.push_back(std::make_unique<Fcl<ObbRss>>("fcl-obbrss"));
}
