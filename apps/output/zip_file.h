/// \file
/// A ZIP archive of members that are stored as they are, or packed.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// How an archive writes sizes and places.
enum class ZipForm : unsigned char {
  wide,   ///< in 64 bits throughout: a member may have any size
  plain,  ///< in 32 bits where they fit, which the oldest readers understand, too
};

/// Writes an archive front to back. The same members give the same bytes; their date is 1980-01-01.
/// \source PKWARE, APPNOTE.TXT 6.3.
class ZipWriter {
 public:
  /// The stream must stay; whether it failed is for its owner to look at.
  explicit ZipWriter(std::ostream& out, ZipForm form = ZipForm::wide) : out_(out), form_(form) {}

  /// Gives the bytes of a member, in pieces, to the function that it is called with.
  using Content = std::function<void(const std::function<void(std::string_view)>&)>;

  /// `content` is called twice, and must give the same bytes.
  void add(const std::string& name, const Content& content);

  /// A member of these bytes, as they are.
  void add_stored(const std::string& name, std::string_view bytes);

  /// A member of these bytes, packed. \errors ErrorKind::cannot_write beyond 2 GB.
  void add_packed(const std::string& name, std::string_view bytes);

  /// Writes the list of members; the archive is whole then.
  void finish();

 private:
  struct Member {
    std::string name;
    std::uint32_t checksum = 0;
    std::uint64_t size = 0;
    std::uint64_t packed = 0;  ///< bytes in the archive
    std::uint64_t offset = 0;
    bool deflated = false;
  };

  void put(std::string_view bytes);
  void begin(const Member& member);

  /// Whether these numbers are written in 64 bits.
  [[nodiscard]] bool is_wide(std::initializer_list<std::uint64_t> numbers) const;

  std::ostream& out_;
  ZipForm form_;
  std::uint64_t written_ = 0;
  std::vector<Member> members_;
};

}  // namespace soms::command
