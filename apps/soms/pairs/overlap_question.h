/// \file
/// Which triangles or parts of two models overlap, pose by pose.
#pragma once

#include "soms/geometry/parts_of.h"

#include "apps/soms/answers/array_columns.h"
#include "apps/soms/pairs/overlap.h"
#include "apps/soms/pairs/overlap_page.h"
#include "apps/soms/pairs/overlap_parts.h"
#include "apps/soms/pairs/overlap_report.h"
#include "apps/soms/pairs/pose_rows.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

class OverlapQuestion : public Question, private PoseAnswers {
 public:
  OverlapQuestion(const PoseRows& rows, const OverlapVerbOptions& options, const Console& console);

  std::uint64_t answer(const ShowProgress& show) override;
  [[nodiscard]] RowOutcome outcome(std::size_t k) const override;
  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override;
  void count(const AnsweredRow& row) override;
  void json(const AnsweredRow& row, JsonRows& rows) const override;
  [[nodiscard]] std::string sentence(std::size_t k) const override;
  [[nodiscard]] std::string text(const AnsweredRow& row) const override;
  [[nodiscard]] std::uint64_t most_text() const override;
  [[nodiscard]] std::string totals(const RowTotals& totals) const override;
  [[nodiscard]] std::string csv_head() const override;
  void csv(const AnsweredRow& row, CsvFile& file) const override;
  void begin_columns(NpzFile& file) override;
  void add_columns(std::size_t rows) override;
  void begin_page() override;
  void add_to_page(const AnsweredRow& row) override;
  void write_page(std::ostream& out, const RowTotals& totals) const override;

 private:
  /// An answer with the numbers that triangles have in their files. It is `named` where triangles
  /// were left out, else that of the library, which is not copied.
  struct Shown {
    struct Named {
      CountedAnswer answer;
      std::vector<PartPair> parts;
    };

    const CountedAnswer& answer;
    const std::vector<PartPair>& parts;
    std::optional<Named> named = std::nullopt;

    [[nodiscard]] const CountedAnswer& counted() const { return named ? named->answer : answer; }

    [[nodiscard]] const std::vector<PartPair>& listed() const {
      return named ? named->parts : parts;
    }
  };

  void answer_one(std::size_t k, const Body& a, const Body& b, const Limits& limits) override;
  void answer_some(std::size_t begin, const Shape& a, std::span<const Pose> poses,
                   const StillBody& b, const Limits& limits) override;
  [[nodiscard]] std::string text_of_row(std::size_t k, std::uint64_t pose) const;
  void add_lists(std::size_t k);
  [[nodiscard]] Shown shown(std::size_t k) const;
  [[nodiscard]] std::pair<const FileNumbers&, const FileNumbers&> numbers() const;

  const PoseRows& rows_;
  const OverlapVerbOptions& options_;
  OverlapOptions query_;
  const Console& console_;
  OverlapReport report_;
  PartsOf parts_of_a_;
  PartsOf parts_of_b_;
  std::vector<CountedAnswer> answers_;
  std::vector<std::vector<PartPair>> parts_;  ///< of the answers, where they are wanted
  std::optional<OverlapPage> page_;
  OffsetColumn offsets_;
  NpzColumn* any_ = nullptr;
  NpzColumn* pairs_ = nullptr;
  NpzColumn* count_ = nullptr;
  NpzColumn* first_ = nullptr;
  NpzColumn* coverage_ = nullptr;
};

}  // namespace soms::command
