#include "apps/rows/sinks.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"

namespace soms::command {

Sinks::Sinks(const AnswerOutputs& outputs, Console& console)
    : console_(console), has_files_(outputs.any()), json_(outputs, console) {
  if (!outputs.csv.empty()) {
    csv_.emplace(outputs.csv);
  }
  if (!outputs.npz.empty()) {
    arrays_.emplace(outputs.npz);
  }
  if (!outputs.page.empty()) {
    page_.emplace(outputs.page);
  }
}

void Sinks::begin(Question& question) {
  if (csv_) {
    csv_->line() += question.csv_head();
    csv_->end_line();
  }
  if (arrays_) {
    question.begin_columns(*arrays_);
  }
  if (page_) {
    question.begin_page();
  }
}

void Sinks::add(Question& question, const AnsweredRow& row, bool single, bool listed) {
  if (json_.is_wanted()) {
    question.json(row, json_);
  }
  if (!console_.shared().json && single) {
    console_.print(question.sentence(row.k));
  } else if (!console_.shared().json && listed) {
    if (printed_ == 0) {
      console_.print(question.text_head());
    }
    if (printed_++ < question.most_text()) {
      console_.print(question.text(row));
    }
  }
  if (csv_) {
    question.csv(row, *csv_);
  }
  if (page_) {
    question.add_to_page(row);
  }
}

void Sinks::add_columns(Question& question, std::size_t rows) {
  if (arrays_) {
    question.add_columns(rows);
  }
}

void Sinks::print_totals(const Question& question, const RowTotals& totals,
                         const std::string& noun) {
  if (printed_ > question.most_text()) {
    console_.print(question.left_out(counted(printed_ - question.most_text(), noun)));
  }
  console_.print(question.totals(totals));
}

void Sinks::finish(const Question& question, const RowTotals& totals) {
  if (csv_) {
    csv_->finish();
  }
  json_.finish(question.json_totals());
  if (arrays_) {
    arrays_->finish();
  }
  if (page_) {
    question.write_page(page_->stream(), totals);
    page_->commit();
  }
}

}  // namespace soms::command
