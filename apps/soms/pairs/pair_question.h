/// \file
/// A question about two models whose answers are columns, and how it is put to every pose.
#pragma once

#include "apps/cli/console.h"
#include "apps/rows/row_run.h"
#include "apps/rows/sinks.h"
#include "apps/shards/shard_files.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/pairs/pose_rows.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace soms::command {

/// `ask(limits, a, b)` answers two bodies, and `ask(limits, shape, poses, b)` gives a batch: b
/// is a body, or tiles where that has a meaning.
template <Described T, class Ask>
class PairQuestion : public BatchQuestion<T>, private PoseAnswers {
 public:
  PairQuestion(const PoseRows& rows, std::string verb, Ask ask)
      : BatchQuestion<T>(std::move(verb), "pose"), rows_(rows), ask_(std::move(ask)) {}

  std::uint64_t answer(const ShowProgress& show) override {
    this->reserve(rows_.size());
    rows_.answer(*this, show);
    return 0;
  }

 protected:
  [[nodiscard]] const PoseRows& rows() const { return rows_; }

  [[nodiscard]] const PairReport& pair() const { return rows_.pair(); }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return report_keys(pair(), row.number, row.right);
  }

  [[nodiscard]] const FileNumbers& numbers(int side) const override {
    return (side == 0 ? pair().left_a : pair().left_b).numbers;
  }

 private:
  void answer_one(std::size_t k, const Body& a, const Body& b, const Limits& limits) final {
    this->put(k, ask_(limits, a, b));
  }

  void answer_some(std::size_t begin, const Shape& a, std::span<const Pose> poses,
                   const StillBody& b, const Limits& limits) final {
    std::visit(
        [&](const auto& still) {
          if constexpr (std::is_invocable_v<const Ask&, const Limits&, const Shape&,
                                            std::span<const Pose>, decltype(still)>) {
            this->put(begin, ask_(limits, a, poses, still));
          }
        },
        b);
  }

  const PoseRows& rows_;
  Ask ask_;
};

/// Puts the question that `make(rows)` gives to every pose; the exit status.
template <class Make>
int run_pairs(const PairOptions& given, PoseTerms terms, Console& console, const Make& make) {
  PairOptions options = given;
  if (!begin_shard(options, terms.terms, terms.fail_if_found, console)) {
    return 0;
  }
  check_files(options);
  Sinks sinks(options.outputs, console);
  PoseRows rows(options, std::move(terms), console);
  auto question = make(rows);
  return RowRun(rows.run_options(), rows, question, sinks, console).run();
}

}  // namespace soms::command
