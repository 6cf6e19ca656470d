#include "apps/soms/probes/closest.h"

#include "soms/base/error.h"
#include "soms/query/reference/closest.h"
#include "soms/query/reference/contains.h"
#include "soms/query/signed_closest.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/soms/answers/array_columns.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/probes/closest_model.h"
#include "apps/soms/solid/closed_body.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where is the model nearest to each point, and with --signed: is it inside?
class NearestQuestion : public BatchQuestion<Closest> {
 public:
  NearestQuestion(const ClosestVerbOptions& options, const ProbeRows<PointSource>& rows,
                  const Pose& pose, Console& console)
      : BatchQuestion("closest", "row"),
        at_most_(options.at_most),
        rows_(rows),
        model_(options, pose, console),
        georeference_(model_.report().georeference()) {
    if (options.with_side) {
      closed_ = closed_body(model_.model().body(), "leave out --signed", console);
    }
  }

  std::uint64_t answer(const ShowProgress&) override {
    const Limits limits = model_.console().limits();
    if (closed_) {
      SignedClosestBatch batch = closest(*closed_, rows_.block(), model_.query(), limits);
      for (std::size_t k = 0; k < batch.size(); ++k) {
        if (batch.side[k] == Side::undecided) {
          batch.closest.coverage[k] = Coverage::cut;  // of the distance and the side together
        }
      }
      sides_ = std::move(batch.side);
      set(std::move(batch.closest));
    } else {
      model_.model().visit(
          [&](const auto& body) { set(closest(body, rows_.block(), model_.query(), limits)); });
    }
    return 0;
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (const std::optional<Side> side = side_of(k); side && *side != Side::undecided) {
      const Side truth = model_.console().run("verifying", [&](const Limits&) {
        return reference::contains_by_brute_force(model_.model().body(), rows_.block()[k]);
      });
      if (truth != *side) {
        return fmt::format("brute force finds {}, but the answer is {}", name(truth), name(*side));
      }
    }
    return difference_of_nearest(k);
  }

  void count(const AnsweredRow& row) override {
    const Closest answer = at(row.k);
    farther_ += answer.farther ? 1U : 0U;
    inside_ += side_of(row.k) == Side::inside ? 1U : 0U;
    const auto& [lower, upper] = answer.distance;
    if (undecided(answer) || !answer.triangle) {
      return;
    }
    on_surface_ += upper == 0 ? 1U : 0U;
    if (known_ == 0 || lower < least_) {
      least_ = lower;
      least_at_ = row.number;
    }
    if (known_ == 0 || lower > greatest_) {
      greatest_ = lower;
      greatest_at_ = row.number;
    }
    ++known_;
  }

  [[nodiscard]] std::string sentence(std::size_t k) const override {
    return point_text(shown(k), side_of(k), model_.mesh(), at_most_) + "\n";
  }

