#include "apps/soms/solid/solid.h"

#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/query/print.h"
#include "soms/query/reference/solid.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/soms/answers/array_columns.h"
#include "apps/soms/pairs/pair_question.h"
#include "apps/soms/solid/closed_body.h"
#include "apps/soms/solid/solid_parts.h"
#include "apps/soms/solid/solid_text.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace soms::command {

namespace {

constexpr const char* kOtherwise = "add --by part, which answers for the parts that are closed";

struct AskSolid {
  ClosedBody a;
  ClosedBody b;

  Solid operator()(const Limits& limits, const Body& at_a, const Body& at_b) const {
    try {
      return solid(a.at(at_a.pose), b.at(at_b.pose), limits);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::not_closed) {
        throw;
      }
      return open_answer(at_a, at_b, limits);
    }
  }

  SolidBatch operator()(const Limits& limits, const Shape& /*a*/, std::span<const Pose> poses,
                        const Body& still) const {
    return solid(a, poses, b.at(still.pose), limits);
  }
};

/// The relation of two models.
class SolidQuestion : public PairQuestion<Solid, AskSolid> {
 public:
  SolidQuestion(const PoseRows& rows, Console& console)
      : PairQuestion(rows, "solid",
                     {closed_body(Body(rows.shape_a()), kOtherwise, console),
                      closed_body(Body(rows.shape_b()), kOtherwise, console)}),
        console_(console) {}

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Solid answer = at(k);
    if (undecided(answer)) {
      return std::nullopt;
    }
    const Solid truth = console_.run("verifying", [&](const Limits& limits) {
      return reference::solid_by_brute_force(rows().body_a(k), rows().body_b(k), limits);
    });
    if (truth.relation == answer.relation && truth.surfaces_meet == answer.surfaces_meet) {
      return std::nullopt;
    }
    return fmt::format("brute force finds {}, but the answer is {}", printed(truth),
                       printed(answer));
  }

  void count(const AnsweredRow& row) override {
    ++counts_[static_cast<std::size_t>(at(row.k).relation)];
  }

  [[nodiscard]] std::string sentence(std::size_t k) const override {
    RowOutcome known = outcome(k);
    known.found = known.found || at(k).relation == Relation::touching;
    return painted(
        solid_in_words(at(k), printable(pair().a.source), printable(pair().b.source)) + "\n",
        known);
  }

  [[nodiscard]] std::string text_head() const override {
    return fmt::format(kRow, "pose", "relation", "surfaces meet");
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    const Solid answer = at(row.k);
    return fmt::format(kRow, row.number, relation_label(answer.relation),
                       answer.surfaces_meet ? "yes" : "no");
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    std::string line = counted(totals.rows, "pose");
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] != 0) {
        line += fmt::format("{} {} {}", line.find(':') == std::string::npos ? ":" : ",",
                            with_commas(counts_[i]), relation_label(static_cast<Relation>(i)));
      }
    }
    return line + "\n";
  }

 private:
  static constexpr const char kRow[] = "{:>6}  {:<9}  {}\n";

  [[nodiscard]] bool found(const Solid& answer) const override {
    return shares_interior(answer.relation);
  }

  [[nodiscard]] bool undecided(const Solid& answer) const override {
    return answer.relation == Relation::undecided;
  }

  const Console& console_;
  std::array<std::uint64_t, 7> counts_ = {};  // of each relation
};

/// The relations of the parts of two models.
class SolidPartsQuestion : public Question, private PoseAnswers {
 public:
  SolidPartsQuestion(const PoseRows& rows, const Console& console)
      : rows_(rows),
        console_(console),
        a_(parts_of(rows.shape_a().mesh())),
        b_(parts_of(rows.shape_b().mesh())) {}

  std::uint64_t answer(const ShowProgress& show) override {
    answers_.assign(rows_.size(), {});
    rows_.answer(*this, show);
    std::uint64_t pairs = 0;
    for (const std::vector<SolidPair>& answer : answers_) {
      pairs += answer.size();
    }
    return pairs;
  }

