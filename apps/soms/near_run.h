/// \file
/// A question of how near two models are, queried pose by pose: what `distance` and `within` share.
#pragma once

#include "apps/soms/near_options.h"
#include "apps/soms/near_output.h"
#include "apps/soms/pair_page.h"
#include "apps/soms/pose_run.h"
#include "apps/support/console.h"

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// `Question` asks the library and says what it answered:
///
///     using Answer = ...;                          // with triangles, point_a, point_b, coverage
///     static constexpr std::string_view kSchema, kColumns;   // of JSON; of CSV
///     Answer ask(a, b, parallel); auto ask(mover, poses, fixed, parallel);   // a batch has at(k)
///     bool found(answer), undecided(answer);       // for --fail-if and the totals
///     std::string title(), cell(answer), text(answer), json(answer), csv(answer), totals(...);
///     void open();                                 // files of its own, before the models are read
///     void begin(report);                          // the report stays, as do its meshes
///     void add(pose, poses, answer);               // to what `totals` says, and to its files
///     void finish(report, totals);                 // of its files
///     std::optional<std::string> difference(a, b, answer, console);  // from brute force
template <class Question>
class NearRun : public PoseRun {
 public:
  NearRun(const PairOptions& options, PoseQuestion about, Question question, NearCsv& csv,
          Console& console)
      : PoseRun(options, std::move(about), console), question_(std::move(question)), csv_(csv) {
    csv_.begin(report(), Question::kColumns);
    question_.begin(report());
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
    const std::uint64_t pose = totals().rows;
    const NearPair pair{answer.triangles, answer.point_a, answer.point_b};
    if (console().shared().json) {
      console().print(fmt::format("{{\"schema\":\"{}\",\"pose\":{},{}{}{}{}}}\n", Question::kSchema,
                                  pose, question_.json(answer), near_keys(pair),
                                  coverage_keys(answer.coverage, answer.cost),
                                  report_keys(report(), pose, right)));
    } else if (report().single) {
      console().print(question_.text(answer) + near_text(report(), pair) + "\n");
    } else {
      table_.add(report(), pose, question_.title(), question_.cell(answer), pair, console());
    }
    csv_.add(pose, fmt::format("{},{}", question_.csv(answer), name(answer.coverage)), pair);
    question_.add(pose, {pose_a(k), pose_b(k)}, answer);
  }

  void print_totals() override {
    if (!report().single) {
      table_.finish(console());
      console().print(question_.totals(totals()) + "\n");
    }
  }

  void finish_outputs() override {
    csv_.finish();
    question_.finish(report(), totals());
  }

  Question question_;
  NearCsv& csv_;
  NearTable table_;
  std::vector<Answer> answers_;
};

/// Answers every pose; the exit status.
template <class Question>
int run_near(const NearOptions& options, PoseQuestion about, Question question, Console& console) {
  check_files(options, {{"--csv", options.csv}, {"--report", options.report}});
  check_extension("--report", options.report, {".html", ".htm"});
  check_extension("--csv", options.csv, {".csv"});
  NearCsv csv(options.csv);
  question.open();
  about.has_files = !options.csv.empty() || !options.report.empty();
  return NearRun<Question>(options, std::move(about), std::move(question), csv, console).run();
}

}  // namespace soms::command
