#include "apps/soms/solid/solid.h"

#include "soms/base/error.h"
#include "soms/query/print.h"
#include "soms/query/reference/solid.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/soms/pairs/pose_run.h"
#include "apps/soms/solid/solid_output.h"
#include "apps/soms/solid/solid_parts.h"
#include "apps/soms/solid/solid_text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

namespace {

constexpr std::uint64_t kPosesInText = 20;  // that a person may want to read

/// The relation of two models, pose by pose.
class SolidRun : public PoseRun {
 public:
  SolidRun(const SolidVerbOptions& options, SolidFiles& files, Console& console)
      : PoseRun(options,
                {.verb = "solid",
                 .fail_if_found = options.fail_if_solid,
                 .has_files = !options.csv.empty() || !options.binary.empty()},
                console),
        files_(files),
        options_{.deadline = console.deadline()},
        a_(closed_body(shape_a())),
        b_(closed_body(shape_b())) {}

 private:
  [[nodiscard]] ClosedBody closed_body(const Shape& shape) const {
    try {
      return console().run(
          "looking for edges of an odd number of triangles",
          [&](const Parallel& parallel) { return ClosedBody(Body(shape), parallel); });
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::not_closed) {
        throw;
      }
      throw Error(error.kind(), printable(error.place()),
                  "soms info lists these edges; close the surface there, or add --by part, which "
                  "answers for the parts that are closed");
    }
  }

  void reserve(std::size_t rows) override { answers_.assign(rows, {}); }

  void ask(std::size_t k, const Body& a, const Body& b, const Parallel& parallel) override {
    try {
      answers_[k] = solid(a_.at(a.pose), b_.at(b.pose), options_, parallel);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::not_closed) {
        throw;
      }
      answers_[k] = open_answer(a, b, options_.deadline, parallel);
    }
  }

  void ask(std::size_t begin, const Shape&, std::span<const Pose> poses, const Body& b,
           const Parallel& parallel) override {
    const SolidBatch batch = solid(a_, poses, b_.at(b.pose), options_, parallel);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_[begin + k] = batch.at(k);
    }
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const Solid& answer = answers_[k];
    return {.found = shares_interior(answer.relation),
            .undecided = answer.relation == Relation::undecided,
            .cut = answer.coverage == Coverage::cut};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Solid& answer = answers_[k];
    if (answer.relation == Relation::undecided) {
      return std::nullopt;
    }
    const Solid truth = console().run("verifying", [&](const Parallel& parallel) {
      return reference::solid_by_brute_force(body_a(k), body_b(k), parallel);
    });
    if (truth.relation == answer.relation && truth.surfaces_meet == answer.surfaces_meet) {
      return std::nullopt;
    }
    return fmt::format("brute force finds {}, but the answer is {}", printed(truth),
                       printed(answer));
  }

  void print_answer(std::size_t k, bool right) override {
    const Solid& answer = answers_[k];
    const std::uint64_t pose = totals().rows;
    ++counts_[static_cast<std::size_t>(answer.relation)];
    files_.csv.add(pose, answer);
    files_.columns.add(answer);
    if (console().shared().json) {
      console().print(fmt::format("{{\"schema\":\"soms.solid/2\",\"pose\":{}{}{}{}}}\n", pose,
                                  field_keys(answer), coverage_keys(answer.coverage, answer.cost),
                                  report_keys(report(), pose, right)));
    } else if (report().single) {
      console().print(
          solid_in_words(answer, printable(report().a.source), printable(report().b.source)) +
          "\n");
    } else {
      print_line(pose, answer);
    }
  }

  void print_line(std::uint64_t pose, const Solid& answer) {
    if (pose == 0) {
      console().print(fmt::format("{:>6}  {:<9}  surfaces meet\n", "pose", "relation"));
    }
    if (pose < kPosesInText) {
      console().print(fmt::format("{:>6}  {:<9}  {}\n", pose, relation_label(answer.relation),
                                  answer.surfaces_meet ? "yes" : "no"));
    }
  }

  void print_totals() override {
    if (report().single) {
      return;
    }
    if (totals().rows > kPosesInText) {
      console().print(fmt::format("   and {} more; --json lists all\n",
                                  counted(totals().rows - kPosesInText, "pose")));
    }
    std::string line = counted(totals().rows, "pose");
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] != 0) {
        line += fmt::format("{} {} {}", line.find(':') == std::string::npos ? ":" : ",",
                            with_commas(counts_[i]), relation_label(static_cast<Relation>(i)));
      }
    }
    console().print(line + "\n");
  }

  void finish_outputs() override {
    files_.csv.finish();
    files_.columns.finish();
  }

  SolidFiles& files_;
  SolidOptions options_;
  ClosedBody a_;
  ClosedBody b_;
  std::vector<Solid> answers_;
  std::array<std::uint64_t, 7> counts_ = {};  // of each relation
};

