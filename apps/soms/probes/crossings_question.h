/// \file
/// `ray --all`: every place where rays or segments meet a model.
#pragma once

#include "apps/soms/answers/array_columns.h"
#include "apps/soms/probes/ray_question.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

[[nodiscard]] std::optional<std::string> difference_of(const Crossings& answer,
                                                       const Crossings& truth);

/// Every place where each ray meets the model.
template <class Source>
class CrossingsQuestion : public Question {
 public:
  CrossingsQuestion(const RayVerbOptions& options, const ProbeRows<Source>& rows, const Pose& pose,
                    const Console& console)
      : model_(options, rows, pose, console) {}

  std::uint64_t answer(const ShowProgress&) override {
    hits_ =
        all_hits(model_.model().body(), model_.rays(), model_.query(), model_.console().limits());
    return hits_.triangle.size();
  }

  [[nodiscard]] RowOutcome outcome(std::size_t k) const override {
    const bool found = hits_.offsets[k] != hits_.offsets[k + 1];
    const bool cut = hits_.coverage[k] == Coverage::cut;
    return {.found = found, .undecided = cut && !found, .cut = cut};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    return difference_of(
        crossings_of(hits_, k), model_.console().run("verifying", [&](const Limits&) {
          return crossings_of(reference::all_hits_by_brute_force(
                                  model_.model().body(), model_.rays()[k], model_.query().skip),
                              0);
        }));
  }

  void count(const AnsweredRow& row) override {
    const Crossings answer = crossings_of(hits_, row.k);
    crossings_ += answer.places.size();
    triangles_ += answer.count();
  }

  void json(const AnsweredRow& row, JsonRows& rows) const override {
    const Crossings answer = shown(row.k);
    const RowOutcome known = outcome(row.k);
    rows.put(
        json_row("ray", "ray", row,
                 fmt::format(",\"hit\":{}{}{}{}",
                             known.undecided ? "null"
                             : known.found   ? "true"
                                             : "false",
                             crossings_keys(answer), coverage_keys(answer.coverage, answer.cost),
                             model_.report().keys(row))));
    rows.end_row();
  }

  [[nodiscard]] std::string text_head() const override { return crossings_head(Source::kNoun); }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    return text_of(row.number, shown(row.k), digits());
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    return fmt::format("{}; {}, {}\n", model_.totals(totals), counted(crossings_, "crossing"),
                       counted(triangles_, "triangle"));
  }

  [[nodiscard]] std::string csv_head() const override {
    return "ray,crossing,lower,upper,kind,triangle,part,name,coverage";
  }

  void csv(const AnsweredRow& row, CsvFile& file) const override {
    const Crossings answer = shown(row.k);
    for (std::size_t i = 0; i < answer.places.size(); ++i) {
      const Crossing& place = answer.places[i];
      for (const TriangleId triangle : place.triangles) {
        file.line() +=
            fmt::format("{},{},{},{},{},{},{}", row.number, i, place.t.lower, place.t.upper,
                        name(place.kind), model_.cells(triangle), name(answer.coverage));
        file.end_line();
      }
    }
  }

  void begin_columns(NpzFile& file) override {
    using Column = NpzColumn::Kind;
    offsets_.begin(file, "offsets");
    lower_ = &file.column("lower", Column::number);
    upper_ = &file.column("upper", Column::number);
    kind_ = &file.names("kind", kWords<CrossingKind>.names);
    triangle_offsets_.begin(file, "triangle_offsets");
    triangle_ = &file.column("triangle", Column::count);
    coverage_ = &file.names("coverage", kWords<Coverage>.names);
    add_georeference(file, model_.report().georeference());
  }

  void add_columns(std::size_t rows) override {
    for (std::size_t k = 0; k < rows; ++k) {
      offsets_.add(hits_.offsets[k + 1] - hits_.offsets[k]);
      add_code(*coverage_, hits_.coverage[k]);
    }
    const std::size_t places = hits_.offsets[rows];
    for (std::size_t i = 0; i < places; ++i) {
      lower_->add(hits_.lower[i]);
      upper_->add(hits_.upper[i]);
      add_code(*kind_, hits_.kind[i]);
      triangle_offsets_.add(hits_.triangle_offsets[i + 1] - hits_.triangle_offsets[i]);
    }
    for (std::size_t t = 0; t < hits_.triangle_offsets[places]; ++t) {
      triangle_->add(std::int64_t{model_.model().numbers()(hits_.triangle[t])});
    }
  }

 private:
  /// With the numbers of the file.
  [[nodiscard]] Crossings shown(std::size_t k) const {
    Crossings answer = crossings_of(hits_, k);
    for (Crossing& place : answer.places) {
      std::transform(place.triangles.begin(), place.triangles.end(), place.triangles.begin(),
                     model_.model().numbers());
    }
    return answer;
  }

  RayModel<Source> model_;
  AllHits hits_;
  std::uint64_t crossings_ = 0;
  std::uint64_t triangles_ = 0;  // that are hit, in all crossings
  OffsetColumn offsets_;
  NpzColumn* lower_ = nullptr;
  NpzColumn* upper_ = nullptr;
  NpzColumn* kind_ = nullptr;
  OffsetColumn triangle_offsets_;
  NpzColumn* triangle_ = nullptr;
  NpzColumn* coverage_ = nullptr;
};

}  // namespace soms::command
