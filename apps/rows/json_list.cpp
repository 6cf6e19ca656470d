#include "apps/rows/json_list.h"

#include "soms/base/error.h"
#include "soms/io/encoding.h"

#include "apps/cli/parse.h"
#include "apps/output/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kRows = "rows";
/// Deeper lists are not ours, and would take a stack frame a level when they are written again.
constexpr int kDeepestList = 64;
constexpr const char* kRepairList =
    "give a list as soms wrote it: -o FILE.json, -o FILE.jsonl or --json";

bool is_numbers(const Json& value, std::size_t count) {
  return value.is_array() && value.size() == count &&
         std::all_of(value.begin(), value.end(),
                     [](const Json& one) { return one.is_number() || one.is_null(); });
}

std::string whole_file(const std::string& option, const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad() || std::filesystem::is_directory(file)) {
    throw Error(ErrorKind::cannot_open, option + " " + file + ": cannot be read",
                "give a file that exists and can be read");
  }
  refuse_utf16(text, option + " " + file);
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) {
    text.erase(0, kByteOrderMark.size());
  }
  return text;
}

[[noreturn]] void refuse(const std::string& place, const ParsedJson& parsed) {
  const std::string what = parsed.too_deep
                               ? fmt::format("nested more than {} levels deep", kDeepestList)
                               : "this is not valid JSON";
  throw Error(ErrorKind::bad_file, place + ": " + what, kRepairList);
}

std::size_t line_at(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

std::vector<ListedObject> objects_of_lines(std::string_view text, const std::string& name) {
  std::vector<ListedObject> objects;
  std::size_t number = 1;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    if (is_blank(line)) {
      continue;
    }
    std::string place = fmt::format("{}, line {}", name, number);
    ParsedJson parsed = parse_json(line, kDeepestList);
    if (parsed.fault != 0) {
      refuse(place, parsed);
    }
    if (!parsed.value.is_object()) {
      throw Error(ErrorKind::bad_file, place + ": expected an object", kRepairList);
    }
    objects.emplace_back(std::move(parsed.value), std::move(place));
  }
  return objects;
}

std::vector<ListedObject> objects_of_document(Json document, const std::string& name) {
  std::vector<ListedObject> objects;
  Json rows = std::move(document[kRows]);
  document.erase(kRows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::string place = fmt::format("{}, {}[{}]", name, kRows, k);
    if (!rows[k].is_object()) {
      throw Error(ErrorKind::bad_file, place + ": expected an object", kRepairList);
    }
    objects.emplace_back(std::move(rows[k]), std::move(place));
  }
  objects.emplace_back(std::move(document), name);
  return objects;
}

bool is_document(const Json& value) {
  return value.is_object() && value.contains(kRows) && value[kRows].is_array();
}

}  // namespace

JsonListWriter::JsonListWriter(std::ostream& out, const std::string& name)
    : out_(&out), is_document_(extension_of(name) == ".json") {
}

void JsonListWriter::add_text(std::string_view row) {
  put(row);
  end_row();
}

void JsonListWriter::put(std::string_view piece) {
  if (is_document_ && !in_row_) {
    *out_ << (has_rows_ ? ",\n" : "{\"rows\":[\n");
  }
  in_row_ = true;
  *out_ << piece;
}

void JsonListWriter::end_row() {
  if (!is_document_) {
    *out_ << '\n';
  }
  has_rows_ = true;
  in_row_ = false;
}

void JsonListWriter::finish(Json totals) {
  if (!is_document_) {
    *out_ << json_line(totals);
    return;
  }
  // The members of the totals follow the rows in one object.
  *out_ << (has_rows_ ? "\n],\n" : "{\"rows\":[],\n")
        << std::string_view(json_line(totals)).substr(1);
}

void JsonListWriter::finish() {
  if (is_document_) {
    *out_ << (has_rows_ ? "\n]}\n" : "{\"rows\":[]}\n");
  }
}

const Json* ListedObject::find(std::string_view member) const {
  const auto found = value_.find(member);
  return found == value_.end() || found->is_null() ? nullptr : &*found;
}

void ListedObject::fail(const std::string& what) const {
  throw Error(ErrorKind::bad_file, place_ + ": " + what, kRepairList);
}

void ListedObject::fail(std::string_view member, std::string_view wanted) const {
  throw Error(ErrorKind::bad_file, fmt::format("{}, {}: expected {}", place_, member, wanted),
              kRepairList);
}

std::optional<std::string> ListedObject::text(std::string_view member) const {
  const Json* const found = find(member);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (!found->is_string()) {
    fail(member, "a text");
  }
  return found->get<std::string>();
}

std::optional<std::string> ListedObject::word(std::string_view member,
                                              std::initializer_list<std::string_view> words) const {
  std::optional<std::string> found = text(member);
  if (found && std::find(words.begin(), words.end(), *found) == words.end()) {
    fail(member, word_list({words.begin(), words.end()}));
  }
  return found;
}

std::optional<std::uint64_t> ListedObject::count(std::string_view member) const {
  const Json* const found = find(member);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (!found->is_number_unsigned()) {
    fail(member, "a count");
  }
  return found->get<std::uint64_t>();
}

std::optional<ListedObject> ListedObject::object(std::string_view member) const {
  const Json* const found = find(member);
  if (found == nullptr) {
    return std::nullopt;
  }
  if (!found->is_object()) {
    fail(member, "an object");
  }
  return ListedObject(*found, fmt::format("{}, {}", place_, member));
}

void ListedObject::check_number(std::string_view member) const {
  const Json* const found = find(member);
  if (found != nullptr && !found->is_number()) {
    fail(member, "a number");
  }
}

void ListedObject::check_numbers(std::string_view member, std::size_t count) const {
  const Json* const found = find(member);
  if (found != nullptr && !is_numbers(*found, count)) {
    fail(member, fmt::format("a list of {} numbers", count));
  }
}

void ListedObject::check_texts(std::string_view member) const {
  const Json* const found = find(member);
  const bool are_texts =
      found == nullptr ||
      (found->is_array() &&
       std::all_of(found->begin(), found->end(), [](const Json& one) { return one.is_string(); }));
  if (!are_texts) {
    fail(member, "a list of texts");
  }
}

void ListedObject::check_box(std::string_view member) const {
  const Json* const found = find(member);
  if (found != nullptr && !(found->is_array() && found->size() == 2 && is_numbers((*found)[0], 3) &&
                            is_numbers((*found)[1], 3))) {
    fail(member, "two corners of 3 numbers");
  }
}

std::vector<ListedObject> read_json_list(const std::string& option, const std::string& file) {
  const std::string text = whole_file(option, file);
  const std::string name = option + " " + file;
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::string_view first =
      std::string_view(text).substr(begin, text.find('\n', begin) - begin);
  const ParsedJson line = parse_json(first, kDeepestList);
  if (first.empty() || (line.fault == 0 && !is_document(line.value))) {
    return objects_of_lines(text, name);
  }
  ParsedJson whole = parse_json(text, kDeepestList);
  if (whole.fault != 0) {
    refuse(fmt::format("{}, line {}", name, line_at(text, whole.fault - 1)), whole);
  }
  if (!is_document(whole.value)) {
    return objects_of_lines(text, name);
  }
  return objects_of_document(std::move(whole.value), name);
}

}  // namespace soms::command
