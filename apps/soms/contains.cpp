#include "apps/soms/contains.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"

#include "apps/soms/answer_columns.h"
#include "apps/soms/closed_body.h"
#include "apps/soms/pair_options.h"
#include "apps/soms/pair_report.h"
#include "apps/soms/probe_run.h"
#include "apps/support/console.h"
#include "apps/support/point_source.h"
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

/// A run whose rows are points beside a closed model.
class ContainsRun : public ProbeRun<PointSource> {
 public:
  ContainsRun(const ContainsVerbOptions& options, SideColumns& columns, Console& console)
      : ProbeRun(options, options.points,
                 {.verb = "contains", .has_files = !options.binary.empty()}, console),
        columns_(columns),
        body_(body_of(options)) {}

 private:
  [[nodiscard]] ClosedBody body_of(const ContainsVerbOptions& options) {
    Mesh mesh = read_model(options.model, options.reading, console());
    if (options.closed_parts) {
      mesh = without_open_parts(std::move(mesh));
    }
    Shape shape = build_shape(std::move(mesh), {.build = options.build}, console());
    return closed_body(Body(std::move(shape), pose()), "add --closed-parts", console());
  }

  /// What --closed-parts asks about. Says what is left out.
  [[nodiscard]] Mesh without_open_parts(Mesh mesh) {
    const std::uint64_t all = mesh.triangles.size();
    Mesh left = console().run("looking for closed parts", [&](const Parallel& parallel) {
      return closed_parts(mesh, pose(), parallel);
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

  std::uint64_t answer_block() override {
    answers_ = contains(body_, block(), {.deadline = console().deadline()}, console().parallel());
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
      return reference::contains_by_brute_force(body_.body(), block()[k]);
    });
    return truth == side ? std::nullopt
                         : std::optional(fmt::format("brute force finds {}, but the answer is {}",
                                                     name(truth), name(side)));
  }

  void print_row(std::size_t k, bool right, bool last) override {
    const Side side = answers_.side[k];
    ++counts_[static_cast<std::size_t>(side)];
    columns_.add(side);
    if (console().shared().json) {
      print_json(body_.body().shape.mesh(), "point", keys(k), right, last);
      return;
    }
    if (totals().rows == 0) {
      console().print(fmt::format("{:>6}  {:<9}  at\n", "point", "side"));
    }
    if (totals().rows < kProbesInText) {
      console().print(
          fmt::format("{:>6}  {:<9}  {}\n", totals().rows, name(side), point_in_text(block()[k])));
    }
  }

  [[nodiscard]] std::string keys(std::size_t k) const {
    const Contains answer = answers_.at(k);
    std::string keys = fmt::format(",\"side\":\"{}\"{}", name(answer.side),
                                   coverage_keys(answer.coverage, answer.cost));
    if (left_out_ != 0 && totals().rows == 0) {
      keys += fmt::format(",\"triangles_left_out\":{}", left_out_);
    }
    return keys;
  }

  void print_totals() override {
    print_left_out();
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

  void finish(End) override { columns_.finish(); }

  SideColumns& columns_;
  std::uint64_t left_out_ = 0;  // triangles of open parts
  ClosedBody body_;
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
  add_binary(app, options->binary);
  add_probe_options(app, *options);
  app.footer(
      "Exact for every point: inside, outside, or on the surface. The model must be closed; soms\n"
      "info says whether it is. Which way its triangles face does not matter.\n\nExample:\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  printf 'x,y,z\\n0,0,0\\n2,0,0\\n' | soms contains ball.off --points -");
  return [options, &app](Console& console) {
    check_probe_options(app, *options, options->points);
    return run_contains(*options, console);
  };
}

int run_contains(const ContainsVerbOptions& options, Console& console) {
  check_outputs({{"MODEL", options.model},
                 {"--points", options.points},
                 {"--pose", options.pose.value_or("")}},
                {{"--binary", options.binary}});
  check_extension("--binary", options.binary, {".npz"});
  SideColumns columns(options.binary);
  return ContainsRun(options, columns, console).run();
}

}  // namespace soms::command
