/// \file
/// Lists in JSON, as files: rows, then an object that ends the list. A `.jsonl` file has one object
/// a line; a `.json` file is one document, the last object with the others as its `rows`.
#pragma once

#include "apps/output/json.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// Writes a list to a stream, one form for every verb.
class JsonListWriter {
 public:
  /// The form by the extension of `name`: `.json` is one document, anything else lines.
  JsonListWriter(std::ostream& out, const std::string& name);

  void add(const Json& row) { add_text(json_text(row)); }

  /// A row as `json_text` made it.
  void add_text(std::string_view row);

  /// A piece of a row, which `end_row` ends.
  void put(std::string_view piece);
  void end_row();

  /// Ends the list. `totals` has no member `rows`.
  void finish(Json totals);

  /// Ends a list of rows alone.
  void finish();

 private:
  std::ostream* out_;
  bool is_document_;
  bool has_rows_ = false;
  bool in_row_ = false;
};

/// An object of a list that was read. A member of another type than requested is an error that
/// names the file, the line or row, and the member.
class ListedObject {
 public:
  /// `place`: "old.jsonl, line 3".
  ListedObject(Json value, std::string place)
      : value_(std::move(value)), place_(std::move(place)) {}

  [[nodiscard]] const Json& value() const { return value_; }

  [[nodiscard]] bool has(std::string_view member) const { return value_.contains(member); }

  /// "old.jsonl, line 3".
  [[nodiscard]] const std::string& place() const { return place_; }

  /// Nothing where it is absent or null, as for all members below.
  /// \errors ErrorKind::bad_file for another type.
  [[nodiscard]] std::optional<std::string> text(std::string_view member) const;

  /// One of `words`.
  [[nodiscard]] std::optional<std::string> word(
      std::string_view member, std::initializer_list<std::string_view> words) const;

  [[nodiscard]] std::optional<std::uint64_t> count(std::string_view member) const;

  [[nodiscard]] std::optional<ListedObject> object(std::string_view member) const;

  void check_number(std::string_view member) const;

  /// A list of so many numbers, of which null is one that JSON does not have.
  void check_numbers(std::string_view member, std::size_t count) const;

  /// A list of texts.
  void check_texts(std::string_view member) const;

  /// Two lists of three numbers.
  void check_box(std::string_view member) const;

  /// \errors ErrorKind::bad_file, always.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  /// Null where it is absent or null.
  [[nodiscard]] const Json* find(std::string_view member) const;
  [[noreturn]] void fail(std::string_view member, std::string_view wanted) const;

  Json value_;
  std::string place_;
};

/// Reads a list of either form, by its content; a document gives its rows, then itself without
/// them. Lines that are empty are passed over.
/// \errors ErrorKind::cannot_open; bad_file, with the line: no JSON, no object, nested more than 64
///         deep. `option` is named first.
[[nodiscard]] std::vector<ListedObject> read_json_list(const std::string& option,
                                                       const std::string& file);

}  // namespace soms::command
