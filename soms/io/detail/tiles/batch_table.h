/// \file
/// Batch tables of 3D Tiles: the objects of a tile, by number.
#pragma once

#include "soms/io/detail/gltf/feature.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/numbers/stored_number.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Bytes of a file, and where they begin in it.
struct FileSection {
  std::string_view bytes;
  std::size_t at = 0;
};

/// Properties of the batches of a tile, as columns.
class BatchTable {
 public:
  /// A table of `length` batches; `json` may be empty.
  /// \errors ErrorKind::bad_file: no JSON, a column that is shorter or longer than the table, or
  ///         that ends outside of `binary`; out_of_memory.
  BatchTable(Source& source, std::uint64_t length, FileSection json, std::string_view binary);

  [[nodiscard]] std::uint64_t length() const { return length_; }

  /// What the table says of a batch. \pre batch < length()
  [[nodiscard]] Feature feature(std::uint32_t batch) const;

  /// Adds what of the table is not read.
  void add_notes(std::vector<std::string>& notes) const;

 private:
  struct Column {
    std::string name;
    JsonValue json;         ///< a list, or where the numbers stand
    std::size_t at = 0;     ///< byte of `binary` where they begin
    std::size_t count = 0;  ///< numbers of a batch; 0: in the JSON
    StoredType type = {};
  };

  void add_column(std::string_view name, const JsonValue& json);
  [[nodiscard]] Column binary_column(std::string_view name, const JsonValue& json) const;
  [[nodiscard]] std::string value(const Column& column, std::uint32_t batch) const;

  std::uint64_t length_;
  std::string_view binary_;
  std::unique_ptr<JsonDocument> document_;
  std::vector<Column> columns_;
  LeftOut hierarchies_;
};

}  // namespace soms::detail
