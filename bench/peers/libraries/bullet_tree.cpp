// Bullet's quantized tree, queried by boxes: the fixed triangles in the mover's box, and for each
// of them the mover's triangles in its box, finished by an exact triangle test. Stops at the first.
#include "bench/peers/libraries/bullet_mesh.h"
#include "bench/peers/libraries/triangle_test.h"

#include <utility>
#include <vector>

namespace soms::bench {

namespace {

struct Found final : btNodeOverlapCallback {
  std::vector<std::pair<int, int>> list;  // part, index

  void processNode(int part, int index) override { list.emplace_back(part, index); }
};

class TreeBody {
 public:
  explicit TreeBody(const FloatMesh& mesh) : mesh_(mesh), shape_(mesh_.arrays(), true) {
    shape_.setMargin(0);
  }

  [[nodiscard]] Triangle triangle(const std::pair<int, int>& id) const {
    return mesh_.triangle(id.first, id.second);
  }

  void within(const btVector3& lower, const btVector3& upper, Found& found) {
    found.list.clear();
    shape_.getOptimizedBvh()->reportAabbOverlappingNodex(&found, lower, upper);
  }

  void bounds(const Pose& pose, btVector3& lower, btVector3& upper) const {
    shape_.getAabb(to_bullet(pose), lower, upper);
  }

 private:
  BulletMesh mesh_;
  btBvhTriangleMeshShape shape_;
};

Vec3 moved_back(const Pose& pose, const Vec3& v) {
  const auto& m = pose.m;
  const Vec3 d = v - pose.shift();
  return {m[0] * d.x + m[4] * d.y + m[8] * d.z, m[1] * d.x + m[5] * d.y + m[9] * d.z,
          m[2] * d.x + m[6] * d.y + m[10] * d.z};
}

class TreeMatch final : public Match {
 public:
  TreeMatch(const FloatMesh& mover, const FloatMesh& fixed, const Loan& loan)
      : TreeMatch(mover, std::make_shared<TreeBody>(fixed), loan) {}

  TreeMatch(const FloatMesh& mover, std::shared_ptr<TreeBody> fixed, const Loan& loan)
      : mover_(mover), fixed_(std::move(fixed)), loan_(loan) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<TreeMatch>(mover, fixed_, loan_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i] = static_cast<double>(count(questions.poses[i], questions.job == Job::any));
    }
  }

 private:
  /// The mover's triangles in the box of a fixed triangle, seen from the mover. The box is grown by
  /// what rounding to float may take away.
  void beside(const Pose& pose, const Triangle& t) {
    const btVector3 a = to_bullet(moved_back(pose, t.a));
    const btVector3 b = to_bullet(moved_back(pose, t.b));
    const btVector3 c = to_bullet(moved_back(pose, t.c));
    btVector3 lower = a;
    btVector3 upper = a;
    lower.setMin(b);
    lower.setMin(c);
    upper.setMax(b);
    upper.setMax(c);
    const btScalar e = btScalar(2e-7) * (lower.absolute().length() + upper.absolute().length());
    mover_.within(lower - btVector3(e, e, e), upper + btVector3(e, e, e), met_);
  }

  std::uint64_t count(const Pose& pose, bool first_only) {
    btVector3 lower;
    btVector3 upper;
    mover_.bounds(pose, lower, upper);
    fixed_->within(lower, upper, near_);
    std::uint64_t count = 0;
    for (const auto& id : near_.list) {
      const Triangle t = fixed_->triangle(id);
      beside(pose, t);
      for (const auto& other : met_.list) {
        if (triangles_touch(moved(pose, mover_.triangle(other)), t, loan_)) {
          if (first_only) {
            return 1;
          }
          ++count;
        }
      }
    }
    return count;
  }

  TreeBody mover_;
  std::shared_ptr<TreeBody> fixed_;
  Loan loan_;
  Found near_;
  Found met_;
};

class BulletTree final : public Library {
 public:
  explicit BulletTree(const Loan& loan) : loan_(loan) {}

  [[nodiscard]] std::string name() const override { return "bullet-boxes"; }

  [[nodiscard]] std::string version() const override { return bullet_version(); }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::all; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<TreeMatch>(mover, fixed, loan_);
  }

 private:
  Loan loan_;
};

}  // namespace

void add_bullet_tree(Roster& roster, const Loan& loan) {
  roster.push_back(std::make_unique<BulletTree>(loan));
}

}  // namespace soms::bench

extern "C" void soms_bench_peer(soms::bench::Roster& roster, const soms::bench::Loan& loan) {
  soms::bench::add_bullet_tree(roster, loan);
  soms::bench::add_bullet_gimpact(roster, loan);
  soms::bench::add_bullet_moving_boxes(roster);
}
