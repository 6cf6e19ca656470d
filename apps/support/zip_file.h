/// \file
/// A ZIP archive of members that are stored as they are.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The checksum of ZIP and PNG (CRC-32), of bytes that come in pieces.
class Crc32 {
 public:
  void add(std::string_view bytes);

  [[nodiscard]] std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xffffffffU;
};

/// Writes an archive front to back, in the 64-bit form throughout: a member may have any size. The
/// same members give the same bytes; their date is 1980-01-01.
/// \source PKWARE, APPNOTE.TXT 6.3.
class ZipWriter {
 public:
  /// The stream must stay; whether it failed is for its owner to look at.
  explicit ZipWriter(std::ostream& out) : out_(out) {}

  /// Gives the bytes of a member, in pieces, to the function that it is called with.
  using Content = std::function<void(const std::function<void(std::string_view)>&)>;

  /// `content` is called twice, and must give the same bytes.
  void add(const std::string& name, const Content& content);

  /// Writes the list of members; the archive is whole then.
  void finish();

 private:
  struct Member {
    std::string name;
    std::uint32_t checksum = 0;
    std::uint64_t size = 0;
    std::uint64_t offset = 0;
  };

  void put(std::string_view bytes);

  std::ostream& out_;
  std::uint64_t written_ = 0;
  std::vector<Member> members_;
};

}  // namespace soms::command
