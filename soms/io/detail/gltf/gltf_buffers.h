/// \file
/// Where the bytes of a glTF file stand: in the file, in its JSON, or in files of its folder.
#pragma once

#include "soms/io/detail/json_document.h"
#include "soms/io/detail/left_out.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace soms::detail {

/// Refuses what an extension would change. \errors ErrorKind::unsupported.
[[noreturn]] void refuse_extension(const JsonValue& place, std::string_view extension);

/// The same where the document lists the extension as required.
[[noreturn]] void refuse_required_extension(const JsonValue& place, std::string_view extension);

/// The bytes of a buffer view.
struct GltfView {
  std::string_view bytes;
  std::uint64_t stride = 0;  ///< bytes from element to element; 0: one behind the other
};

/// Buffers of a document, each loaded when it is first needed: what is not needed may be missing.
class GltfBuffers {
 public:
  /// `chunk` holds the buffer that names no file; binary files have it.
  GltfBuffers(Source& source, std::optional<std::string_view> chunk)
      : source_(source), chunk_(chunk) {}

  /// The view that a number of the document names; its bytes live as long as this.
  /// \errors ErrorKind::bad_file, cannot_open, unsupported, out_of_memory, cancelled.
  [[nodiscard]] GltfView view(const JsonValue& reference);

  /// Bytes of the model's own file that stand behind those that a buffer states.
  [[nodiscard]] const LeftOut& surplus() const { return surplus_; }

 private:
  [[nodiscard]] std::string_view load(const JsonValue& buffer, bool is_first);
  [[nodiscard]] std::string_view decode(const JsonValue& uri);
  [[nodiscard]] std::string_view open(const JsonValue& uri);
  [[nodiscard]] char* store(std::uint64_t size);

  Source& source_;
  std::optional<std::string_view> chunk_;
  std::unordered_map<std::uint64_t, std::string_view> loaded_;
  /// Files by what they are: many buffers, names and links may mean one, which is read once.
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::string_view> files_;
  std::vector<std::unique_ptr<char[]>> memory_;
  LeftOut surplus_;
};

}  // namespace soms::detail
