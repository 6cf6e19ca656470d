// soms as its users have it: through the installed facade, and nothing else of it.
#include "soms/soms.h"

#include "bench/peers/libraries/library.h"
#include "bench/peers/libraries/soms_probes.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// Ways to query soms: pose by pose, all poses in one call; of clearances, by the distance; of
/// solids, by the overlap of their surfaces.
enum class Manner { single, batch, distance, any, any_batch };

/// The name of soms used so.
const char* name_of(Manner manner) {
  switch (manner) {
    case Manner::batch:
      return "soms-batch";
    case Manner::distance:
      return kByDistance;
    case Manner::any:
      return kByOverlap;
    case Manner::any_batch:
      return kByOverlapBatch;
    case Manner::single:
      break;
  }
  return "soms";
}

double number_of(Relation relation) {
  return static_cast<double>(relation);
}

/// What `solid` says where the bodies cross or are clear of each other.
double crossing_if(bool any) {
  return number_of(any ? Relation::crossing : Relation::clear);
}

/// Two bodies found to be closed.
struct ClosedPair {
  ClosedBody mover;
  ClosedBody fixed;
};

class SomsMatch final : public Match {
 public:
  SomsMatch(const FloatMesh& mover, const FloatMesh& fixed, Manner manner)
      : SomsMatch(mover, Body(shape_of(fixed)), manner) {}

  SomsMatch(const FloatMesh& mover, Body fixed, Manner manner)
      : mover_(shape_of(mover)), fixed_(std::move(fixed)), manner_(manner) {}

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& mover) const override {
    return std::make_unique<SomsMatch>(mover, fixed_, manner_);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    if (questions.job == Job::solid && !closed_) {
      closed_ = ClosedPair{ClosedBody(mover_), ClosedBody(fixed_)};
    }
    if (manner_ == Manner::batch || manner_ == Manner::any_batch) {
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
      case Job::solid:
        return manner_ == Manner::any
                   ? crossing_if(overlap(mover_, fixed_, kAny).any)
                   : number_of(
                         solid(closed_->mover.at(questions.poses[i]), closed_->fixed).relation);
      default:
        return static_cast<double>(overlap(mover_, fixed_).pairs.size());
    }
  }

  void answer_batch(const Questions& questions, std::span<double> answers) const {
    if (questions.job == Job::distance) {
      const DistanceBatch found = distance(mover_.shape, questions.poses, fixed_);
      std::copy(found.lower.begin(), found.lower.end(), answers.begin());
    } else if (manner_ == Manner::batch && questions.job == Job::solid) {
      const SolidBatch found = solid(closed_->mover, questions.poses, closed_->fixed);
      std::transform(found.relation.begin(), found.relation.end(), answers.begin(), number_of);
    } else {
      const OverlapBatch found = overlap(mover_.shape, questions.poses, fixed_, kAny);
      std::transform(found.any.begin(), found.any.end(), answers.begin(), [&](bool any) {
        return questions.job == Job::solid ? crossing_if(any) : any ? 1 : 0;
      });
    }
  }

  Body mover_;
  Body fixed_;
  Manner manner_;
  std::optional<ClosedPair> closed_;  // from the first question about solids on
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

  [[nodiscard]] std::string name() const override { return name_of(manner_); }

  [[nodiscard]] std::string version() const override { return SOMS_VERSION; }

  [[nodiscard]] bool does(Job job) const override {
    switch (manner_) {
      case Manner::batch:
        return job == Job::any || job == Job::distance || job == Job::solid || answers_probes(job);
      case Manner::distance:
        return job == Job::within;
      case Manner::any:
      case Manner::any_batch:
        return job == Job::solid;
      case Manner::single:
        break;
    }
    return job < Job::closest || answers_probes(job);
  }

  [[nodiscard]] bool batches() const override {
    return manner_ == Manner::batch || manner_ == Manner::any_batch;
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
  for (const Manner manner :
       {Manner::single, Manner::batch, Manner::distance, Manner::any, Manner::any_batch}) {
    roster.push_back(std::make_unique<Soms>(manner));
  }
}

}  // namespace soms::bench
