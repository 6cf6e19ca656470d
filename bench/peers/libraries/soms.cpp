// soms as its users have it: through the installed facade, and nothing else of it.
#include "soms/soms.h"

#include "bench/peers/libraries/library.h"
#include "bench/peers/libraries/soms_probes.h"

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

/// Ways to query soms: pose by pose, all poses in one call, or, of clearances, by the distance.
enum class Manner { single, batch, distance };

class SomsMatch final : public Match {
 public:
  SomsMatch(const FloatMesh& mover, const FloatMesh& fixed, Manner manner)
      : mover_(shape_of(mover)), fixed_(shape_of(fixed)), manner_(manner) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    if (manner_ == Manner::batch) {
      answer_batch(questions, answers);
      return;
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
      mover_.pose = questions.poses[i];
      answers[i] = answer_one(questions, i);
    }
  }

 private:
  [[nodiscard]] double answer_one(const Questions& questions, std::size_t i) const {
    switch (questions.job) {
      case Job::any:
        return overlap(mover_, fixed_, kAny).any ? 1 : 0;
      case Job::distance:
        return distance(mover_, fixed_).distance.lower;
      case Job::within:
        return (manner_ == Manner::distance
                    ? distance(mover_, fixed_).distance.upper <= questions.clearances[i]
                    : within(mover_, fixed_, questions.clearances[i]).within)
                   ? 1
                   : 0;
      default:
        return static_cast<double>(overlap(mover_, fixed_).pairs.size());
    }
  }

  void answer_batch(const Questions& questions, std::span<double> answers) const {
    if (questions.job == Job::distance) {
      const DistanceBatch found = distance(mover_.shape, questions.poses, fixed_);
      std::copy(found.lower.begin(), found.lower.end(), answers.begin());
    } else {
      const OverlapBatch found = overlap(mover_.shape, questions.poses, fixed_, kAny);
      std::copy(found.any.begin(), found.any.end(), answers.begin());
    }
  }

  Body mover_;
  Body fixed_;
  Manner manner_;
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
  explicit Soms(Manner manner) : manner_(manner) {}

  [[nodiscard]] std::string name() const override {
    return manner_ == Manner::single  ? "soms"
           : manner_ == Manner::batch ? "soms-batch"
                                      : kByDistance;
  }

  [[nodiscard]] std::string version() const override { return SOMS_VERSION; }

  [[nodiscard]] bool does(Job job) const override {
    switch (manner_) {
      case Manner::batch:
        return job == Job::any || job == Job::distance || answers_probes(job);
      case Manner::distance:
        return job == Job::within;
      case Manner::single:
        break;
    }
    return job < Job::closest || answers_probes(job);
  }

  [[nodiscard]] bool keeps_tree() const override { return true; }

  [[nodiscard]] bool watertight() const override { return true; }

  [[nodiscard]] std::unique_ptr<MovingBoxes> moving_boxes(
      std::span<const FloatBox> /*boxes*/) const override {
    return std::make_unique<SomsMovingBoxes>();
  }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<SomsMatch>(mover, fixed, manner_);
  }

  [[nodiscard]] std::unique_ptr<Match> prepare_probes(Job job,
                                                      const FloatMesh& body) const override {
    return soms_probes(job, shape_of(body), manner_ == Manner::batch);
  }

 private:
  Manner manner_;
};

}  // namespace

void add_soms(Roster& roster) {
  for (const Manner manner : {Manner::single, Manner::batch, Manner::distance}) {
    roster.push_back(std::make_unique<Soms>(manner));
  }
}

}  // namespace soms::bench
