#include "apps/soms/probes/contains.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/shapes.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/probes/contains_by_part.h"
#include "apps/soms/probes/contains_winding.h"
#include "apps/soms/probes/side_question.h"
#include "apps/soms/solid/closed_body.h"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Which points are in a closed model?
class ContainsQuestion : public SideQuestion<Contains> {
 public:
  ContainsQuestion(const ContainsVerbOptions& options, const ProbeRows<PointSource>& rows,
                   const Pose& pose, Console& console)
      : SideQuestion(rows),
        console_(console),
        body_(body_of(options, pose)),
        report_(options, body_.body().shape.mesh()) {}

  std::uint64_t answer(const ShowProgress&) override {
    set(contains(body_, points(), console_.limits()));
    return 0;
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Side side = at(k).side;
    if (side == Side::undecided) {
      return std::nullopt;
    }
    const Side truth = console_.run("verifying", [&](const Limits&) {
      return reference::contains_by_brute_force(body_.body(), point(k));
    });
    return truth == side ? std::nullopt
                         : std::optional(fmt::format("brute force finds {}, but the answer is {}",
                                                     name(truth), name(side)));
  }

 private:
  [[nodiscard]] ClosedBody body_of(const ContainsVerbOptions& options, const Pose& pose) {
    const ShapeOptions built{.build = options.build};
    Shape shape =
        options.closed_parts
            ? build_shape(without_open_parts(
                              read_only_model(options.model, options.reading, console_), pose),
                          built, console_)
            : load_only_model(options.model, options.reading, built, console_).shape;
    return closed_body(Body(std::move(shape), pose),
                       "add --closed-parts, --by part, or --winding, which answers for open "
                       "models, too",
                       console_);
  }

  /// What --closed-parts asks about. Says what is left out.
  [[nodiscard]] Mesh without_open_parts(Mesh mesh, const Pose& pose) {
    const std::uint64_t all = mesh.triangles.size();
    Mesh left = console_.run("looking for closed parts", [&](const Limits& limits) {
      return closed_parts(mesh, pose, limits);
    });
    if (left.triangles.empty() && all != 0) {
      throw Error(ErrorKind::not_closed, printable(mesh.source) + ": no connected part is closed",
                  "soms info lists the edges where they are open");
    }
    left_out_ = all - left.triangles.size();
    if (left_out_ != 0) {
      console_.note(fmt::format("{}: {} of open parts left out", printable(mesh.source),
                                counted(left_out_, "triangle")));
    }
    return left;
  }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return (left_out_ != 0 && row.number == 0 ? fmt::format(",\"triangles_left_out\":{}", left_out_)
                                              : std::string()) +
           report_.keys(row);
  }

  Console& console_;
  std::uint64_t left_out_ = 0;  // triangles of open parts
  ClosedBody body_;
  ProbeReport report_;
};

/// \errors ErrorKind::usage for options that have no effect together.
void check_question(const Parser& parser, const ContainsVerbOptions& options) {
  if (parser.count("--width") != 0 && !options.winding) {
    throw Error(ErrorKind::usage, "--width is about winding numbers", "add --winding");
  }
  if (options.winding && options.closed_parts) {
    throw Error(ErrorKind::usage, "--winding needs no part to be closed",
                "leave out --closed-parts");
  }
  if (options.by != ContainsBy::model && (options.winding || options.closed_parts)) {
    throw Error(ErrorKind::usage, "--by part and --by connected answer for each part by itself",
                "leave out --winding and --closed-parts");
  }
  if (options.by != ContainsBy::model && !options.outputs.npz.empty()) {
    throw Error(
        ErrorKind::usage,
        fmt::format("-o {} has one row per point, and --by part several", options.outputs.npz),
        "leave out one of them");
  }
}

}  // namespace

Action add_contains(Parser& parser, Shared&) {
  const auto options = std::make_shared<ContainsVerbOptions>();
  add_points(parser, *options, "a model, closed unless --winding or --by is given");
  parser
      .add_flag("--closed-parts", options->closed_parts,
                "leave out connected parts that are not closed by themselves")
      ->group(kQuestionGroup);
  add_choice<ContainsBy>(parser, "--by", options->by,
                         {{"model", ContainsBy::model},
                          {"part", ContainsBy::part},
                          {"connected", ContainsBy::connected}},
                         "answer for the model, or for each named or connected part by itself")
      ->group(kQuestionGroup);
  parser
      .add_flag("--winding", options->winding,
                "decide by the winding number, also of an open model: inside where it is above 1/2")
      ->group(kQuestionGroup);
  parser
      .add_option_function(
          "--width",
          [options](const std::string& text) {
            options->width = parse_number("--width", text);
            if (options->width < 0 || options->width > 1) {
              throw Error(ErrorKind::usage, "--width: " + text + " is not a width",
                          "give 0 to 1; the default is 1e-9");
            }
          },
          "with --winding: by how much far triangles may widen its bracket")
      ->option_text("W")
      ->group(kQuestionGroup);
  add_probe_options(parser, *options);
  parser.footer(
      "Exact for every point: inside, outside, or on the surface. The model must be closed; soms\n"
      "info says whether it is. Which way its triangles face does not matter, but for --winding.\n"
      "\nExample:\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  printf 'x,y,z\\n0,0,0\\n2,0,0\\n' | soms contains ball.off --points -");
  return [options, &parser](Console& console) {
    check_question(parser, *options);
    check_probe_options(parser, *options, "--points", options->points);
    return run_contains(*options, console);
  };
}

int run_contains(const ContainsVerbOptions& options, Console& console) {
  if (options.by != ContainsBy::model) {
    return run_contains_by_part(options, console);
  }
  if (options.winding) {
    return run_contains_winding(options, console);
  }
  return run_probes<PointSource>(options, options.points, {.verb = "contains"}, console,
                                 [&](const auto& rows, const Pose& pose) {
                                   return ContainsQuestion(options, rows, pose, console);
                                 });
}

}  // namespace soms::command
