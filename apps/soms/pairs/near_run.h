/// \file
/// A question of how near two models are, queried pose by pose: what `distance` and `within` share.
#pragma once

#include "apps/cli/console.h"
#include "apps/output/output.h"
#include "apps/shards/shard_files.h"
#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/pairs/near_options.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/near_page.h"
#include "apps/soms/pairs/pair_page.h"
#include "apps/soms/pairs/pose_run.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// Files of answers, opened before the models are read.
struct NearFiles {
  explicit NearFiles(const NearOptions& options) : csv(options.csv), columns(options.binary) {
    if (!options.report.empty()) {
      page.emplace(options.report);
    }
  }

  NearCsv csv;
  AnswerArrays columns;
  std::optional<OutputFile> page;
};

/// `Question` asks the library and says what it answered:
///
///     using Answer = ...;                          // with triangles, point_a, point_b, coverage
///     static constexpr std::string_view kSchema;   // of JSON
///     Answer ask(a, b, parallel); auto ask(mover, poses, fixed, parallel);   // a batch has at(k)
///                                                  // fixed: a Body, or a TiledBody
///     bool found(answer), undecided(answer);       // for --fail-if and the totals
///     std::string title(), cell(answer), text(answer), totals(...);
///     void add(pose, answer);                      // to what `totals` says
///     NearWords words();                           // of the page
///     NearFinding finding(answer, a, b);           // for the page
///     std::optional<std::string> difference(a, b, answer, console);  // from brute force
template <class Question>
class NearRun : public PoseRun {
 public:
  NearRun(const PairOptions& options, PoseQuestion about, Question question, NearFiles& files,
          Console& console)
      : PoseRun(options, std::move(about), console), question_(std::move(question)), files_(files) {
    files_.csv.begin<Answer>(report());
    files_.columns.begin<Answer>();
    files_.columns.state(report().georeference);
    if (files_.page) {
      page_.emplace(
          PageModels{report().a, short_name(options.a), report().b, short_name(options.b)},
          question_.words());
    }
  }

 private:
  using Answer = typename Question::Answer;

  void reserve(std::size_t rows) override { answers_.assign(rows, {}); }

  void ask(std::size_t k, const Body& a, const Body& b, const Parallel& parallel) override {
    answers_[k] = question_.ask(a, b, parallel);
  }

  void ask(std::size_t begin, const Shape& a, std::span<const Pose> poses, const Body& b,
           const Parallel& parallel) override {
    const auto batch = question_.ask(a, poses, b, parallel);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_[begin + k] = batch.at(k);
    }
  }

  void ask_tiles(std::size_t begin, const Shape& a, std::span<const Pose> poses, const TiledBody& b,
                 const Parallel& parallel) override {
    const auto batch = question_.ask(a, poses, b, parallel);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_[begin + k] = batch.at(k);
    }
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const Answer& answer = answers_[k];
    return {.found = question_.found(answer),
            .undecided = question_.undecided(answer),
            .cut = answer.coverage == Coverage::cut};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    return question_.difference(body_a(k), body_b(k), answers_[k], console());
  }

  void print_answer(std::size_t k, bool right) override {
    const Answer& answer = answers_[k];
    const std::uint64_t pose = number();
    const NearPair pair{answer.triangles, answer.point_a, answer.point_b};
    if (console().shared().json) {
      console().print(fmt::format(
          "{{\"schema\":\"{}\",\"pose\":{}{}{}{}}}\n", Question::kSchema, pose, field_keys(answer),
          coverage_keys(answer.coverage, answer.cost), report_keys(report(), pose, right)));
    } else if (report().single) {
      console().print(question_.text(answer) + near_text(report(), pair) + "\n");
    } else if (report().lists_rows) {
      table_.add(report(), pose, question_.title(), question_.cell(answer), pair, console());
    }
    files_.csv.add(pose, answer);
    files_.columns.add(answer);
    question_.add(pose, answer);
    if (page_) {
      page_->add({pose_a(k), pose_b(k)}, question_.finding(answer, body_a(k), body_b(k)));
      answer_ = report().single ? question_.text(answer) : "";
    }
  }

  void print_totals() override {
    if (!report().single) {
      table_.finish(console());
      console().print(question_.totals(totals()) + "\n");
    }
  }

  void finish_outputs() override {
    files_.csv.finish();
    files_.columns.finish();
    if (page_) {
      page_->write(files_.page->stream(), report(), totals(),
                   report().single ? answer_ : question_.totals(totals()));
      files_.page->commit();
    }
  }

  Question question_;
  NearFiles& files_;
  std::optional<NearPage> page_;
  std::string answer_;  ///< of a single pose, in words, for the page
  NearTable table_;
  std::vector<Answer> answers_;
};

/// Answers every pose; the exit status.
template <class Question>
int run_near(const NearOptions& given, PoseQuestion about, Question question, Console& console) {
  NearOptions options = given;
  if (!begin_shard(options, about.terms,
                   {options.csv, options.binary, options.report, about.fail_if_found}, console)) {
    return 0;
  }
  check_files(options,
              {{"--csv", options.csv}, {"--binary", options.binary}, {"--report", options.report}});
  check_extension("--report", options.report, {".html", ".htm"});
  check_extension("--csv", options.csv, {".csv"});
  check_extension("--binary", options.binary, {".npz"});
  about.refused_of_tiles.emplace().push_back(
      {!options.report.empty(), "--report", "a page shows the whole model"});
  about.has_files = !options.csv.empty() || !options.binary.empty() || !options.report.empty();
  NearFiles files(options);
  return NearRun<Question>(options, std::move(about), std::move(question), files, console).run();
}

}  // namespace soms::command