  [[nodiscard]] RowOutcome outcome(std::size_t k) const override {
    RowOutcome outcome{.cut = coverage(k) == Coverage::cut};
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
      const Solid truth = console_.run("verifying", [&](const Limits& limits) {
        return reference::solid_by_brute_force(Body(pair.a->body.shape, rows_.pose_a(k)),
                                               Body(pair.b->body.shape, rows_.pose_b(k)), limits);
      });
      if (truth.relation != pair.answer.relation) {
        return fmt::format("brute force finds parts {} and {} {}, but the answer is {}",
                           pair.a->part, pair.b->part, relation_label(truth.relation),
                           relation_label(pair.answer.relation));
      }
    }
    return std::nullopt;
  }

  void json(const AnsweredRow& row, JsonRows& rows) const override {
    const std::vector<SolidPair>& answer = answers_[row.k];
    Cost cost;
    for (const SolidPair& pair : answer) {
      cost += pair.answer.cost;
    }
    std::string text = fmt::format("{{\"schema\":\"soms.solid/2\",\"pose\":{}{}{},\"parts\":[",
                                   row.number, coverage_keys(coverage(row.k), cost),
                                   report_keys(pair(), row.number, row.right));
    for (const SolidPair& one : answer) {
      text += fmt::format("{}{{\"a\":{},\"b\":{}{}", &one == answer.data() ? "" : ",",
                          json_text(body_as_json(pair().a, one.a->part, one.a->joined)),
                          json_text(body_as_json(pair().b, one.b->part, one.b->joined)),
                          field_keys(one.answer));
      if (one.answer.why == Undecided::open) {
        text += fmt::format(",\"odd_edges\":[{},{}]", one.a->odd_edges, one.b->odd_edges);
      }
      rows.put(text + "}");
      text.clear();
    }
    rows.put(text + "]}");
    rows.end_row();
  }

  [[nodiscard]] std::string sentence(std::size_t k) const override {
    const std::size_t count = answers_[k].size();
    std::string text = summary(count, ":");
    for (const SolidPair& one : answers_[k]) {
      text += fmt::format("  {} and {}: {}{}\n", body_in_text(pair().a, *one.a),
                          body_in_text(pair().b, *one.b), relation_label(one.answer.relation),
                          reason(one));
    }
    return text;
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    return fmt::format("pose {}: {}", row.number, summary(answers_[row.k].size(), ""));
  }

  [[nodiscard]] std::uint64_t most_text() const override {
    return std::numeric_limits<std::uint64_t>::max();
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    return fmt::format("{}: parts share interior at {}\n", counted(totals.rows, "pose"),
                       with_commas(totals.found));
  }

  [[nodiscard]] std::string csv_head() const override {
    return "pose,part_a,name_a,path_a,part_b,name_b,path_b,relation,surfaces_meet,why,"
           "odd_edges_a,odd_edges_b,coverage";
  }

  void csv(const AnsweredRow& row, CsvFile& file) const override {
    for (const SolidPair& one : answers_[row.k]) {
      const Solid& answer = one.answer;
      file.line() += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{}", row.number, part_csv_fields(pair().a, one.a->part),
          path_field(pair().a, one.a->part), part_csv_fields(pair().b, one.b->part),
          path_field(pair().b, one.b->part), name(answer.relation), answer.surfaces_meet,
          name(answer.why), one.a->odd_edges, one.b->odd_edges, name(answer.coverage));
      file.end_line();
    }
  }

  void begin_columns(NpzFile& file) override {
    relation_ = &file.names("relation", kWords<Relation>.names);
    surfaces_meet_ = &file.column("surfaces_meet", NpzColumn::Kind::flag);
    why_ = &file.names("why", kWords<Undecided>.names);
    offsets_.begin(file, "offsets");
    parts_ = &file.column("parts", NpzColumn::Kind::count, {2});
    coverage_ = &file.names("coverage", kWords<Coverage>.names);
  }

  void add_columns(std::size_t rows) override {
    for (std::size_t k = 0; k < rows; ++k) {
      for (const SolidPair& one : answers_[k]) {
        parts_->add(number_of_part(one.a->part));
        parts_->add(number_of_part(one.b->part));
        add_code(*relation_, one.answer.relation);
        surfaces_meet_->add(one.answer.surfaces_meet);
        add_code(*why_, one.answer.why);
      }
      offsets_.add(answers_[k].size());
      add_code(*coverage_, coverage(k));
    }
  }

 private:
  void answer_one(std::size_t k, const Body& a, const Body& b, const Limits& limits) override {
    answers_[k] = solid_pairs(a_, a.pose, b_, b.pose, limits);
  }

  void answer_some(std::size_t begin, const Shape& a, std::span<const Pose> poses,
                   const StillBody& b, const Limits& limits) override {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      answer_one(begin + k, Body(a, poses[k]), std::get<Body>(b), limits);
    }
  }

  [[nodiscard]] std::vector<PartBody> parts_of(const MeshView& mesh) const {
    return console_.run("looking for closed parts", [&](const Limits& limits) {
      return part_bodies(mesh, {}, limits, OpenParts::joined);
    });
  }

  [[nodiscard]] const PairReport& pair() const { return rows_.pair(); }

  [[nodiscard]] Coverage coverage(std::size_t k) const {
    return std::any_of(answers_[k].begin(), answers_[k].end(),
                       [](const SolidPair& p) { return p.answer.coverage == Coverage::cut; })
               ? Coverage::cut
               : Coverage::complete;
  }

  [[nodiscard]] static std::string summary(std::size_t count, const char* end) {
    return count == 0 ? "all parts are clear of each other\n"
                      : fmt::format("{} of parts {} not clear{}\n", counted(count, "pair"),
                                    count == 1 ? "is" : "are", end);
  }

  [[nodiscard]] static std::string path_field(const MeshView& mesh, std::uint32_t part) {
    return csv_field(part_path_label(mesh, part));
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

  const PoseRows& rows_;
  const Console& console_;
  std::vector<PartBody> a_;
  std::vector<PartBody> b_;
  std::vector<std::vector<SolidPair>> answers_;
  OffsetColumn offsets_;
  NpzColumn* parts_ = nullptr;
  NpzColumn* relation_ = nullptr;
  NpzColumn* surfaces_meet_ = nullptr;
  NpzColumn* why_ = nullptr;
  NpzColumn* coverage_ = nullptr;
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
  add_renamed_outputs(parser, options->outputs,
                      {AnswerFile::csv, AnswerFile::npz, AnswerFile::json, AnswerFile::lines},
                      kQuestionGroup);
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
  PoseTerms terms{.verb = "solid", .fail_if_found = options.fail_if_solid};
  if (options.by_part) {
    return run_pairs(options, std::move(terms), console,
                     [&](const PoseRows& rows) { return SolidPartsQuestion(rows, console); });
  }
  return run_pairs(options, std::move(terms), console,
                   [&](const PoseRows& rows) { return SolidQuestion(rows, console); });
}

}  // namespace soms::command
