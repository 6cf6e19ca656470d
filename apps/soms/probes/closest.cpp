#include "apps/soms/probes/closest.h"

#include "soms/base/error.h"
#include "soms/query/reference/closest.h"
#include "soms/query/reference/contains.h"
#include "soms/query/signed_closest.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/rows/point_source.h"
#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/probes/closest_output.h"
#include "apps/soms/probes/probe_run.h"
#include "apps/soms/solid/closed_body.h"
#include "apps/store/probed_model.h"

#include <fmt/format.h>

#include <algorithm>
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

/// The distances of all points, for the line of totals.
struct Extremes {
  double least = kInfinity;
  double greatest = 0;
  std::uint64_t least_at = 0;
  std::uint64_t greatest_at = 0;
  std::uint64_t known = 0;
  std::uint64_t on_surface = 0;
  std::uint64_t inside = 0;
  std::uint64_t farther = 0;
  std::uint64_t hits = 0;

  void add(std::uint64_t point, const PointAnswer& answer) {
    hits += answer.hits ? answer.hits->size() : 0;
    farther += answer.closest.farther ? 1U : 0U;
    inside += answer.side == Side::inside ? 1U : 0U;
    const auto& [lower, upper] = answer.closest.distance;
    if (answer.hits || answer.cut() || !answer.closest.triangle) {
      return;
    }
    on_surface += upper == 0 ? 1U : 0U;
    if (known == 0 || lower < least) {
      least = lower;
      least_at = point;
    }
    if (known == 0 || lower > greatest) {
      greatest = lower;
      greatest_at = point;
    }
    ++known;
  }
};

/// A run whose rows are points beside a model.
class ClosestRun : public ProbeRun<PointSource> {
 public:
  ClosestRun(const ClosestVerbOptions& options, PointCsv& csv, PointColumns& columns,
             Console& console)
      : ProbeRun(options, options.points,
                 {.verb = "closest", .has_files = !options.csv.empty() || !options.binary.empty()},
                 console),
        options_(options),
        lists_(options.nearest != 0 || options.radius.has_value()),
        csv_(csv),
        columns_(columns),
        model_(options.model, options.reading, options.build, pose(),
               {refused_verify(options.verify),
                {options.with_side, "--signed", "inside is decided by whole surfaces"},
                {options.nearest != 0, "--nearest", "it lists triangles of several of them"},
                {options.radius.has_value(), "--radius", "it lists triangles of several of them"}},
               console) {
    query_.at_most = std::min(options.at_most, options.radius.value_or(kInfinity));
    query_.deadline = console.deadline();
    if (options.with_side) {
      closed_ = closed_body(model_.body(), "leave out --signed", console);
    }
    csv_.begin(model_.mesh(), georeference(model_.mesh()), lists_, options.with_side);
    columns_.begin(lists_, options.with_side);
    columns_.state(georeference(model_.mesh()));
  }

 private:
  void begin() override { single_ = !console().shared().json && read_single(); }

  [[nodiscard]] bool is_single() const override { return single_; }

  std::uint64_t answer_block() override {
    answers_.clear();
    return lists_ ? answer_lists() : closed_ ? answer_signed() : answer_nearest();
  }

