/// \file
/// JSON of a model file, parsed within limits, and read with errors that name a place as
/// `meshes[0].primitives[1].indices`.
#pragma once

#include "soms/io/detail/source.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::detail {

class JsonDocument;

/// A value of a document that must outlive it. Its type is checked when it is requested.
class JsonValue {
 public:
  /// `value`: nlohmann's, which only the source knows.
  JsonValue(const JsonDocument& document, const void* value)
      : document_(&document), value_(value) {}

  [[nodiscard]] bool operator==(const JsonValue& other) const { return value_ == other.value_; }

  [[nodiscard]] bool is_object() const;

  [[nodiscard]] bool is_null() const;

  [[nodiscard]] bool is_text() const;

  /// The member of an object, if it has it. \errors ErrorKind::bad_file: no object.
  [[nodiscard]] std::optional<JsonValue> find(std::string_view key) const;

  /// The member of an object. \errors ErrorKind::bad_file: no object, or it lacks the member.
  [[nodiscard]] JsonValue at(std::string_view key) const;

  /// The name of an object's first member, if it has any. \errors ErrorKind::bad_file: no object.
  [[nodiscard]] std::optional<std::string_view> first_name() const;

  /// The members of an object, sorted by name. \errors ErrorKind::bad_file: no object.
  [[nodiscard]] std::vector<std::pair<std::string_view, JsonValue>> members() const;

  /// A text as it is, anything else as JSON.
  [[nodiscard]] std::string as_text() const;

  /// Length of a list. \errors ErrorKind::bad_file: no list.
  [[nodiscard]] std::size_t size() const;

  /// The element of a list. \pre index < size().
  [[nodiscard]] JsonValue at(std::size_t index) const;

  /// \errors ErrorKind::bad_file: no whole number from 0.
  [[nodiscard]] std::uint64_t whole() const;

  /// \errors ErrorKind::bad_file: no number.
  [[nodiscard]] double number() const;

  /// \errors ErrorKind::bad_file: neither true nor false.
  [[nodiscard]] bool boolean() const;

  /// \errors ErrorKind::bad_file: no text.
  [[nodiscard]] std::string_view text() const;

  /// For a whole number that numbers an element of one of the document's lists ("accessors"): that
  /// element. \errors ErrorKind::bad_file.
  [[nodiscard]] JsonValue referred(std::string_view list) const;

  /// From the top to here; empty for the top. Found only now, so that reading keeps no paths.
  [[nodiscard]] std::string path() const;

  [[noreturn]] void fail(ErrorKind kind, const std::string& what, const std::string& remedy) const;

  /// Content that breaks the format.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const JsonDocument* document_;
  const void* value_;
};

/// A document, which keeps within the source's memory and nests at most 128 deep.
class JsonDocument {
 public:
  /// Parses `text`, which begins at byte `offset` of the file. Places are lines, or bytes where the
  /// file is binary; of a document that is one of several, `where` ("line 3") names which.
  /// \errors ErrorKind::bad_file (no JSON, a name that stands twice in an object), not_finite (a
  /// number beyond a double), out_of_memory, cancelled.
  JsonDocument(Source& source, std::string_view text, std::size_t offset, bool binary,
               std::string where = {});
  ~JsonDocument();
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;

  [[nodiscard]] const Source& source() const { return source_; }

  /// Of its values in the file; empty if there is no other document.
  [[nodiscard]] const std::string& where() const { return where_; }

  [[nodiscard]] JsonValue root() const;

  /// The path of a value of nlohmann's.
  [[nodiscard]] std::string path_of(const void* target) const;

 private:
  struct Root;

  Source& source_;
  std::string where_;
  std::unique_ptr<Root> root_;
  std::uint64_t taken_ = 0;  ///< of the source's memory
};

/// A text as it stands in JSON, in ASCII, with its quotes; what is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_text(std::string_view text);

}  // namespace soms::detail
