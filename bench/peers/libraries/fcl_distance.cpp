// FCL's distance of two mesh models by its trees of swept spheres, in float and in double, through
// its traversal nodes: what fcl::distance does for them after its dispatch, without nearest points.
// `within` hands it the clearance as an upper bound and stops at the first pair that is as near.
#include "bench/peers/libraries/fcl_mesh.h"

#include <cmath>
#include <limits>
#include <utility>

namespace soms::bench {

namespace {

/// Leaves out what is farther than `enough`, and all once a pair is as near as that.
template <class Traversal>
class EnoughNode final : public Traversal {
 public:
  using Number = typename Traversal::S;

  explicit EnoughNode(Number enough) : enough_(enough) {}

  [[nodiscard]] bool canStop(Number bound) const override {
    return bound > enough_ || this->result->min_distance <= enough_;
  }

 private:
  Number enough_;
};

template <class Volume, class Traversal>
class FclDistanceMatch final : public Match {
 public:
  FclDistanceMatch(const FloatMesh& mover, const FloatMesh& fixed) {
    fill(mover_, mover);
    fill(fixed_, fixed);
  }

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (questions.job == Job::distance) {
        Traversal node;
        answers[i] = least_distance(node, questions.poses[i], std::numeric_limits<Number>::max());
      } else {
        const auto enough = static_cast<Number>(questions.clearances[i]);
        EnoughNode<Traversal> node(enough);
        const Number beyond = std::nextafter(enough, std::numeric_limits<Number>::max());
        answers[i] = least_distance(node, questions.poses[i], beyond) <= enough ? 1 : 0;
      }
    }
  }

 private:
  using Number = typename Volume::S;

  [[nodiscard]] Number least_distance(Traversal& node, const Pose& pose, Number bound) const {
    const fcl::DistanceRequest<Number> request(false);
    fcl::DistanceResult<Number> result(bound);
    fcl::detail::initialize(node, mover_, placed<Number>(pose), fixed_,
                            fcl::Transform3<Number>::Identity(), request, result);
    fcl::detail::distance<Number>(&node);
    return result.min_distance;
  }

  fcl::BVHModel<Volume> mover_;
  fcl::BVHModel<Volume> fixed_;
};

template <class FclPair>
class FclDistance final : public Library {
 public:
  FclDistance(std::string name, Precision precision)
      : name_(std::move(name)), precision_(precision) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::string version() const override { return FCL_VERSION; }

  [[nodiscard]] bool does(Job job) const override {
    return job == Job::distance || job == Job::within;
  }

  [[nodiscard]] Precision precision() const override { return precision_; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<FclPair>(mover, fixed);
  }

 private:
  std::string name_;
  Precision precision_;
};

template <class Number>
void add(Roster& roster, const std::string& numbers, Precision precision) {
  using Rss = FclDistanceMatch<fcl::RSS<Number>, fcl::detail::MeshDistanceTraversalNodeRSS<Number>>;
  using ObbRss =
      FclDistanceMatch<fcl::OBBRSS<Number>, fcl::detail::MeshDistanceTraversalNodeOBBRSS<Number>>;
  roster.push_back(std::make_unique<FclDistance<Rss>>("fcl-rss-" + numbers, precision));
  roster.push_back(std::make_unique<FclDistance<ObbRss>>("fcl-obbrss-" + numbers, precision));
}

}  // namespace

void add_fcl_distance(Roster& roster) {
  add<float>(roster, "float", Precision::floats);
  add<double>(roster, "double", Precision::doubles);
}

}  // namespace soms::bench
