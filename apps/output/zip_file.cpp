#include "apps/output/zip_file.h"

#include "soms/base/crc32.h"

#include "apps/output/deflate.h"

#include <algorithm>
#include <cstddef>

namespace soms::command {

namespace {

constexpr std::uint64_t kVersion = 45;       // that knows sizes of 64 bits
constexpr std::uint64_t kPlainVersion = 20;  // that knows deflate
constexpr std::uint64_t kNoFlags = 0;        // names are ASCII
constexpr std::uint64_t kStore = 0;
constexpr std::uint64_t kDeflate = 8;
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

void ZipWriter::put(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  written_ += bytes.size();
}

bool ZipWriter::is_wide(std::initializer_list<std::uint64_t> numbers) const {
  return form_ == ZipForm::wide || std::any_of(numbers.begin(), numbers.end(),
                                               [](auto number) { return number >= kIn64Bits; });
}

void ZipWriter::begin(const Member& member) {
  const bool wide = is_wide({member.size, member.packed});
  ZipRecord header(0x04034b50U);
  header.add(wide ? kVersion : kPlainVersion, 2).add(kNoFlags, 2);
  header.add(member.deflated ? kDeflate : kStore, 2);
  header.add(0, 2).add(kFirstOfJanuary1980, 2);  // time and date
  header.add(member.checksum, 4);
  header.add(wide ? kIn64Bits : member.packed, 4).add(wide ? kIn64Bits : member.size, 4);
  header.add(member.name.size(), 2).add(wide ? 20 : 0, 2).add(member.name);
  if (wide) {
    header.add(1, 2).add(16, 2).add(member.size, 8).add(member.packed, 8);  // the sizes in 64 bits
  }
  put(header.bytes());
}

void ZipWriter::add(const std::string& name, const Content& content) {
  Crc32 checksum;
  std::uint64_t size = 0;
  content([&](std::string_view bytes) {
    checksum.add(bytes);
    size += bytes.size();
  });
  members_.push_back({name, checksum.value(), size, size, written_});
  begin(members_.back());
  content([this](std::string_view bytes) { put(bytes); });
}

void ZipWriter::add_stored(const std::string& name, std::string_view bytes) {
  add(name, [bytes](const auto& take) { take(bytes); });
}

void ZipWriter::add_packed(const std::string& name, std::string_view bytes) {
  Crc32 checksum;
  checksum.add(bytes);
  const std::string packed = deflated(bytes, DeflateForm::raw);
  members_.push_back({name, checksum.value(), bytes.size(), packed.size(), written_, true});
  begin(members_.back());
  put(packed);
}

void ZipWriter::finish() {
  const std::uint64_t begin = written_;
  for (const Member& member : members_) {
    constexpr std::uint64_t kMadeByUnix = 3U << 8;
    constexpr std::uint64_t kRegularFile = 0100644ULL << 16;
    const bool wide = is_wide({member.size, member.packed, member.offset});
    const std::uint64_t version = wide ? kVersion : kPlainVersion;
    ZipRecord entry(0x02014b50U);
    entry.add(kMadeByUnix | version, 2).add(version, 2).add(kNoFlags, 2);
    entry.add(member.deflated ? kDeflate : kStore, 2);
    entry.add(0, 2).add(kFirstOfJanuary1980, 2).add(member.checksum, 4);
    entry.add(wide ? kIn64Bits : member.packed, 4).add(wide ? kIn64Bits : member.size, 4);
    entry.add(member.name.size(), 2).add(wide ? 28 : 0, 2).add(0, 2);  // names, extra, comment
    entry.add(0, 2).add(0, 2).add(kRegularFile, 4).add(wide ? kIn64Bits : member.offset, 4);
    entry.add(member.name);
    if (wide) {
      entry.add(1, 2).add(24, 2).add(member.size, 8).add(member.packed, 8).add(member.offset, 8);
    }
    put(entry.bytes());
  }
  const std::uint64_t end = written_;
  const std::uint64_t count = members_.size();
  const bool many = count >= 0xffffU;
  const bool wide = many || is_wide({end});
  if (wide) {
    ZipRecord last(0x06064b50U);
    last.add(44, 8).add(kVersion, 2).add(kVersion, 2).add(0, 4).add(0, 4);
    last.add(count, 8).add(count, 8).add(end - begin, 8).add(begin, 8);
    last.add(0x07064b50U, 4).add(0, 4).add(end, 8).add(1, 4);  // where that record is
    put(last.bytes());
  }
  ZipRecord last(0x06054b50U);
  last.add(0, 4).add(many ? 0xffffU : count, 2).add(many ? 0xffffU : count, 2);
  last.add(wide ? kIn64Bits : end - begin, 4).add(wide ? kIn64Bits : begin, 4).add(0, 2);
  put(last.bytes());
}

}  // namespace soms::command
