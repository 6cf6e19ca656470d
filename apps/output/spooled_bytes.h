/// \file
/// Bytes that wait to be written, in a temporary file where they are many.
#pragma once

#include "apps/output/temporary_file.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

/// Bytes in the order in which they are added: the last few in memory, the others in a nameless
/// file of the folder for temporary files.
class SpooledBytes {
 public:
  /// \errors ErrorKind::cannot_write.
  void add(std::string_view bytes) {
    if (bytes_.size() + bytes.size() > kInMemory) {
      spool();
    }
    bytes_ += bytes;
  }

  [[nodiscard]] std::uint64_t size() const { return spooled_ + bytes_.size(); }

  /// Gives all of them to `take`, in pieces. \errors ErrorKind::cannot_write.
  void read(const std::function<void(std::string_view)>& take) const;

 private:
  static constexpr std::size_t kInMemory = std::size_t{1} << 16;

  void spool();

  std::string bytes_;          ///< behind those of the file
  std::uint64_t spooled_ = 0;  ///< bytes in the file
  std::optional<TemporaryFile> file_;
};

}  // namespace soms::command