  std::uint64_t answer_signed() {
    const SignedClosestBatch batch = closest(*closed_, block(), query_, console().parallel());
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_.push_back({batch.closest.at(k), std::nullopt, batch.side[k]});
    }
    return 0;
  }

  std::uint64_t answer_nearest() {
    model_.visit([&](const auto& body) {
      const ClosestBatch batch = closest(body, block(), query_, console().parallel());
      for (std::size_t k = 0; k < batch.size(); ++k) {
        answers_.push_back({batch.at(k)});
      }
    });
    return 0;
  }

  /// Returns how many triangles the lists hold.
  std::uint64_t answer_lists() {
    const std::size_t most =
        options_.nearest == 0 ? std::numeric_limits<std::size_t>::max() : options_.nearest;
    const NearTriangles rows =
        nearest_triangles(model_.body(), block(), most, query_, console().parallel());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      PointAnswer answer;
      answer.closest.coverage = rows.coverage[k];
      answer.closest.cost = rows.costs[k];
      answer.hits.emplace();
      for (std::size_t i = rows.offsets[k]; i < rows.offsets[k + 1]; ++i) {
        answer.hits->push_back({rows.triangle[i], {rows.lower[i], rows.upper[i]}});
      }
      answers_.push_back(std::move(answer));
    }
    return rows.triangle.size();
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const PointAnswer& answer = answers_[k];
    return {.found = false, .undecided = answer.cut(), .cut = answer.cut()};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (const std::optional<Side> side = answers_[k].side; side && *side != Side::undecided) {
      const Side truth = console().run("verifying", [&](const Parallel&) {
        return reference::contains_by_brute_force(model_.body(), block()[k]);
      });
      if (truth != *side) {
        return fmt::format("brute force finds {}, but the answer is {}", name(truth), name(*side));
      }
    }
    return answers_[k].hits ? difference_of_list(k) : difference_of_nearest(k);
  }

  std::optional<std::string> difference_of_nearest(std::size_t k) {
    const Closest& answer = answers_[k].closest;
    const Closest truth = console().run("verifying", [&](const Parallel&) {
      return reference::closest_by_brute_force(model_.body(), block()[k]);
    });
    const Bracket& d = truth.distance;
    bool right = answer.distance == d && answer.triangle == truth.triangle &&
                 answer.point == truth.point && answer.feature == truth.feature;
    if (answer.coverage == Coverage::cut) {
      right = answer.distance.lower <= d.lower && d.upper <= answer.distance.upper;
    } else if (answer.farther) {
      right = d.upper > query_.at_most && !answer.triangle;
    }
    return right ? std::nullopt
                 : std::optional(fmt::format(
                       "brute force finds the distance in [{}, {}], but the answer is [{}, {}]{}",
                       d.lower, d.upper, answer.distance.lower, answer.distance.upper,
                       answer.triangle == truth.triangle ? "" : " with another triangle"));
  }

  std::optional<std::string> difference_of_list(std::size_t k) {
    if (answers_[k].cut()) {
      return std::nullopt;  // which says no more than that it found these
    }
    const std::vector<ListedTriangle>& hits = *answers_[k].hits;
    auto truth = console().run("verifying", [&](const Parallel&) {
      return reference::triangles_by_brute_force(model_.body(), block()[k], query_.at_most);
    });
    if (options_.nearest != 0 && truth.size() > options_.nearest) {
      truth.resize(options_.nearest);
    }
    const bool right =
        std::equal(hits.begin(), hits.end(), truth.begin(), truth.end(),
                   [](const ListedTriangle& hit, const reference::RankedTriangle& expected) {
                     return hit.triangle == expected.triangle && hit.distance == expected.distance;
                   });
    return right ? std::nullopt
                 : std::optional(fmt::format("brute force finds other triangles: {} of them, and "
                                             "the answer has {}",
                                             truth.size(), hits.size()));
  }

  void print_row(std::size_t k, bool right, bool last) override {
    const PointAnswer& answer = answers_[k];
    const std::uint64_t point = totals().rows;
    const MeshView& mesh = model_.mesh();
    if (console().shared().json) {
      print_json(mesh, "row", point_keys(answer), right, last);
    } else if (single_) {
      console().print(point_text(answer, mesh, options_.at_most) + "\n");
    } else {
      table_.add(point, answer, mesh, options_.at_most, console());
    }
    csv_.add(point, answer);
    columns_.add(answer);
    extremes_.add(point, answer);
  }

  void print_totals() override {
    if (!single_) {
      table_.finish(console());
      console().print(totals_text() + "\n");
    }
  }

  [[nodiscard]] std::string totals_text() const {
    std::vector<std::string> parts;
    if (lists_) {
      parts.push_back(counted(extremes_.hits, "triangle"));
    }
    if (extremes_.known != 0) {
      parts.push_back(fmt::format("the least distance is {} at point {}", readable(extremes_.least),
                                  extremes_.least_at));
      if (extremes_.known == totals().rows) {
        parts.back() += fmt::format(", the greatest {} at point {}", readable(extremes_.greatest),
                                    extremes_.greatest_at);
      }
    }
    if (extremes_.on_surface != 0) {
      parts.push_back(with_commas(extremes_.on_surface) + " on the surface");
    }
    if (options_.with_side) {
      parts.push_back(with_commas(extremes_.inside) + " inside");
    }
    if (extremes_.farther != 0) {
      parts.push_back(fmt::format("{} farther than {}", with_commas(extremes_.farther),
                                  readable(options_.at_most)));
    }
    if (totals().undecided != 0) {
      parts.push_back(with_commas(totals().undecided) + " undecided");
    }
    const std::string count = counted(totals().rows, "point");
    return parts.empty() ? count : fmt::format("{}: {}", count, fmt::join(parts, "; "));
  }

  void finish(End /*end*/) override {
    csv_.finish();
    columns_.finish();
  }

  const ClosestVerbOptions& options_;
  bool lists_;
  bool single_ = false;
  PointCsv& csv_;
  PointColumns& columns_;
  ProbedModel model_;
  std::optional<ClosedBody> closed_;  // the same, where sides are requested
  ClosestOptions query_;
  std::vector<PointAnswer> answers_;
  PointTable table_;
  Extremes extremes_;
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
  check_outputs({{"MODEL", options.model},
                 {"--points", options.points},
                 {"--pose", options.pose.value_or("")}},
                {{"--csv", options.csv}, {"--binary", options.binary}});
  check_extension("--csv", options.csv, {".csv"});
  check_extension("--binary", options.binary, {".npz"});
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
  add_output(parser, "--csv", options->csv, "write the answers as CSV")->group(kQuestionGroup);
  add_binary(parser, options->binary);
  add_probe_options(parser, *options);
  parser.footer(
      "The nearest point of the surface to each point, exact to the last bit, with its triangle "
      "and\n"
      "whether it is a vertex of that triangle, on an edge, or inside its face.\n\n"
      "Example:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  printf 'x,y,z\\n0,0,0\\n2,0,0\\n' | soms closest knot.ply --points -");
  return [options, &parser](Console& console) {
    check_probe_options(parser, *options, options->points);
    return run_closest(*options, console);
  };
}

int run_closest(const ClosestVerbOptions& options, Console& console) {
  check_options(options);
  PointCsv csv(options.csv);
  PointColumns columns(options.binary);
  return ClosestRun(options, csv, columns, console).run();
}

}  // namespace soms::command
