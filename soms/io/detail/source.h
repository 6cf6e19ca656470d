/// \file
/// The bytes of one file while it is read, with its limits and the errors that name a place in it.
#pragma once

#include "soms/base/error.h"
#include "soms/base/limits.h"
#include "soms/io/read_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace soms::detail {

/// Bytes that a reader may still allocate.
class Budget {
 public:
  explicit Budget(std::uint64_t limit) : left_(limit) {}

  /// False, and nothing taken, when fewer than `bytes` are left.
  [[nodiscard]] bool take(std::uint64_t bytes) {
    if (bytes > left_) {
      return false;
    }
    left_ -= bytes;
    return true;
  }

  void give_back(std::uint64_t bytes) { left_ += bytes; }

  [[nodiscard]] std::uint64_t left() const { return left_; }

 private:
  std::uint64_t left_;
};

/// What every reader is given.
struct Source {
  std::string_view bytes;
  std::size_t skipped = 0;  ///< bytes of the file before `bytes`: a byte order mark
  std::string name;         ///< for messages and `Mesh::source`
  bool allow_empty = false;
  /// Folder of the file, in which files that it names are looked for; none for bytes in memory.
  std::optional<std::filesystem::path> folder = {};
  double import_seconds = 0;       ///< that soms-import may take
  std::optional<double> lod = {};  ///< as ReadOptions
  bool surfaces = false;           ///< as ReadOptions
  bool is_city = false;            ///< what was read has levels of detail and semantic surfaces
  Budget budget{0};
  /// Bytes of memory that each byte of such a file adds; 0 where a limit was stated.
  std::uint64_t memory_per_byte = 0;
  const Limits& limits;
  /// `bytes` is memory of our own, and each reader may lose what it has passed for good.
  bool forgettable = false;
  std::size_t kept = 0;                 ///< bytes at the front that are not lost: a header
  std::size_t forgotten = 0;            ///< bytes that were passed for good
  std::size_t forgotten_line_ends = 0;  ///< among them

  /// Reports progress and ends the reading if that was requested; called every few thousand items.
  void tick(std::size_t position) const;

  /// Gives the memory of the bytes before `position` back, which nobody reads again: a text is
  /// larger than its mesh, and would else stay beside it to the end.
  void forget(std::size_t position);

  /// The limit of memory is reached.
  [[noreturn]] void fail_memory(std::uint64_t wanted) const;

  /// An error of the whole file.
  [[noreturn]] void fail(ErrorKind kind, const std::string& what, const std::string& remedy) const;

  /// "line 7": where `position` is in text, counted only now. \pre position >= forgotten.
  [[nodiscard]] std::string line_of(std::size_t position) const;

  /// "byte 86": where `position` is in the file.
  [[nodiscard]] std::string byte_of(std::size_t position) const;

  /// An error in text: names the line of `position`, counted only now.
  [[noreturn]] void fail_line(std::size_t position, ErrorKind kind, const std::string& what,
                              const std::string& remedy) const;

  /// An error in binary data: names the byte `position`.
  [[noreturn]] void fail_byte(std::size_t position, ErrorKind kind, const std::string& what,
                              const std::string& remedy) const;
};

/// The mark of UTF-8 that some programs write before a text.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Passes the mark of UTF-8 before a text, if it has one.
void skip_byte_order_mark(Source& source);

/// Rows between two calls of `Source::tick`.
inline constexpr std::size_t kRowsPerTick = 1 << 16;

/// Line ends in `[begin, end)` of a text: LF, CRLF or CR; CRLF counts where its LF is.
[[nodiscard]] std::size_t count_line_ends(std::string_view bytes, std::size_t begin,
                                          std::size_t end);

/// A word of a file made fit for a message: at most 40 characters, unprintable ones as '?'.
[[nodiscard]] std::string in_quotes(std::string_view token);

}  // namespace soms::detail
