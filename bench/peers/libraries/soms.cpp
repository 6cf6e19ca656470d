// soms as its users have it: through the installed facade, and nothing else of it.
#include "soms/soms.h"

#include "bench/peers/libraries/library.h"

namespace soms::bench {

namespace {

Shape shape_of(const FloatMesh& mesh) {
  Mesh wide;
  wide.vertices.reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    wide.vertices.push_back({v[0], v[1], v[2]});
  }
  wide.triangles = mesh.triangles;
  return Shape(std::move(wide));
}

constexpr OverlapOptions kAny{.mode = OverlapMode::any};

class SomsMatch final : public Match {
 public:
  SomsMatch(const FloatMesh& mover, const FloatMesh& fixed, bool batch)
      : mover_(shape_of(mover)), fixed_(shape_of(fixed)), batch_(batch) {}

  void answer(Job job, std::span<const Pose> poses, std::span<std::uint64_t> answers) override {
    if (batch_) {
      const OverlapBatch found = overlap(mover_.shape, poses, fixed_, kAny);
      std::copy(found.any.begin(), found.any.end(), answers.begin());
      return;
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
      mover_.pose = poses[i];
      answers[i] = job == Job::any ? (overlap(mover_, fixed_, kAny).any ? 1U : 0U)
                                   : overlap(mover_, fixed_).pairs.size();
    }
  }

 private:
  Body mover_;
  Body fixed_;
  bool batch_;
};

class SomsMovingBoxes final : public MovingBoxes {
 public:
  std::uint64_t step(std::span<const FloatBox> boxes) override {
    boxes_.clear();
    for (const FloatBox& box : boxes) {
      boxes_.push_back(
          {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}});
    }
    return phase_.find(boxes_).size();
  }

 private:
  std::vector<Box> boxes_;
  BroadPhase phase_;
};

class Soms final : public Library {
 public:
  explicit Soms(bool batch) : batch_(batch) {}

  [[nodiscard]] std::string name() const override { return batch_ ? "soms-batch" : "soms"; }

  [[nodiscard]] std::string version() const override { return SOMS_VERSION; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || !batch_; }

  [[nodiscard]] bool keeps_tree() const override { return true; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> /*boxes*/) const override {
    return std::make_unique<SomsMovingBoxes>();
  }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<SomsMatch>(mover, fixed, batch_);
  }

 private:
  bool batch_;
};

}  // namespace

void add_soms(Roster& roster) {
  roster.push_back(std::make_unique<Soms>(false));
  roster.push_back(std::make_unique<Soms>(true));
}

}  // namespace soms::bench
