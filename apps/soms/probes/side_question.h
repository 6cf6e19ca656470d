/// \file
/// A question whose answer is a side for each point.
#pragma once

#include "soms/base/bracket.h"
#include "soms/query/contains.h"

#include "apps/cli/text.h"
#include "apps/rows/point_source.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/probes/probe_rows.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace soms::command {

/// What the questions of `contains` about the model as a whole share. T has `side`.
template <Described T>
class SideQuestion : public BatchQuestion<T> {
 public:
  explicit SideQuestion(const ProbeRows<PointSource>& rows)
      : BatchQuestion<T>("contains", "row"), rows_(rows) {}

  void count(const AnsweredRow& row) override {
    ++counts_[static_cast<std::size_t>(this->at(row.k).side)];
  }

  [[nodiscard]] std::string text_head() const override {
    return fmt::format("{:>6}  {:<9}  {}at\n", "point", "side", column_head());
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    const T answer = this->at(row.k);
    return fmt::format("{:>6}  {:<9}  {}{}\n", row.number, name(answer.side), column(answer),
                       point_in_text(point(row.k)));
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    const auto count = [&](Side side) {
      return with_commas(counts_[static_cast<std::size_t>(side)]);
    };
    std::string line =
        fmt::format("{}: {} inside, {} outside, {} on the surface", counted(totals.rows, "point"),
                    count(Side::inside), count(Side::outside), count(Side::on));
    if (totals.undecided != 0) {
      line += fmt::format(", {} undecided", count(Side::undecided));
    }
    return line + "\n";
  }

 protected:
  [[nodiscard]] const Vec3& point(std::size_t k) const { return rows_.block()[k]; }

  [[nodiscard]] const std::vector<Vec3>& points() const { return rows_.block(); }

 private:
  /// What stands between side and point in the table for people, and above it.
  [[nodiscard]] virtual std::string column(const T& /*answer*/) const { return ""; }

  [[nodiscard]] virtual std::string column_head() const { return ""; }

  [[nodiscard]] bool found(const T& answer) const override { return answer.side == Side::inside; }

  [[nodiscard]] bool undecided(const T& answer) const override {
    return answer.side == Side::undecided;
  }

  const ProbeRows<PointSource>& rows_;
  std::array<std::uint64_t, 4> counts_ = {};  // of each side
};

}  // namespace soms::command
