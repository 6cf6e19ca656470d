#include "apps/soms/pairs/distance.h"

#include "soms/query/distance.h"
#include "soms/query/reference/distance.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/soms/pairs/distance_verify.h"
#include "apps/soms/pairs/near_question.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

bool overlap_was_found(const Distance& answer) {
  return answer.distance.upper == 0;
}

std::string bracket_text(const Bracket& bracket) {
  return fmt::format("[{}, {}]", bracket.lower, bracket.upper);
}

struct AskDistance {
  DistanceOptions options;

  template <class... Bodies>
  auto operator()(const Limits& limits, const Bodies&... bodies) const {
    return distance(bodies..., options, limits);
  }
};

/// How far apart are two bodies?
class DistanceQuestion : public NearQuestion<Distance, AskDistance> {
 public:
  DistanceQuestion(const PoseRows& rows, const DistanceOptions& options, const Console& console)
      : NearQuestion(rows, "distance", {options}), at_most_(options.at_most), console_(console) {}

  void count(const AnsweredRow& row) override;
  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override;

 private:
  [[nodiscard]] bool found(const Distance& answer) const override {
    return overlap_was_found(answer);
  }

  [[nodiscard]] bool undecided(const Distance& answer) const override {
    return answer.coverage == Coverage::cut;
  }

  [[nodiscard]] std::string title() const override { return "distance"; }

  [[nodiscard]] std::string cell(const Distance& answer) const override;
  [[nodiscard]] std::string in_words(const Distance& answer) const override;
  [[nodiscard]] std::string summary(const RowTotals& totals) const override;
  [[nodiscard]] NearWords words() const override;
  [[nodiscard]] NearFinding finding(const Distance& answer, const Body& a,
                                    const Body& b) const override;

  double at_most_;
  const Console& console_;
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = 0;
  std::uint64_t least_pose_ = 0;
  std::uint64_t greatest_pose_ = 0;
  bool known_ = false;  ///< of any pose
  std::uint64_t farther_ = 0;
};

std::string DistanceQuestion::cell(const Distance& answer) const {
  const auto& [lower, upper] = answer.distance;
  if (undecided(answer)) {
    return std::isfinite(upper) ? fmt::format("<= {}", readable(upper, digits())) : "undecided";
  }
  if (answer.farther) {
    return fmt::format("> {}", readable(at_most_));
  }
  return std::isfinite(lower) ? readable(lower, digits()) : "none";
}

std::string DistanceQuestion::in_words(const Distance& answer) const {
  const auto& [lower, upper] = answer.distance;
  if (undecided(answer)) {
    return std::isfinite(upper)
               ? fmt::format("undecided, out of time: the distance is from {} to {}",
                             readable(lower), readable(upper))
               : "undecided: out of time";
  }
  if (!std::isfinite(lower)) {
    return "no distance: a model has no triangles";
  }
  if (answer.farther) {
    return "farther than " + readable(at_most_);
  }
  return overlap_was_found(answer) ? "distance 0, the surfaces overlap"
                                   : "distance " + readable(lower);
}

NearWords DistanceQuestion::words() const {
  return {.lead = "How far apart the surfaces are, exact to the last bit.",
          .note =
              "The distance is that of the surfaces: 0 if they overlap, and above 0 if a body is "
              "entirely inside another one. The picture may be simplified; the answers never are.",
          .touching = {"pose with overlap", "poses with overlap"},
          .table = "Nearest points",
          .column = "distance",
          .order = "The nearest come first.",
          .plot = "Distance by pose",
          .least = "least",
          .greatest = "greatest",
          .each = "The distance of the surfaces at each pose; a line that breaks off: not known.",
          .of_few = "The distance of the surfaces: the least and the greatest in"};
}

NearFinding DistanceQuestion::finding(const Distance& answer, const Body&, const Body&) const {
  NearFinding finding{.pair = {answer.triangles, answer.point_a, answer.point_b},
                      .length = answer.distance,
                      .at_least = answer.distance.lower,
                      .coverage = answer.coverage,
                      .cost = answer.cost};
  if (undecided(answer)) {
    finding.pair.triangles = std::nullopt;  // a nearer one is possible
  }
  return finding;
}

void DistanceQuestion::count(const AnsweredRow& row) {
  const Distance answer = at(row.k);
  farther_ += answer.farther ? 1U : 0U;
  const double d = answer.distance.lower;
  if (answer.farther || undecided(answer) || !std::isfinite(d)) {
    return;
  }
  if (!known_ || d < least_) {
    least_ = d;
    least_pose_ = row.number;
  }
  if (!known_ || d > greatest_) {
    greatest_ = d;
    greatest_pose_ = row.number;
  }
  known_ = true;
}

std::string DistanceQuestion::summary(const RowTotals& totals) const {
  std::vector<std::string> parts;
  const bool all = farther_ == 0 && totals.undecided == 0;  // the greatest is known
  if (known_) {
    parts.push_back(
        fmt::format("the least distance is {} at pose {}", readable(least_), least_pose_));
    if (all && totals.rows > 1) {
      parts.back() +=
          fmt::format(", the greatest {} at pose {}", readable(greatest_), greatest_pose_);
    }
  } else if (all) {
    parts.emplace_back("no distance");
  }
  if (totals.found != 0) {
    parts.push_back(with_commas(totals.found) + " with overlap");
  }
  if (farther_ != 0) {
    parts.push_back(fmt::format("{} farther than {}", with_commas(farther_), readable(at_most_)));
  }
  if (totals.undecided != 0) {
    parts.push_back(with_commas(totals.undecided) + " undecided");
  }
  return fmt::format("{}: {}", counted(totals.rows, "pose"), fmt::join(parts, "; "));
}

std::optional<std::string> DistanceQuestion::difference(std::size_t k) {
  const Distance answer = at(k);
  const Distance truth = console_.run("verifying", [&](const Limits&) {
    return reference::distance_by_brute_force(rows().body_a(k), rows().body_b(k));
  });
  if (agrees(answer, truth, at_most_)) {
    return std::nullopt;
  }
  return fmt::format("brute force finds the distance in {}, but the answer is {}{}",
                     bracket_text(truth.distance), bracket_text(answer.distance),
                     answer.triangles == truth.triangles ? "" : " with another pair of triangles");
}

}  // namespace

Action add_distance(Parser& parser, Shared&) {
  const auto options = std::make_shared<DistanceVerbOptions>();
  add_posed_models(parser, *options);
  add_length(parser, "--at-most", options->at_most,
             "only say that they are farther apart than D, if they are")
      ->group(kQuestionGroup);
  add_near_options(parser, *options);
  parser.footer(
      "The distance of surfaces, exact to the last bit: 0 if they overlap, and greater if a body\n"
      "is entirely inside another one. The nearest triangles and points are named, too." +
      example_of_pair("distance knot.ply ball.off --pose \"2.2 0 0\""));
  return [options, &parser](Console& console) {
    settle(parser, *options);
    return run_distance(*options, console);
  };
}

int run_distance(const DistanceVerbOptions& options, Console& console) {
  const DistanceOptions query{.at_most = options.at_most};
  Json terms{{"verb", "distance"}};
  if (std::isfinite(options.at_most)) {
    terms["at_most"] = options.at_most;
  }
  return run_pairs(options,
                   {.verb = "distance",
                    .terms = std::move(terms),
                    .doubts_gaps = false,
                    .refused_of_tiles = {{refused_page(options.outputs)}}},
                   console,
                   [&](const PoseRows& rows) { return DistanceQuestion(rows, query, console); });
}

}  // namespace soms::command
