#include "apps/support/zip_file.h"

#include <array>
#include <cstddef>

namespace soms::command {

namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value >> 1) ^ ((value & 1U) != 0 ? 0xedb88320U : 0U);
    }
    table[i] = value;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

constexpr std::uint64_t kVersion = 45;               // that knows sizes of 64 bits
constexpr std::uint64_t kFirstOfJanuary1980 = 0x21;  // the earliest date of the format
constexpr std::uint64_t kIn64Bits = 0xffffffffU;     // a number that another place has

/// A record of little-endian numbers.
class ZipRecord {
 public:
  explicit ZipRecord(std::uint64_t signature) { add(signature, 4); }

  ZipRecord& add(std::uint64_t value, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
      bytes_ += static_cast<char>(value >> (8 * i) & 0xffU);
    }
    return *this;
  }

  ZipRecord& add(std::string_view text) {
    bytes_ += text;
    return *this;
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace

void Crc32::add(std::string_view bytes) {
  for (const char c : bytes) {
    state_ = (state_ >> 8) ^ kCrcTable[(state_ ^ static_cast<unsigned char>(c)) & 0xffU];
  }
}

void ZipWriter::put(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  written_ += bytes.size();
}

void ZipWriter::add(const std::string& name, const Content& content) {
  Crc32 checksum;
  std::uint64_t size = 0;
  content([&](std::string_view bytes) {
    checksum.add(bytes);
    size += bytes.size();
  });
  members_.push_back({name, checksum.value(), size, written_});
  ZipRecord header(0x04034b50U);
  header.add(kVersion, 2).add(0, 2).add(0, 2);   // flags; stored
  header.add(0, 2).add(kFirstOfJanuary1980, 2);  // time and date
  header.add(checksum.value(), 4).add(kIn64Bits, 4).add(kIn64Bits, 4);
  header.add(name.size(), 2).add(20, 2).add(name);
  header.add(1, 2).add(16, 2).add(size, 8).add(size, 8);  // the sizes in 64 bits
  put(header.bytes());
  content([this](std::string_view bytes) { put(bytes); });
}

void ZipWriter::finish() {
  const std::uint64_t begin = written_;
  for (const Member& member : members_) {
    constexpr std::uint64_t kMadeByUnix = 3U << 8;
    constexpr std::uint64_t kRegularFile = 0100644ULL << 16;
    ZipRecord entry(0x02014b50U);
    entry.add(kMadeByUnix | kVersion, 2).add(kVersion, 2).add(0, 2).add(0, 2);
    entry.add(0, 2).add(kFirstOfJanuary1980, 2);
    entry.add(member.checksum, 4).add(kIn64Bits, 4).add(kIn64Bits, 4);
    entry.add(member.name.size(), 2).add(28, 2).add(0, 2);  // names, extra field, comment
    entry.add(0, 2).add(0, 2).add(kRegularFile, 4).add(kIn64Bits, 4).add(member.name);
    entry.add(1, 2).add(24, 2).add(member.size, 8).add(member.size, 8).add(member.offset, 8);
    put(entry.bytes());
  }
  const std::uint64_t end = written_;
  const std::uint64_t count = members_.size();
  ZipRecord last(0x06064b50U);
  last.add(44, 8).add(kVersion, 2).add(kVersion, 2).add(0, 4).add(0, 4);
  last.add(count, 8).add(count, 8).add(end - begin, 8).add(begin, 8);
  last.add(0x07064b50U, 4).add(0, 4).add(end, 8).add(1, 4);  // where that record is
  last.add(0x06054b50U, 4).add(0, 2).add(0, 2).add(count, 2).add(count, 2);
  last.add(kIn64Bits, 4).add(kIn64Bits, 4).add(0, 2);
  put(last.bytes());
}

}  // namespace soms::command
