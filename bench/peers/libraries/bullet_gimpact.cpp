// Bullet's GImpact: its two box trees against each other give the pairs of triangles with
// overlapping boxes (no early stop); the exact test decides them, since Bullet's own works with a
// margin and would answer otherwise.
#include "bench/peers/libraries/bullet_mesh.h"
#include "bench/peers/libraries/triangle_test.h"

#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <utility>

namespace soms::bench {

namespace {

class GimpactBody {
 public:
  explicit GimpactBody(const FloatMesh& mesh) : mesh_(mesh), part_(mesh_.arrays(), 0) {
    part_.setMargin(0);
    part_.updateBound();  // builds the tree
  }

  [[nodiscard]] const btGImpactBoxSet* tree() { return part_.getBoxSet(); }

  [[nodiscard]] Triangle triangle(int index) const { return mesh_.triangle(0, index); }

 private:
  BulletMesh mesh_;
  btGImpactMeshShapePart part_;
};

class GimpactMatch final : public Match {
 public:
  GimpactMatch(const FloatMesh& mover, const FloatMesh& fixed, const Loan& loan)
      : GimpactMatch(mover, std::make_shared<GimpactBody>(fixed), loan) {}

  GimpactMatch(const FloatMesh& mover, std::shared_ptr<GimpactBody> fixed, const Loan& loan)
      : mover_(mover), fixed_(std::move(fixed)), loan_(loan) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<GimpactMatch>(mover, fixed_, loan_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      btPairSet candidates;
      btGImpactBoxSet::find_collision(mover_.tree(), to_bullet(questions.poses[i]), fixed_->tree(),
                                      btTransform::getIdentity(), candidates);
      std::uint64_t count = 0;
      for (int k = 0; k < candidates.size() && !(questions.job == Job::any && count != 0); ++k) {
        count += triangles_touch(moved(questions.poses[i], mover_.triangle(candidates[k].m_index1)),
                                 fixed_->triangle(candidates[k].m_index2), loan_)
                     ? 1U
                     : 0U;
      }
      answers[i] = static_cast<double>(count);
    }
  }

 private:
  GimpactBody mover_;
  std::shared_ptr<GimpactBody> fixed_;
  Loan loan_;
};

class BulletGimpact final : public Library {
 public:
  explicit BulletGimpact(const Loan& loan) : loan_(loan) {}

  [[nodiscard]] std::string name() const override { return "bullet-gimpact"; }

  [[nodiscard]] std::string version() const override { return bullet_version(); }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::all; }

  [[nodiscard]] bool takes(std::size_t triangles) const override {
    return triangles <= BulletMesh::kPart;
  }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<GimpactMatch>(mover, fixed, loan_);
  }

 private:
  Loan loan_;
};

}  // namespace

void add_bullet_gimpact(Roster& roster, const Loan& loan) {
  roster.push_back(std::make_unique<BulletGimpact>(loan));
}

}  // namespace soms::bench
