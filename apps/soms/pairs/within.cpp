#include "apps/soms/pairs/within.h"

#include "soms/geometry/triangle_distance.h"
#include "soms/query/reference/distance.h"
#include "soms/query/within.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/report/placing.h"
#include "apps/soms/pairs/near_question.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace soms::command {

namespace {

/// One triangle of a body, where it stands.
Body only(const Body& body, TriangleId i) {
  const Triangle t = body.shape.mesh().triangle(i);
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return Body(std::move(mesh), body.pose);
}

struct AskWithin {
  double clearance = 0;

  template <class... Bodies>
  auto operator()(const Limits& limits, const Bodies&... bodies) const {
    return within(bodies..., clearance, limits);
  }
};

/// Are two bodies within a clearance?
class WithinQuestion : public NearQuestion<Within, AskWithin> {
 public:
  WithinQuestion(const PoseRows& rows, double clearance, const Console& console)
      : NearQuestion(rows, "within", {clearance}), clearance_(clearance), console_(console) {}

  void count(const AnsweredRow& row) override;
  /// \errors ErrorKind::timed_out, cancelled.
  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override;

 private:
  [[nodiscard]] bool found(const Within& answer) const override { return answer.within; }

  [[nodiscard]] bool undecided(const Within& answer) const override {
    return answer.coverage == Coverage::cut && !answer.within;
  }

  [[nodiscard]] std::string title() const override { return "within " + readable(clearance_); }

  [[nodiscard]] std::string cell(const Within& answer) const override;
  [[nodiscard]] std::string in_words(const Within& answer) const override;
  [[nodiscard]] std::string summary(const RowTotals& totals) const override;
  [[nodiscard]] NearWords words() const override;
  [[nodiscard]] NearFinding finding(const Within& answer, const Body& a,
                                    const Body& b) const override;

  double clearance_;
  const Console& console_;
  std::optional<std::uint64_t> first_;  ///< pose that is within
};

std::string WithinQuestion::cell(const Within& answer) const {
  return undecided(answer) ? "undecided" : answer.within ? "yes" : "no";
}

std::string WithinQuestion::in_words(const Within& answer) const {
  if (undecided(answer)) {
    return "undecided: out of time";
  }
  if (answer.within) {
    return title();
  }
  if (!std::isfinite(answer.at_least)) {
    return fmt::format("not {}: a model has no triangles", title());
  }
  return answer.at_least > clearance_
             ? fmt::format("not {}: the distance is at least {}", title(),
                           readable(answer.at_least))
             : fmt::format("not {}: the distance is more than that", title());
}

NearWords WithinQuestion::words() const {
  return {
      .lead = fmt::format("Whether the distance of the surfaces is at most {}, decided exactly.",
                          readable(clearance_)),
      .note =
          "One pair of triangles proves that a pose is within the clearance; others may be "
          "nearer, so its length is not the distance: soms distance says that. The picture may "
          "be simplified; the answers never are.",
      .poses = {.yes = title(), .no = "not"},
      .table = "Pose by pose",
      .column = title(),
      .named = "yes, at most ",
      .apart = "no, at least ",
      .order = "Poses within the clearance come first, the nearest named pair before the others.",
      .plot = title() + " by pose",
      .least = "yes: at most",
      .greatest = "no: at least",
      .each =
          "For a pose within the clearance the length of the pair that proves it, for another "
          "one a lower bound of the distance.",
      .of_few =
          "The least length of a pair that proves a pose to be within the clearance, and the "
          "greatest lower bound of the distance at another pose, in"};
}

NearFinding WithinQuestion::finding(const Within& answer, const Body& a, const Body& b) const {
  NearFinding finding{.pair = {answer.triangles, answer.point_a, answer.point_b},
                      .at_least = answer.at_least,
                      .coverage = answer.coverage,
                      .cost = answer.cost};
  if (answer.triangles) {
    // Not from the points, which are rounded, and whose length may underflow to 0.
    const auto triangle = [](const Body& body, TriangleId i) {
      return report::moved(body.shape.mesh().triangle(i), body.pose);
    };
    finding.length =
        triangle_distance(triangle(a, answer.triangles->a), triangle(b, answer.triangles->b))
            .distance;
  }
  return finding;
}

void WithinQuestion::count(const AnsweredRow& row) {
  if (!first_ && at(row.k).within) {
    first_ = row.number;
  }
}

std::string WithinQuestion::summary(const RowTotals& totals) const {
  return fmt::format(
      "{}: {} within {}{}, {} not{}", counted(totals.rows, "pose"), with_commas(totals.found),
      readable(clearance_), first_ ? fmt::format(" (the first at pose {})", *first_) : "",
      with_commas(totals.rows - totals.found - totals.undecided),
      totals.undecided == 0 ? "" : fmt::format(", {} undecided", with_commas(totals.undecided)));
}

std::optional<std::string> WithinQuestion::difference(std::size_t k) {
  const Within answer = at(k);
  const Body a = rows().body_a(k);
  const Body b = rows().body_b(k);
  if (undecided(answer)) {
    return std::nullopt;
  }
  const bool truth = console_.run("verifying", [&](const Limits& limits) {
    return reference::within_by_brute_force(a, b, clearance_, limits);
  });
  if (answer.within != truth) {
    return fmt::format("brute force finds them {}within {}", truth ? "" : "not ", clearance_);
  }
  // The pair that is named must prove it.
  if (answer.within && !(answer.triangles && reference::within_by_brute_force(
                                                 only(a, answer.triangles->a),
                                                 only(b, answer.triangles->b), clearance_))) {
    return fmt::format("brute force finds the pair that is named not within {}", clearance_);
  }
  return std::nullopt;
}

}  // namespace

Action add_within(Parser& parser, Shared&) {
  const auto options = std::make_shared<WithinVerbOptions>();
  add_posed_models(parser, *options);
  add_length(parser, "--clearance", options->clearance,
             "the distance to stay above; 0 asks for overlap")
      ->required()
      ->group(kQuestionGroup);
  add_choice<bool>(parser, "--fail-if", options->fail_if_within, {{"within", true}},
                   "exit with status 1 if this is found")
      ->group(kQuestionGroup);
  add_near_options(parser, *options);
  parser.footer(
      "True if the distance of the surfaces is at most D, decided exactly; a body entirely inside\n"
      "another one is as far from it as its surface is. One pair of triangles that proves it is\n"
      "named." +
      example_of_pair("within knot.ply ball.off --clearance 0.5 --pose \"2.2 0 0\""));
  return [options, &parser](Console& console) {
    settle(parser, *options);
    return run_within(*options, console);
  };
}

int run_within(const WithinVerbOptions& options, Console& console) {
  return run_pairs(options,
                   {.verb = options.verb,
                    .terms = {{"verb", "within"}, {"clearance", options.clearance}},
                    .fail_if_found = options.fail_if_within,
                    .expected_gap = options.clearance,
                    .refused_of_tiles = {{refused_page(options.outputs)}}},
                   console, [&](const PoseRows& rows) {
                     return WithinQuestion(rows, options.clearance, console);
                   });
}

}  // namespace soms::command
