/// \file
/// Property tables of glTF (EXT_structural_metadata): what features are called.
#pragma once

#include "soms/io/detail/gltf/feature.h"
#include "soms/io/detail/gltf/gltf_buffers.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/numbers/stored_number.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace soms::detail {

/// One table: columns of texts, numbers, truth values and names of an enumeration.
class GltfPropertyTable {
 public:
  /// \errors ErrorKind::bad_file: a class that the schema lacks, columns shorter than the table.
  GltfPropertyTable(GltfBuffers& buffers, const JsonValue& schema, const JsonValue& table,
                    LeftOut& unread);

  [[nodiscard]] std::uint64_t count() const { return count_; }

  /// What the table says of a feature. \pre number < count() \errors ErrorKind::bad_file.
  [[nodiscard]] Feature feature(std::uint32_t number) const;

 private:
  enum class Kind { number, text, truth, name };

  struct Column {
    std::string name;
    JsonValue json;      ///< of the table
    JsonValue property;  ///< of the schema's class
    Kind kind = Kind::number;
    std::string_view values = {};
    StoredType type = {};                 ///< of numbers, of the values of an enumeration
    std::string_view offsets = {};        ///< of texts
    StoredType offset_type = {};          ///< of texts
    std::optional<JsonValue> names = {};  ///< of an enumeration
  };

  void add_column(GltfBuffers& buffers, const JsonValue& schema, std::string_view name,
                  const JsonValue& json, const JsonValue& property, LeftOut& unread);
  [[nodiscard]] bool find_type(Column& column, const JsonValue& schema) const;
  void find_values(GltfBuffers& buffers, Column& column) const;
  [[nodiscard]] std::optional<std::string> value(const Column& column, std::uint32_t number) const;
  [[nodiscard]] std::optional<std::string> number_value(const Column& column,
                                                        std::uint32_t number) const;
  [[nodiscard]] std::string text_value(const Column& column, std::uint32_t number) const;
  [[nodiscard]] std::string name_value(const Column& column, std::uint32_t number) const;

  std::uint64_t count_ = 0;
  std::vector<Column> columns_;
};

/// The tables of a document, each understood when it is first needed.
class GltfMetadata {
 public:
  GltfMetadata(const JsonValue& root, GltfBuffers& buffers);

  /// True if the document has property tables, and their schema in itself.
  [[nodiscard]] bool has_tables() const { return schema_ && tables_; }

  /// The table that a number names. \pre has_tables() \errors ErrorKind::bad_file.
  [[nodiscard]] const GltfPropertyTable& table(const JsonValue& number);

  /// Adds what of the tables is not read.
  void add_notes(std::vector<std::string>& notes) const;

 private:
  GltfBuffers& buffers_;
  std::optional<JsonValue> schema_;
  std::optional<JsonValue> tables_;
  std::unordered_map<std::uint64_t, std::unique_ptr<GltfPropertyTable>> loaded_;
  LeftOut unread_;
  LeftOut foreign_schemas_;
};

}  // namespace soms::detail
