#include "apps/soms/contains.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"

#include "apps/soms/closed_body.h"
#include "apps/soms/pair_options.h"
#include "apps/soms/pair_report.h"
#include "apps/support/console.h"
#include "apps/support/json.h"
#include "apps/support/point_source.h"
#include "apps/support/row_run.h"
#include "apps/support/text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// A run whose rows are points beside one model.
class ContainsRun : public RowRun {
 public:
  ContainsRun(const ContainsVerbOptions& options, Console& console)
      : RowRun({.verb = "contains", .noun = "point", .verify = options.verify}, console),
        verified_(options.verify),
        points_(options.points, console),
        pose_(stated_pose(options, console)),
        body_(body_of(options)) {}

 private:
  [[nodiscard]] ClosedBody body_of(const ContainsVerbOptions& options) {
    Mesh mesh = read_model(options.model, options.reading, console());
    if (options.closed_parts) {
      mesh = without_open_parts(std::move(mesh));
    }
    Shape shape = build_shape(std::move(mesh), {.build = options.build}, console());
    return closed_body(Body(std::move(shape), pose_), "add --closed-parts", console());
  }

  /// What --closed-parts asks about. Says what is left out.
  [[nodiscard]] Mesh without_open_parts(Mesh mesh) {
    const std::uint64_t all = mesh.triangles.size();
    Mesh left = console().run("looking for closed parts", [&](const Parallel& parallel) {
      return closed_parts(mesh, pose_, parallel);
    });
    if (left.triangles.empty() && all != 0) {
      throw Error(ErrorKind::not_closed, printable(mesh.source) + ": no connected part is closed",
                  "soms info lists the edges where they are open");
    }
    left_out_ = all - left.triangles.size();
    if (left_out_ != 0) {
      console().note(fmt::format("{}: {} of open parts left out", printable(mesh.source),
                                 counted(left_out_, "triangle")));
    }
    return left;
  }

  void begin() override {}

  /// Whoever reads a program's answers needs no other form for a single row.
  [[nodiscard]] bool is_single() const override { return false; }

  void clear_block() override { block_.clear(); }

  bool ready() override { return points_.ready(); }

  bool read_row() override {
    const std::optional<Vec3> point = points_.next();
    if (point) {
      block_.push_back(*point);
    }
    return point.has_value();
  }

  std::uint64_t answer_block() override {
    answers_ = contains(body_, block_, {.deadline = console().deadline()}, console().parallel());
    return 0;
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const bool undecided = answers_.side[k] == Side::undecided;
    return {.found = answers_.side[k] == Side::inside, .undecided = undecided, .cut = undecided};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Side side = answers_.side[k];
    if (side == Side::undecided) {
      return std::nullopt;
    }
    const Side truth = console().run("verifying", [&](const Parallel&) {
      return reference::contains_by_brute_force(body_.body(), block_[k]);
    });
    return truth == side ? std::nullopt
                         : std::optional(fmt::format("brute force finds {}, but the answer is {}",
                                                     name(truth), name(side)));
  }

  void print_row(std::size_t k, bool right, bool last) override {
    const Side side = answers_.side[k];
    ++counts_[static_cast<std::size_t>(side)];
    if (console().shared().json) {
      print_json(k, right, last);
      return;
    }
    if (totals().rows == 0) {
      console().print(fmt::format("{:>6}  {:<9}  at\n", "point", "side"));
    }
    if (totals().rows < kPointsInText) {
      console().print(
          fmt::format("{:>6}  {:<9}  {}\n", totals().rows, name(side), point_in_text(block_[k])));
    }
  }

  void print_json(std::size_t k, bool right, bool last) {
    const Contains answer = answers_.at(k);
    std::string more;
    if (verified_) {
      more += right ? ",\"verified\":true" : ",\"verified\":false";
    }
    if (last) {
      more += ",\"timed_out\":true";
    }
    const std::array<const Mesh*, 1> meshes{&body_.body().shape.mesh()};
    const std::vector<std::string> notes =
        totals().rows == 0 ? notes_of(meshes) : std::vector<std::string>{};
    if (left_out_ != 0 && totals().rows == 0) {
      more += fmt::format(",\"triangles_left_out\":{}", left_out_);
    }
    if (!notes.empty()) {
      more += ",\"notes\":" + json_text(notes);
    }
    console().print(fmt::format(
        "{{\"schema\":\"soms.contains/1\",\"point\":{},\"side\":\"{}\"{}{}}}\n", totals().rows,
        name(answer.side), coverage_keys(answer.coverage, answer.cost), more));
  }

  void print_totals() override {
    if (totals().rows > kPointsInText) {
      console().print(fmt::format("   and {} more; --json lists all\n",
                                  counted(totals().rows - kPointsInText, "point")));
    }
    const auto count = [&](Side side) {
      return with_commas(counts_[static_cast<std::size_t>(side)]);
    };
    std::string line =
        fmt::format("{}: {} inside, {} outside, {} on the surface", counted(totals().rows, "point"),
                    count(Side::inside), count(Side::outside), count(Side::on));
    if (totals().undecided != 0) {
      line += fmt::format(", {} undecided", count(Side::undecided));
    }
    console().print(line + "\n");
  }

  void doubt() override {}

  void finish(End) override {}

  bool verified_;
  PointSource points_;
  Pose pose_;
  std::uint64_t left_out_ = 0;  // triangles of open parts
  ClosedBody body_;
  std::vector<Vec3> block_;
  ContainsBatch answers_;
  std::array<std::uint64_t, 4> counts_ = {};  // of each side
};

}  // namespace

Action add_contains(CLI::App& app, Shared&) {
  const auto options = std::make_shared<ContainsVerbOptions>();
  add_points(app, *options, "a closed model");
  app.add_flag("--closed-parts", options->closed_parts,
               "leave out connected parts that are not closed by themselves")
      ->group(kQuestionGroup);
  add_point_options(app, *options);
  app.footer(
      "Exact for every point: inside, outside, or on the surface. The model must be closed; soms\n"
      "info says whether it is. Which way its triangles face does not matter.\n\nExample:\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  printf 'x,y,z\\n0,0,0\\n2,0,0\\n' | soms contains ball.off --points -");
  return [options, &app](Console& console) {
    check_point_options(app, *options);
    return run_contains(*options, console);
  };
}

int run_contains(const ContainsVerbOptions& options, Console& console) {
  return ContainsRun(options, console).run();
}

}  // namespace soms::command
