#include "apps/soms/pairs/traversal_by_name.h"

#include "soms/thesis/overlap.h"
#include "soms/thesis/print.h"
#include "soms/thesis/traversals.h"

#include "apps/cli/text.h"
#include "apps/model/traversal_keys.h"

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <utility>

namespace soms::command {

namespace {

class ThesisTraversal final : public TraversalByName {
 public:
  explicit ThesisTraversal(Parser& parser) { add_traversal_keys(parser, options_); }

  [[nodiscard]] bool named() const override { return options_.traversal != Traversal::fast; }

  [[nodiscard]] std::string text() const override {
    std::ostringstream out;
    out << options_;
    return out.str();
  }

  void check(const Parser& parser) const override { check_traversal(parser, options_); }

  [[nodiscard]] CountedAnswer overlap(const Body& a, const Body& b, const OverlapOptions& options,
                                      const Limits& limits) const override {
    return reported(thesis::overlap(a, b, options_, options, limits));
  }

  [[nodiscard]] std::vector<CountedAnswer> overlap(const Shape& mover, std::span<const Pose> poses,
                                                   const Body& fixed, const OverlapOptions& options,
                                                   const Limits& limits) const override {
    std::vector<CountedAnswer> answers;
    answers.reserve(poses.size());
    for (auto& answer : thesis::overlap(mover, poses, fixed, options_, options, limits)) {
      answers.push_back(reported(std::move(answer)));
    }
    return answers;
  }

  [[nodiscard]] std::unique_ptr<OverlapMethod> method() const override {
    return std::make_unique<thesis::TraversalMethod>(options_);
  }

 private:
  [[nodiscard]] CountedAnswer reported(thesis::CountedOverlap counted_overlap) const {
    const TraversalCounts& counts = counted_overlap.counts;
    const std::uint64_t decided = counted_overlap.answer.cost.triangle_tests;
    return {.answer = std::move(counted_overlap.answer),
            .count_keys = fmt::format(
                ",\"entered\":{},\"leaf_pairs\":{},\"triangle_pairs\":{},\"first_tests\":{},"
                "\"max_stack\":{}",
                counts.entered, counts.leaf_pairs, counts.triangle_pairs, counts.first_tests,
                counts.max_stack),
            .count_line = fmt::format(
                "  traversal {}: {}, {} entered, {}, {}, {} of them decided\n",
                entry(options_.traversal).kebab, counted(counts.box_tests, "box test"),
                counted(counts.entered, "pair"), counted(counts.leaf_pairs, "leaf pair"),
                counted(counts.triangle_pairs, "triangle pair"), with_commas(decided))};
  }

  TraversalOptions options_ = {};
};

}  // namespace

std::shared_ptr<const TraversalByName> add_traversal_by_name(Parser& parser) {
  return std::make_shared<ThesisTraversal>(parser);
}

}  // namespace soms::command
