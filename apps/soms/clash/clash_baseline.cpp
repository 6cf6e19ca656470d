#include "apps/soms/clash/clash_baseline.h"

#include "soms/base/error.h"

#include "apps/rows/json_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kOption = "--baseline";

void check_schema(const ListedObject& object) {
  if (object.text("schema") != "soms.clash/1") {
    object.fail("no row of a clash list");
  }
}

void check_side(const ListedObject& row, std::string_view which) {
  const std::optional<ListedObject> side = row.object(which);
  if (!side || !side->text("file")) {
    row.fail(fmt::format("{} is no part of a file", which));
  }
  for (const char* const member : {"set", "part", "id", "type"}) {
    static_cast<void>(side->text(member));
  }
  static_cast<void>(side->count("index"));
  side->check_texts("path");
}

/// All members that comparison, pages, archives and CSV files use.
void check_row(const ListedObject& row) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  const std::optional<std::string> key = row.text("key");
  if (!key || key->size() != 16 || !std::all_of(key->begin(), key->end(), is_digit)) {
    row.fail("key is not 16 hexadecimal digits");
  }
  if (!row.word("class", {"crossing", "inside", "same", "touching", "near", "undecided"})) {
    row.fail("class is missing");
  }
  static_cast<void>(row.word("status", {"new", "active", kResolved}));
  for (const char* const member : {"relation", "why", "group"}) {
    static_cast<void>(row.text(member));
  }
  static_cast<void>(row.count("triangle_pairs"));
  row.check_number("depth");
  row.check_numbers("gap", 2);
  row.check_numbers("place", 3);
  row.check_numbers("direction", 3);
  row.check_box("box");
  row.check_texts("open");
  check_side(row, "a");
  check_side(row, "b");
}

/// Throws where the list lacks rows that this one may have: they would be new, and are not.
void check_filters(const ListedObject& end, const std::vector<std::string>& filters) {
  const std::optional<ListedObject> removed = end.object("removed");
  if (!removed) {
    return;
  }
  for (const auto& [filter, unused] : removed->value().items()) {
    const bool lacks_rows = removed->count(filter).value_or(0) != 0;
    if (lacks_rows && filter == "status") {
      throw Error(ErrorKind::usage,
                  fmt::format("{}: the list was filtered by --status, so it lacks clashes",
                              removed->place()),
                  "give a list that was written without --status");
    }
    if (lacks_rows && std::find(filters.begin(), filters.end(), filter) == filters.end()) {
      const bool is_kind = !filter.starts_with("ignore-") && filter != "tolerance";
      throw Error(ErrorKind::usage,
                  fmt::format("{}: the list lacks clashes, by {}", removed->place(), filter),
                  fmt::format("also give {}{}, or a list that was written without it",
                              is_kind ? "--ignore-class " : "--", filter));
    }
  }
}

void check_end(const ListedObject& end, std::uint64_t rows,
               const std::vector<std::string>& filters) {
  const std::optional<std::string> coverage = end.word("coverage", {"complete", "cut"});
  if (!coverage) {
    end.fail("coverage is missing");
  }
  if (*coverage != "complete") {
    end.fail(
        "the list was cut by time or Ctrl-C, so what it lacks need not be new; run it to its "
        "end, if need be with --journal");
  }
  const std::optional<std::uint64_t> pairs = end.count("pairs");
  if (!pairs) {
    end.fail("neither a row, as it has no key, nor the end of a list, as it has no pairs");
  }
  if (*pairs != rows) {
    end.fail(fmt::format("the list has {} rows, and its end counts {}", rows, *pairs));
  }
  check_filters(end, filters);
}

}  // namespace

ClashBaseline::ClashBaseline(const std::string& file, const std::vector<std::string>& filters) {
  bool ended = false;
  std::uint64_t rows = 0;
  for (const ListedObject& object : read_json_list(kOption, file)) {
    check_schema(object);
    if (ended) {
      object.fail("something follows the end of the list");
    }
    ended = !object.has("key");
    if (ended) {
      check_end(object, std::exchange(rows, 0), filters);
    } else {
      rows += add(object) ? 1U : 0U;
    }
  }
  if (!ended) {
    throw Error(ErrorKind::bad_file, fmt::format("{} {}: the list has no end", kOption, file),
                "give a whole list, with its end, which counts the clashes");
  }
}

bool ClashBaseline::add(const ListedObject& row) {
  check_row(row);
  if (row.text("status") == kResolved) {
    return false;
  }
  rows_.emplace(*row.text("key"), row.value());
  return true;
}

void ClashBaseline::compare(const std::set<std::uint64_t>& found,
                            const std::function<bool(const Json&)>& looked_at,
                            ClashReport& report) const {
  report.has_baseline = true;
  for (ClashRow& row : report.rows) {
    row.status = rows_.contains(key_text(row.key)) ? ClashStatus::active : ClashStatus::fresh;
  }
  if (!report.complete()) {
    return;
  }
  std::set<std::string> keys;
  for (const std::uint64_t key : found) {
    keys.insert(key_text(key));
  }
  for (const auto& [key, row] : rows_) {
    if (!keys.contains(key) && looked_at(row)) {
      report.resolved.push_back(row);
    }
  }
}

}  // namespace soms::command
