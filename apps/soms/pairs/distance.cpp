#include "apps/soms/pairs/distance.h"

#include "soms/query/distance.h"
#include "soms/query/reference/distance.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/rows/row_run.h"
#include "apps/soms/pairs/distance_verify.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/near_run.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
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

/// The question of a `NearRun`: the distance of two bodies.
class DistanceQuestion {
 public:
  using Answer = Distance;
  static constexpr std::string_view kSchema = "soms.distance/2";

  explicit DistanceQuestion(const DistanceOptions& options) : options_(options) {}

  [[nodiscard]] Distance ask(const Body& a, const Body& b, const Parallel& parallel) const;
  [[nodiscard]] DistanceBatch ask(const Shape& a, std::span<const Pose> poses, const Body& b,
                                  const Parallel& parallel) const;
  [[nodiscard]] DistanceBatch ask(const Shape& a, std::span<const Pose> poses, const TiledBody& b,
                                  const Parallel& parallel) const;

  /// True if the bodies overlap.
  [[nodiscard]] bool found(const Distance& answer) const;
  [[nodiscard]] bool undecided(const Distance& answer) const;

  [[nodiscard]] std::string title() const { return "distance"; }

  [[nodiscard]] std::string cell(const Distance& answer) const;
  [[nodiscard]] std::string text(const Distance& answer) const;

  void add(std::uint64_t pose, const Distance& answer);
  [[nodiscard]] NearWords words() const;
  [[nodiscard]] NearFinding finding(const Distance& answer, const Body& a, const Body& b) const;
  [[nodiscard]] std::string totals(const RowTotals& totals) const;

  /// \errors ErrorKind::timed_out, cancelled.
  [[nodiscard]] std::optional<std::string> difference(const Body& a, const Body& b,
                                                      const Distance& answer,
                                                      const Console& console) const;

 private:
  DistanceOptions options_;
  double least_ = std::numeric_limits<double>::infinity();
  double greatest_ = 0;
  std::uint64_t least_pose_ = 0;
  std::uint64_t greatest_pose_ = 0;
  bool known_ = false;  ///< of any pose
  std::uint64_t farther_ = 0;
};

Distance DistanceQuestion::ask(const Body& a, const Body& b, const Parallel& parallel) const {
  return distance(a, b, options_, parallel);
}

DistanceBatch DistanceQuestion::ask(const Shape& a, std::span<const Pose> poses, const Body& b,
                                    const Parallel& parallel) const {
  return distance(a, poses, b, options_, parallel);
}

DistanceBatch DistanceQuestion::ask(const Shape& a, std::span<const Pose> poses, const TiledBody& b,
                                    const Parallel& parallel) const {
  return distance(a, poses, b, options_, parallel);
}

bool DistanceQuestion::found(const Distance& answer) const {
  return overlap_was_found(answer);
}

bool DistanceQuestion::undecided(const Distance& answer) const {
  return answer.coverage == Coverage::cut;
}

std::string DistanceQuestion::cell(const Distance& answer) const {
  const auto& [lower, upper] = answer.distance;
  if (undecided(answer)) {
    return std::isfinite(upper) ? fmt::format("<= {}", readable(upper)) : "undecided";
  }
  if (answer.farther) {
    return fmt::format("> {}", readable(options_.at_most));
  }
  return std::isfinite(lower) ? readable(lower) : "none";
}

std::string DistanceQuestion::text(const Distance& answer) const {
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
    return "farther than " + readable(options_.at_most);
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

void DistanceQuestion::add(std::uint64_t pose, const Distance& answer) {
  farther_ += answer.farther ? 1U : 0U;
  const double d = answer.distance.lower;
  if (answer.farther || undecided(answer) || !std::isfinite(d)) {
    return;
  }
  if (!known_ || d < least_) {
    least_ = d;
    least_pose_ = pose;
  }
  if (!known_ || d > greatest_) {
    greatest_ = d;
    greatest_pose_ = pose;
  }
  known_ = true;
}

std::string DistanceQuestion::totals(const RowTotals& totals) const {
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
    parts.push_back(
        fmt::format("{} farther than {}", with_commas(farther_), readable(options_.at_most)));
  }
  if (totals.undecided != 0) {
    parts.push_back(with_commas(totals.undecided) + " undecided");
  }
  return fmt::format("{}: {}", counted(totals.rows, "pose"), fmt::join(parts, "; "));
}

std::optional<std::string> DistanceQuestion::difference(const Body& a, const Body& b,
                                                        const Distance& answer,
                                                        const Console& console) const {
  const Distance truth = console.run(
      "verifying", [&](const Parallel&) { return reference::distance_by_brute_force(a, b); });
  if (agrees(answer, truth, options_.at_most)) {
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
  const DistanceOptions query{.at_most = options.at_most, .deadline = console.deadline()};
  Json terms{{"verb", "distance"}};
  if (std::isfinite(options.at_most)) {
    terms["at_most"] = options.at_most;
  }
  return run_near(options, {.verb = "distance", .terms = std::move(terms), .doubts_gaps = false},
                  DistanceQuestion(query), console);
}

}  // namespace soms::command
