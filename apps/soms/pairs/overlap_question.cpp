#include "apps/soms/pairs/overlap_question.h"

#include "soms/base/text.h"
#include "soms/query/reference/overlap.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/rows/csv_file.h"
#include "apps/soms/pairs/overlap_verify.h"
#include "apps/world/part_names.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

namespace soms::command {

namespace {

std::string cells_of(const Vec3& v) {
  return fmt::format("{},{},{}", v.x, v.y, v.z);
}

std::string cells_of(const PairReport& report, const PartPair& pair) {
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{}", part_csv_fields(report.a, pair.a),
      csv_field(part_path_label(report.a, pair.a)), part_csv_fields(report.b, pair.b),
      csv_field(part_path_label(report.b, pair.b)), pair.count, pair.first.a, pair.first.b,
      cells_of(pair.box.center()), cells_of(pair.box.lower), cells_of(pair.box.upper));
}

}  // namespace

OverlapQuestion::OverlapQuestion(const PoseRows& rows, const OverlapVerbOptions& options,
                                 const Console& console)
    : rows_(rows),
      options_(options),
      query_(options.query),
      console_(console),
      report_{.pair = rows.pair(),
              .mode = query_.mode,
              .list_pairs = options.list_pairs,
              .by_part = options.by_part} {
  if (options.by_part || !options.outputs.csv.empty()) {
    parts_of_a_ = PartsOf(rows_.shape_a().mesh());
    parts_of_b_ = PartsOf(rows_.shape_b().mesh());
  }
}

std::uint64_t OverlapQuestion::answer(const ShowProgress& show) {
  answers_.assign(rows_.size(), {});
  parts_.assign(rows_.size(), {});
  rows_.answer(*this, show);
  std::uint64_t pairs = 0;
  for (const CountedAnswer& counted : answers_) {
    pairs += counted.answer.pairs.size();
  }
  return pairs;
}

void OverlapQuestion::answer_one(std::size_t k, const Body& a, const Body& b,
                                 const Limits& limits) {
  if (options_.traversal->named()) {
    answers_[k] = options_.traversal->overlap(a, b, query_, limits);
  } else {
    answers_[k].answer = soms::overlap(a, b, query_, limits);
  }
}

void OverlapQuestion::answer_some(std::size_t begin, const Shape& a, std::span<const Pose> poses,
                                  const StillBody& b, const Limits& limits) {
  if (options_.traversal->named()) {
    auto answers = options_.traversal->overlap(a, poses, std::get<Body>(b), query_, limits);
    std::move(answers.begin(), answers.end(),
              answers_.begin() + static_cast<std::ptrdiff_t>(begin));
    return;
  }
  const OverlapBatch batch = std::visit(
      [&](const auto& still) { return soms::overlap(a, poses, still, query_, limits); }, b);
  for (std::size_t k = 0; k < batch.size(); ++k) {
    answers_[begin + k].answer = batch.at(k);
  }
}

RowOutcome OverlapQuestion::outcome(std::size_t k) const {
  const Overlap& answer = answers_[k].answer;
  return {.found = answer.any,
          .undecided = is_undecided(answer),
          .cut = answer.coverage == Coverage::cut && answer.pairs.size() < query_.limit};
}

std::optional<std::string> OverlapQuestion::difference(std::size_t k) {
  const Overlap truth = console_.run("verifying", [&](const Limits& limits) {
    return reference::overlap(rows_.shape_a().mesh(), rows_.pose_a(k), rows_.shape_b().mesh(),
                              rows_.pose_b(k), limits);
  });
  const Overlap& answer = answers_[k].answer;
  if (agrees(answer, truth, query_.mode)) {
    return std::nullopt;
  }
  return fmt::format("brute force finds {}, but the answer has {}",
                     counted(truth.pairs.size(), "pair"), answer.pairs.size());
}

/// Finds the parts, before any output: this may take long and be interrupted.
void OverlapQuestion::count(const AnsweredRow& row) {
  const Overlap& answer = answers_[row.k].answer;
  const Pose& a = rows_.pose_a(row.k);
  const Pose& b = rows_.pose_b(row.k);
  if (report_.by_part) {
    parts_[row.k] =
        part_pairs({rows_.shape_a().mesh(), parts_of_a_, a},
                   {rows_.shape_b().mesh(), parts_of_b_, b}, answer.pairs, console_.limits());
  } else if (page_) {
    parts_[row.k] = page_->parts(a, b, answer, console_.limits());
  }
}

void OverlapQuestion::json(const AnsweredRow& row, JsonRows& rows) const {
  const Shown answer = shown(row.k);
  write_json(report_, row, answer.counted(), rows, answer.listed());
}

std::string OverlapQuestion::text_of_row(std::size_t k, std::uint64_t pose) const {
  const Shown answer = shown(k);
  return text_of(report_, pose, answer.counted(), answer.listed(), console_.terminal());
}

