#include "bench/peers/libraries/soms_probes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace soms::bench {

namespace {

class ClosestPoints final : public Match {
 public:
  ClosestPoints(Shape shape, bool batch) : body_(std::move(shape)), batch_(batch) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    const std::span<const Vec3> points = questions.points.first(answers.size());
    if (batch_) {
      const ClosestBatch found = closest(body_, points);
      std::copy(found.lower.begin(), found.lower.end(), answers.begin());
      return;
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i] = closest(body_, points[i]).distance.lower;
    }
  }

 private:
  Body body_;
  bool batch_;
};

double number(Side side) {
  return side == Side::on ? kOnSurface : side == Side::inside ? 1 : 0;
}

class Containment final : public Match {
 public:
  Containment(Shape shape, bool batch) : body_(Body(std::move(shape))), batch_(batch) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    const std::span<const Vec3> points = questions.points.first(answers.size());
    if (batch_) {
      const ContainsBatch found = contains(body_, points);
      std::transform(found.side.begin(), found.side.end(), answers.begin(), number);
      return;
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
      answers[i] = number(contains(body_, points[i]).side);
    }
  }

 private:
  ClosedBody body_;
  bool batch_;
};

class RayHits final : public Match {
 public:
  RayHits(Shape shape, bool batch) : body_(std::move(shape)), batch_(batch) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    const bool any = questions.job == Job::any_hit;
    if (batch_) {
      rays_.clear();
      for (const ProbeRay& ray : questions.rays.first(answers.size())) {
        rays_.push_back({ray.origin, ray.direction});
      }
      if (any) {
        const AnyHitBatch found = any_hit(body_, rays_);
        std::copy(found.hit.begin(), found.hit.end(), answers.begin());
      } else {
        const ClosestHitBatch found = closest_hit(body_, rays_);
        std::copy(found.lower.begin(), found.lower.end(), answers.begin());
      }
      return;
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const Ray ray{questions.rays[i].origin, questions.rays[i].direction};
      answers[i] = any ? (any_hit(body_, ray).hit ? 1 : 0) : closest_hit(body_, ray).t.lower;
    }
  }

 private:
  Body body_;
  bool batch_;
  std::vector<Ray> rays_;
};

}  // namespace

std::unique_ptr<Match> soms_probes(Job job, Shape shape, bool batch) {
  if (job == Job::contains) {
    return std::make_unique<Containment>(std::move(shape), batch);
  }
  if (job == Job::closest_hit || job == Job::any_hit) {
    return std::make_unique<RayHits>(std::move(shape), batch);
  }
  return std::make_unique<ClosestPoints>(std::move(shape), batch);
}

}  // namespace soms::bench