/// The relations of the parts of two models, pose by pose.
class SolidPartsRun : public PoseRun {
 public:
  SolidPartsRun(const SolidVerbOptions& options, SolidPartFiles& files, Console& console)
      : PoseRun(options,
                {.verb = "solid",
                 .fail_if_found = options.fail_if_solid,
                 .has_files = !options.csv.empty() || !options.binary.empty()},
                console),
        files_(files),
        a_(parts_of(report().a)),
        b_(parts_of(report().b)) {}

 private:
  [[nodiscard]] std::vector<PartBody> parts_of(const MeshView& mesh) const {
    return console().run("looking for closed parts", [&](const Parallel& parallel) {
      return part_bodies(mesh, {}, parallel, OpenParts::joined);
    });
  }

  void reserve(std::size_t rows) override { answers_.assign(rows, {}); }

  void ask(std::size_t k, const Body& a, const Body& b, const Parallel& parallel) override {
    answers_[k] = solid_pairs(a_, a.pose, b_, b.pose, console().deadline(), parallel);
  }

  void ask(std::size_t begin, const Shape& a, std::span<const Pose> poses, const Body& b,
           const Parallel& parallel) override {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      ask(begin + k, Body(a, poses[k]), b, parallel);
    }
  }

  [[nodiscard]] std::uint64_t held() const override {
    std::uint64_t pairs = 0;
    for (const std::vector<SolidPair>& answer : answers_) {
      pairs += answer.size();
    }
    return pairs;
  }

  [[nodiscard]] Coverage coverage(std::size_t k) const {
    return std::any_of(answers_[k].begin(), answers_[k].end(),
                       [](const SolidPair& p) { return p.answer.coverage == Coverage::cut; })
               ? Coverage::cut
               : Coverage::complete;
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    Outcome outcome{.cut = coverage(k) == Coverage::cut};
    for (const SolidPair& pair : answers_[k]) {
      outcome.found = outcome.found || shares_interior(pair.answer.relation);
      outcome.undecided = outcome.undecided || pair.answer.relation == Relation::undecided;
    }
    outcome.undecided = outcome.undecided && !outcome.found;
    return outcome;
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    for (const SolidPair& pair : answers_[k]) {
      if (pair.answer.relation == Relation::undecided) {
        continue;
      }
      const Solid truth = console().run("verifying", [&](const Parallel& parallel) {
        return reference::solid_by_brute_force(Body(pair.a->body.shape, pose_a(k)),
                                               Body(pair.b->body.shape, pose_b(k)), parallel);
      });
      if (truth.relation != pair.answer.relation) {
        return fmt::format("brute force finds parts {} and {} {}, but the answer is {}",
                           pair.a->part, pair.b->part, relation_label(truth.relation),
                           relation_label(pair.answer.relation));
      }
    }
    return std::nullopt;
  }

  void print_answer(std::size_t k, bool right) override {
    files_.csv.add(totals().rows, report().a, report().b, answers_[k]);
    files_.columns.add(answers_[k], coverage(k) == Coverage::cut);
    if (console().shared().json) {
      print_json(k, right);
      return;
    }
    const std::string pose = report().single ? "" : fmt::format("pose {}: ", totals().rows);
    const std::size_t count = answers_[k].size();
    console().print(count == 0 ? fmt::format("{}all parts are clear of each other\n", pose)
                               : fmt::format("{}{} of parts {} not clear{}\n", pose,
                                             counted(count, "pair"), count == 1 ? "is" : "are",
                                             report().single ? ":" : ""));
    for (std::size_t i = 0; i < count && report().single; ++i) {
      const SolidPair& pair = answers_[k][i];
      console().print(fmt::format("  {} and {}: {}{}\n", body_in_text(report().a, *pair.a),
                                  body_in_text(report().b, *pair.b),
                                  relation_label(pair.answer.relation), reason(pair)));
    }
  }

  [[nodiscard]] static std::string body_in_text(const MeshView& mesh, const PartBody& body) {
    return printable(body_label(mesh, body.part, body.joined));
  }

  /// ", A is open (3 edges of an odd number of triangles)"
  [[nodiscard]] static std::string reason(const SolidPair& pair) {
    if (pair.answer.why == Undecided::deadline) {
      return ", out of time";
    }
    std::string text;
    for (const auto& [part, name] : {std::pair{pair.a, "A"}, std::pair{pair.b, "B"}}) {
      if (pair.answer.why == Undecided::open && part->odd_edges != 0) {
        text += fmt::format(", {} is open at {}", name, counted(part->odd_edges, "edge"));
      }
    }
    return pair.answer.why == Undecided::open && text.empty() ? ", open where this pose rounds it"
                                                              : text;
  }

  void print_json(std::size_t k, bool right) {
    const std::uint64_t pose = totals().rows;
    Cost cost;
    for (const SolidPair& pair : answers_[k]) {
      cost += pair.answer.cost;
    }
    console().print(fmt::format("{{\"schema\":\"soms.solid/2\",\"pose\":{}{}{},\"parts\":[", pose,
                                coverage_keys(coverage(k), cost),
                                report_keys(report(), pose, right)));
    for (const SolidPair& pair : answers_[k]) {
      std::string text =
          fmt::format("{}{{\"a\":{},\"b\":{}{}", &pair == answers_[k].data() ? "" : ",",
                      json_text(body_as_json(report().a, pair.a->part, pair.a->joined)),
                      json_text(body_as_json(report().b, pair.b->part, pair.b->joined)),
                      field_keys(pair.answer));
      if (pair.answer.why == Undecided::open) {
        text += fmt::format(",\"odd_edges\":[{},{}]", pair.a->odd_edges, pair.b->odd_edges);
      }
      console().print(text + "}");
    }
    console().print("]}\n");
  }

  void print_totals() override {
    if (!report().single) {
      console().print(fmt::format("{}: parts share interior at {}\n",
                                  counted(totals().rows, "pose"), with_commas(totals().found)));
    }
  }

  void finish_outputs() override {
    files_.csv.finish();
    files_.columns.finish();
  }

  SolidPartFiles& files_;
  std::vector<PartBody> a_;
  std::vector<PartBody> b_;
  std::vector<std::vector<SolidPair>> answers_;
};

}  // namespace