OverlapQuestion::Shown OverlapQuestion::shown(std::size_t k) const {
  const auto& [a, b] = numbers();
  Shown row{answers_[k], parts_[k]};
  if (!a.are_the_same() || !b.are_the_same()) {
    row.named.emplace(Shown::Named{answers_[k], parts_[k]});
    Overlap& answer = row.named->answer.answer;
    answer = in_files(a, b, std::move(answer));
    for (PartPair& pair : row.named->parts) {
      pair.first = in_files(a, b, pair.first);
    }
  }
  return row;
}

std::pair<const FileNumbers&, const FileNumbers&> OverlapQuestion::numbers() const {
  return {report_.pair.left_a.numbers, report_.pair.left_b.numbers};
}

std::string OverlapQuestion::sentence(std::size_t k) const {
  return text_of_row(k, 0);
}

std::string OverlapQuestion::text(const AnsweredRow& row) const {
  return text_of_row(row.k, row.number);
}

std::uint64_t OverlapQuestion::most_text() const {
  return std::numeric_limits<std::uint64_t>::max();
}

std::string OverlapQuestion::totals(const RowTotals& totals) const {
  return text_of(totals);
}

std::string OverlapQuestion::csv_head() const {
  return report_.by_part ? fmt::format(
                               "pose,part_a,name_a,path_a,part_b,name_b,path_b,count,"
                               "triangle_a,triangle_b,x,y,z,x_min,y_min,z_min,x_max,y_max,"
                               "z_max{}",
                               GeoreferenceColumn(report_.pair.georeference).head())
                         : "pose,triangle_a,part_a,name_a,triangle_b,part_b,name_b";
}

void OverlapQuestion::csv(const AnsweredRow& row, CsvFile& file) const {
  if (report_.by_part) {
    const GeoreferenceColumn georeference(report_.pair.georeference);
    const Shown answer = shown(row.k);
    for (const PartPair& pair : answer.listed()) {
      file.line() +=
          fmt::format("{},{}{}", row.number, cells_of(report_.pair, pair), georeference.field());
      file.end_line();
    }
    return;
  }
  for (const auto& [i, j] : answers_[row.k].answer.pairs) {
    file.line() += fmt::format("{},{},{},{},{}", row.number, numbers().first(i),
                               part_csv_fields(report_.pair.a, parts_of_a_(i)), numbers().second(j),
                               part_csv_fields(report_.pair.b, parts_of_b_(j)));
    file.end_line();
  }
}

void OverlapQuestion::begin_columns(NpzFile& file) {
  using Column = NpzColumn::Kind;
  any_ = &file.column("any", Column::flag);
  if (!report_.by_part && !report_.list_pairs) {
    count_ = &file.column("count", Column::count);
  } else {
    offsets_.begin(file, "offsets");
    pairs_ = &file.column(report_.by_part ? "parts" : "pairs", Column::count, {2});
  }
  if (report_.by_part) {
    count_ = &file.column("count", Column::count);
    first_ = &file.column("first", Column::count, {2});
  }
  coverage_ = &file.names("coverage", kWords<Coverage>.names);
}

void OverlapQuestion::add_columns(std::size_t rows) {
  for (std::size_t k = 0; k < rows; ++k) {
    const Overlap& answer = answers_[k].answer;
    any_->add(answer.any);
    add_code(*coverage_, answer.coverage);
    if (pairs_ == nullptr) {
      count_->add(static_cast<std::int64_t>(answer.pairs.size()));
    } else {
      add_lists(k);
    }
  }
}

void OverlapQuestion::add_lists(std::size_t k) {
  if (!report_.by_part) {
    for (const auto& [i, j] : answers_[k].answer.pairs) {
      pairs_->add(std::int64_t{numbers().first(i)});
      pairs_->add(std::int64_t{numbers().second(j)});
    }
    offsets_.add(answers_[k].answer.pairs.size());
    return;
  }
  const Shown answer = shown(k);
  for (const PartPair& pair : answer.listed()) {
    pairs_->add(number_of_part(pair.a));
    pairs_->add(number_of_part(pair.b));
    count_->add(static_cast<std::int64_t>(pair.count));
    first_->add(std::int64_t{pair.first.a});
    first_->add(std::int64_t{pair.first.b});
  }
  offsets_.add(parts_[k].size());
}

void OverlapQuestion::begin_page() {
  page_.emplace(PageModels{report_.pair.left_a, short_name(options_.a), report_.pair.left_b,
                           short_name(options_.b)});
}

void OverlapQuestion::add_to_page(const AnsweredRow& row) {
  page_->add(rows_.pose_a(row.k), rows_.pose_b(row.k), answers_[row.k].answer, parts_[row.k]);
}

void OverlapQuestion::write_page(std::ostream& out, const RowTotals& totals) const {
  page_->write(out, report_, totals);
}

}  // namespace soms::command