  [[nodiscard]] std::string text_head() const override { return point_head(closed_.has_value()); }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    return point_row(row.number, shown(row.k), side_of(row.k), model_.mesh(), at_most_, digits());
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    std::vector<std::string> parts;
    if (known_ != 0) {
      parts.push_back(
          fmt::format("the least distance is {} at point {}", readable(least_), least_at_));
      if (known_ == totals.rows) {
        parts.back() +=
            fmt::format(", the greatest {} at point {}", readable(greatest_), greatest_at_);
      }
    }
    if (on_surface_ != 0) {
      parts.push_back(with_commas(on_surface_) + " on the surface");
    }
    if (closed_) {
      parts.push_back(with_commas(inside_) + " inside");
    }
    if (farther_ != 0) {
      parts.push_back(fmt::format("{} farther than {}", with_commas(farther_), readable(at_most_)));
    }
    return closest_totals(totals, std::move(parts));
  }

  void begin_columns(NpzFile& file) override {
    BatchQuestion::begin_columns(file);
    side_ = closed_ ? &file.names("side", kWords<Side>.names) : nullptr;
    add_georeference(file, model_.report().georeference());
  }

  void add_columns(std::size_t rows) override {
    BatchQuestion::add_columns(rows);
    for (std::size_t k = 0; k < rows && side_ != nullptr; ++k) {
      add_code(*side_, sides_[k]);
    }
  }

 private:
  [[nodiscard]] std::optional<Side> side_of(std::size_t k) const {
    return closed_ ? std::optional(sides_[k]) : std::nullopt;
  }

  [[nodiscard]] bool found(const Closest& /*answer*/) const override { return false; }

  [[nodiscard]] bool undecided(const Closest& answer) const override {
    return answer.coverage == Coverage::cut;
  }

  [[nodiscard]] std::optional<std::string> difference_of_nearest(std::size_t k) const {
    const Closest answer = at(k);
    const Closest truth = model_.console().run("verifying", [&](const Limits&) {
      return reference::closest_by_brute_force(model_.model().body(), rows_.block()[k]);
    });
    const Bracket& d = truth.distance;
    bool right = answer.distance == d && answer.triangle == truth.triangle &&
                 answer.point == truth.point && answer.feature == truth.feature;
    if (answer.coverage == Coverage::cut) {
      right = answer.distance.lower <= d.lower && d.upper <= answer.distance.upper;
    } else if (answer.farther) {
      right = d.upper > model_.query().at_most && !answer.triangle;
    }
    return right ? std::nullopt
                 : std::optional(fmt::format(
                       "brute force finds the distance in [{}, {}], but the answer is [{}, {}]{}",
                       d.lower, d.upper, answer.distance.lower, answer.distance.upper,
                       answer.triangle == truth.triangle ? "" : " with another triangle"));
  }

  [[nodiscard]] std::string more_keys(std::size_t k) const override {
    return closed_ ? fmt::format(",\"side\":\"{}\"", name(sides_[k])) : std::string();
  }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return model_.report().keys(row);
  }

  [[nodiscard]] const FileNumbers& numbers(int /*side*/) const override {
    return model_.model().numbers();
  }

  [[nodiscard]] std::string more_head() const override {
    return (closed_ ? ",side" : "") + std::string(georeference_.head());
  }

  [[nodiscard]] std::string more_cells(std::size_t k) const override {
    return (closed_ ? "," + std::string(name(sides_[k])) : std::string())
        .append(georeference_.field());
  }

  [[nodiscard]] std::string triangle_cells(int /*side*/,
                                           std::optional<TriangleId> triangle) const override {
    return model_.cells(triangle);
  }

  double at_most_;
  const ProbeRows<PointSource>& rows_;
  ClosestModel model_;
  std::optional<ClosedBody> closed_;  // the same, where sides are requested
  GeoreferenceColumn georeference_;
  std::vector<Side> sides_;
  NpzColumn* side_ = nullptr;
  double least_ = kInfinity;
  double greatest_ = 0;
  std::uint64_t least_at_ = 0;
  std::uint64_t greatest_at_ = 0;
  std::uint64_t known_ = 0;
  std::uint64_t on_surface_ = 0;
  std::uint64_t inside_ = 0;
  std::uint64_t farther_ = 0;
};

void check_options(const ClosestVerbOptions& options) {
  if (options.radius && std::isfinite(options.at_most)) {
    throw Error(ErrorKind::usage, "--at-most and --radius both limit the distance",
                "give one of them");
  }
  if (options.with_side && (options.nearest != 0 || options.radius)) {
    throw Error(ErrorKind::usage, "--signed is about the nearest triangle, not about lists",
                "leave out --nearest and --radius");
  }
}

}  // namespace

Action add_closest(Parser& parser, Shared&) {
  const auto options = std::make_shared<ClosestVerbOptions>();
  add_points(parser, *options, "model");
  add_count(parser, "--nearest", options->nearest, 1, 0xffffffffU,
            "list the N nearest triangles of each point")
      ->group(kQuestionGroup);
  parser
      .add_option_function(
          "--radius",
          [options](const std::string& text) {
            const double radius = parse_number("--radius", text);
            if (radius < 0) {
              throw Error(ErrorKind::usage, "--radius: " + text + " is negative", "give 0 or more");
            }
            options->radius = radius;
          },
          "list all triangles within this distance of each point")
      ->option_text("X")
      ->group(kQuestionGroup);
  add_length(parser, "--at-most", options->at_most,
             "only say that the model is farther than D, if it is")
      ->group(kQuestionGroup);
  parser
      .add_flag("--signed", options->with_side,
                "also say whether each point is inside; the model must be closed")
      ->group(kQuestionGroup);
  add_probe_options(parser, *options);
  parser.footer(
      "The nearest point of the surface to each point, exact to the last bit, with its triangle "
      "and\n"
      "whether it is a vertex of that triangle, on an edge, or inside its face.\n\n"
      "Example:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  printf 'x,y,z\\n0,0,0\\n2,0,0\\n' | soms closest knot.ply --points -");
  return [options, &parser](Console& console) {
    check_probe_options(parser, *options, "--points", options->points);
    return run_closest(*options, console);
  };
}

int run_closest(const ClosestVerbOptions& options, Console& console) {
  check_options(options);
  const ProbeTerms terms{.verb = "closest", .says_one = true};
  if (options.nearest != 0 || options.radius) {
    return run_probes<PointSource>(options, options.points, terms, console,
                                   [&](const auto& rows, const Pose& pose) {
                                     return NearListsQuestion(options, rows, pose, console);
                                   });
  }
  return run_probes<PointSource>(options, options.points, terms, console,
                                 [&](const auto& rows, const Pose& pose) {
                                   return NearestQuestion(options, rows, pose, console);
                                 });
}

}  // namespace soms::command