Action add_solid(Parser& parser, Shared&) {
  const auto options = std::make_shared<SolidVerbOptions>();
  add_posed_models(parser, *options);
  add_choice<bool>(parser, "--by", options->by_part, {{"model", false}, {"part", true}},
                   "whether to answer for the models or for each pair of their parts")
      ->group(kQuestionGroup);
  add_choice<bool>(parser, "--fail-if", options->fail_if_solid, {{"solid", true}},
                   "exit with status 1 if interior is shared; touching is not enough")
      ->group(kQuestionGroup);
  add_output(parser, "--csv", options->csv, "write the answers as CSV")->group(kQuestionGroup);
  add_binary(parser, options->binary);
  add_verify(parser, *options);
  add_model_reading(parser, *options);
  parser.footer(
      "Exact: clear, touching, crossing, A in B, B in A or same. Both models must be closed; soms\n"
      "info says whether they are. Which way their triangles face does not matter." +
      example_of_pair("solid knot.ply ball.off --pose \"0.5 0 0\""));
  return [options, &parser](Console& console) {
    settle(parser, *options);
    return run_solid(*options, console);
  };
}

int run_solid(const SolidVerbOptions& options, Console& console) {
  check_files(options, {{"--csv", options.csv}, {"--binary", options.binary}});
  check_extension("--csv", options.csv, {".csv"});
  check_extension("--binary", options.binary, {".npz"});
  if (options.by_part) {
    SolidPartFiles files{SolidPartCsv(options.csv), SolidPartColumns(options.binary)};
    return SolidPartsRun(options, files, console).run();
  }
  SolidFiles files{FieldCsv::of<Solid>(options.csv, "pose"), AnswerArrays(options.binary)};
  files.columns.begin<Solid>();
  return SolidRun(options, files, console).run();
}

}  // namespace soms::command
