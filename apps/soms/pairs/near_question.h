/// \file
/// A question of how near two models are: what `distance` and `within` share.
#pragma once

#include "soms/geometry/parts_of.h"

#include "apps/model/georeference.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/near_page.h"
#include "apps/soms/pairs/pair_page.h"
#include "apps/soms/pairs/pair_question.h"
#include "apps/world/part_names.h"
#include "apps/world/world.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

namespace soms::command {

/// T has `triangles`, `point_a`, `point_b` and `coverage`.
template <Described T, class Ask>
class NearQuestion : public PairQuestion<T, Ask> {
 public:
  NearQuestion(const PoseRows& rows, std::string verb, Ask ask)
      : PairQuestion<T, Ask>(rows, std::move(verb), std::move(ask)),
        georeference_(rows.pair().georeference),
        parts_a_(rows.pair().a),
        parts_b_(rows.pair().b) {}

  [[nodiscard]] std::string sentence(std::size_t k) const override {
    const T answer = this->shown(k);
    return this->painted(in_words(answer) + near_text(this->pair(), pair_of(answer)) + "\n",
                         this->outcome(k));
  }

  [[nodiscard]] std::string text_head() const override { return near_head(title()); }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    const T answer = this->shown(row.k);
    return near_row(this->pair(), row.number, cell(answer), pair_of(answer));
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    return summary(totals) + "\n";
  }

  void begin_columns(NpzFile& file) override {
    PairQuestion<T, Ask>::begin_columns(file);
    add_georeference(file, this->pair().georeference);
  }

  void begin_page() override {
    const PairOptions& options = this->rows().options();
    page_.emplace(PageModels{this->pair().left_a, short_name(options.a), this->pair().left_b,
                             short_name(options.b)},
                  words());
  }

  void add_to_page(const AnsweredRow& row) override {
    const PoseRows& rows = this->rows();
    page_->add({rows.pose_a(row.k), rows.pose_b(row.k)},
               finding(this->at(row.k), rows.body_a(row.k), rows.body_b(row.k)));
    only_ = this->pair().single ? in_words(this->shown(row.k)) : "";
  }

  void write_page(std::ostream& out, const RowTotals& totals) const override {
    page_->write(out, this->pair(), totals, this->pair().single ? only_ : summary(totals));
  }

 protected:
  /// The answer as a cell of the table under `title()`, and as a sentence.
  [[nodiscard]] virtual std::string title() const = 0;
  [[nodiscard]] virtual std::string cell(const T& answer) const = 0;
  [[nodiscard]] virtual std::string in_words(const T& answer) const = 0;
  [[nodiscard]] virtual std::string summary(const RowTotals& totals) const = 0;
  /// For the page.
  [[nodiscard]] virtual NearWords words() const = 0;
  [[nodiscard]] virtual NearFinding finding(const T& answer, const Body& a,
                                            const Body& b) const = 0;

 private:
  [[nodiscard]] static NearPair pair_of(const T& answer) {
    return {answer.triangles, answer.point_a, answer.point_b};
  }

  [[nodiscard]] std::string more_head() const override { return std::string(georeference_.head()); }

  [[nodiscard]] std::string more_cells(std::size_t /*k*/) const override {
    return std::string(georeference_.field());
  }

  [[nodiscard]] std::string triangle_cells(int side,
                                           std::optional<TriangleId> triangle) const override {
    return side == 0 ? triangle_csv_fields(this->pair().a, parts_a_, triangle)
                     : triangle_csv_fields(this->pair().b, parts_b_, triangle);
  }

  GeoreferenceColumn georeference_;
  PartsOf parts_a_;
  PartsOf parts_b_;
  std::optional<NearPage> page_;
  std::string only_;  ///< the answer of a single pose, for the page
};

}  // namespace soms::command
