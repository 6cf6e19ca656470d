#include "apps/soms/pairs/overlap_output.h"

#include "apps/soms/pairs/overlap_csv.h"
#include "apps/world/world.h"

#include <vector>

namespace soms::command {

OverlapOutput::OverlapOutput(const OverlapVerbOptions& options)
    : name_a_(short_name(options.a)), name_b_(short_name(options.b)), columns_(options.binary) {
  if (!options.report.empty()) {
    page_file_.emplace(options.report);
  }
  if (!options.csv.empty()) {
    csv_file_.emplace(options.csv);
  }
}

void OverlapOutput::begin(const OverlapReport& report) {
  report_ = &report;
  if (report.by_part || csv_file_) {
    parts_a_ = PartsOf(report.pair.a);
    parts_b_ = PartsOf(report.pair.b);
  }
  if (page_file_) {
    page_.emplace(report.pair.a, name_a_, report.pair.b, name_b_);
  }
  if (csv_file_) {
    write_csv_head(csv_file_->stream(), report);
  }
  columns_.begin(report.by_part      ? OverlapColumns::List::parts
                 : report.list_pairs ? OverlapColumns::List::triangles
                                     : OverlapColumns::List::none);
}

void OverlapOutput::add(std::uint64_t pose, const Pose& a, const Pose& b,
                        const CountedAnswer& result, bool right, Console& console) {
  const Overlap& answer = result.answer;
  const PosedParts of_a{report_->pair.a, parts_a_, a};
  const PosedParts of_b{report_->pair.b, parts_b_, b};
  // Before any output: this is what may take long and be interrupted.
  const std::vector<PartPair> parts = report_->by_part
                                          ? part_pairs(of_a, of_b, answer.pairs, console.parallel())
                                      : page_ ? page_->parts(a, b, answer, console.parallel())
                                              : std::vector<PartPair>();
  print_answer(*report_, pose, result, right, console, parts);
  if (csv_file_) {
    write_csv_rows(csv_file_->stream(), *report_, pose, of_a, of_b, answer, parts);
    if (!csv_file_->stream().good()) {
      csv_file_->check();
    }
  }
  columns_.add(answer, parts);
  if (page_) {
    page_->add(a, b, answer, parts);
  }
}

void OverlapOutput::finish(const RowTotals& totals) {
  if (page_) {
    page_->write(page_file_->stream(), *report_, totals);
    page_file_->commit();
  }
  if (csv_file_) {
    csv_file_->commit();
  }
  columns_.finish();
}

}  // namespace soms::command
