// What of the thesis is shown and what is not, where each option comes from, and what of the text
// contradicts itself or is not judged.
#include "thesis/claims/coverage.h"

#include "thesis/claims/sources.h"
#include "thesis/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::reproduce {

namespace {

std::string_view state_name(CoverageState state) {
  switch (state) {
    case CoverageState::shown:
      return "yes";
    case CoverageState::elsewhere:
      return "elsewhere";
    case CoverageState::not_shown:
      break;
  }
  return "no";
}

std::int64_t count_entries(std::span<const Coverage> entries, ThesisItemKind kind,
                           CoverageState state) {
  return std::count_if(entries.begin(), entries.end(), [&](const Coverage& entry) {
    return entry.item->kind == kind && entry.state == state;
  });
}

/// "14 of 16 tables have an item of their own, 0 are shown by another item, 2 are not shown."
std::string coverage_sentence(std::span<const Coverage> entries, ThesisItemKind kind,
                              std::size_t all) {
  return fmt::format(
      "{} of {} {} have an item of their own, {} are shown by another item, {} are not shown.",
      count_entries(entries, kind, CoverageState::shown), all,
      kind == ThesisItemKind::table ? "tables" : "figures",
      count_entries(entries, kind, CoverageState::elsewhere),
      count_entries(entries, kind, CoverageState::not_shown));
}

std::int64_t count_options(std::span<const SourcedOption> options, Basis basis) {
  return std::count_if(options.begin(), options.end(),
                       [&](const SourcedOption& option) { return option.basis == basis; });
}

Table options_table(std::span<const SourcedOption> options) {
  Table table{.id = "sources_options",
              .caption =
                  "Options of the runs, the value that the thesis' items use, and what "
                  "supports it: stated (abstract, chapter 1), caption (or heading), ours.",
              .columns = {{"group"}, {"option"}, {"value"}, {"basis"}, {"where"}}};
  for (const SourcedOption& option : options) {
    table.rows.push_back({std::string(option.group), std::string(option.option), option.value,
                          std::string(name(option.basis)), std::string(option.where)});
  }
  return table;
}

Table contradictions_table() {
  Table table{.id = "sources_contradictions",
              .caption =
                  "Places of the thesis that do not go together with one another or with what is "
                  "known, and what this run does.",
              .columns = {{"subject"}, {"one_place"}, {"other_place"}, {"this_run"}}};
  for (const Contradiction& one : contradictions()) {
    table.rows.push_back({std::string(one.subject), std::string(one.one), std::string(one.other),
                          std::string(one.outcome)});
  }
  return table;
}

Table unjudged_table() {
  Table table{.id = "sources_unjudged",
              .caption =
                  "Statements of the abstract and of chapter 1 that have no matrix, why, and "
                  "the item that shows what can be shown of them.",
              .columns = {{"words"}, {"where"}, {"why_not_judged"}, {"item"}}};
  for (const UnjudgedStatement& one : unjudged_statements()) {
    table.rows.push_back({std::string(one.words), std::string(one.where), std::string(one.why),
                          one.item.empty() ? Cell{} : Cell{std::string(one.item)}});
  }
  return table;
}

Table restatements_table() {
  Table table{.id = "sources_restatements",
              .caption =
                  "Later texts of the author on the same subject, as far as they were available to "
                  "us: what they say, and what that settles.",
              .columns = {{"text"}, {"says"}, {"settles"}}};
  for (const Restatement& one : restatements()) {
    table.rows.push_back({std::string(one.text), std::string(one.says), std::string(one.settles)});
  }
  return table;
}

}  // namespace

Result coverage(const Context&) {
  const std::vector<Coverage> entries = coverage(thesis_items(), experiments());
  Table table{.id = "coverage",
              .caption =
                  "Every table and figure of the thesis: the item that shows it, or why "
                  "none does.",
              .columns = {{"kind"}, {"number"}, {"subject"}, {"shown"}, {"item"}, {"why_not"}}};
  for (const Coverage& entry : entries) {
    const ThesisItem& item = *entry.item;
    table.rows.push_back(
        {std::string(item.kind == ThesisItemKind::table ? "table" : "figure"),
         std::string(item.number), std::string(item.subject), std::string(state_name(entry.state)),
         entry.experiment == nullptr ? Cell{} : Cell{std::string(entry.experiment->item)},
         item.why_not.empty() ? Cell{} : Cell{std::string(item.why_not)}});
  }
  return {.tables = {std::move(table)},
          .remarks = {coverage_sentence(entries, ThesisItemKind::table, kThesisTables),
                      coverage_sentence(entries, ThesisItemKind::figure, kThesisFigures),
                      "Shown means: the same subject on our models by our code. Where only a "
                      "caption was available to us, the drawing is ours."}};
}

Result sources(const Context&) {
  const std::vector<SourcedOption> options = sourced_options();
  return {
      .tables = {options_table(options), contradictions_table(), unjudged_table(),
                 restatements_table()},
      .remarks = {fmt::format(
          "Of {} options {} are stated, {} follow from a caption or heading, {} are ours. The item "
          "options shows what they change.",
          options.size(), count_options(options, Basis::stated),
          count_options(options, Basis::caption), count_options(options, Basis::ours))}};
}

}  // namespace soms::reproduce
