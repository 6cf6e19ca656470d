#include "soms/io/detail/numbers/npz_array.h"

#include "soms/base/crc32.h"
#include "soms/base/error.h"
#include "soms/io/detail/numbers/npy_header.h"
#include "soms/io/detail/source.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::string_view kExtension = ".npy";
constexpr std::uint32_t kElsewhere = 0xffffffff;  // a number that stands in 64 bits elsewhere

/// A file of an archive.
struct ZipMember {
  std::string_view name;
  std::uint16_t flags = 0;
  std::uint16_t method = 0;
  std::uint32_t sum = 0;   ///< of its content that is not packed
  std::uint64_t size = 0;  ///< as it is stored
  std::uint64_t at = 0;    ///< of its own header
};

/// The directory of a ZIP archive, which stands behind its files.
/// \source PKWARE, APPNOTE.TXT, sections 4.3.7, 4.3.12, 4.3.14 to 4.3.16 and 4.5.3.
class ZipDirectory {
 public:
  ZipDirectory(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[nodiscard]] std::vector<ZipMember> members() const {
    constexpr std::string_view kEndRecord = "PK\x05\x06";
    constexpr std::string_view kLocator = "PK\x06\x07";
    constexpr std::size_t kLocatorSize = 20;
    const std::size_t end = bytes_.rfind(kEndRecord);
    if (end == std::string_view::npos) {
      fail_cut();
    }
    std::uint64_t count = number(end + 10, 2);
    std::uint64_t at = number(end + 16, 4);
    if (end >= kLocatorSize && bytes_.substr(end - kLocatorSize).starts_with(kLocator)) {
      const std::uint64_t record = number(end - kLocatorSize + 8, 8);
      count = number(record, 56, 32, 8);
      at = number(record, 56, 48, 8);
    }
    std::vector<ZipMember> found;
    for (std::uint64_t i = 0; i < count; ++i) {
      at = add_member(at, found);
    }
    return found;
  }

  /// The bytes of a file as they are stored.
  [[nodiscard]] std::string_view content(const ZipMember& member) const {
    constexpr std::size_t kHeader = 30;
    const std::uint64_t names =
        number(member.at, kHeader, 26, 2) + number(member.at, kHeader, 28, 2);
    const std::uint64_t begin = member.at + kHeader + names;
    if (!bytes_.substr(member.at).starts_with(kZipMagic) || begin > bytes_.size() ||
        bytes_.size() - begin < member.size) {
      fail_cut();
    }
    return bytes_.substr(begin, member.size);
  }

 private:
  [[noreturn]] void fail_cut() const {
    throw Error(ErrorKind::bad_file, name_ + ": a ZIP archive that is cut off or damaged",
                "save the array again with numpy.savez");
  }

  /// A number of so many bytes.
  [[nodiscard]] std::uint64_t number(std::uint64_t at, std::size_t size) const {
    if (at > bytes_.size() || bytes_.size() - at < size) {
      fail_cut();
    }
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(bytes_[at + i]);
    }
    return value;
  }

  /// The number `from` bytes behind the begin of a record of so many bytes.
  [[nodiscard]] std::uint64_t number(std::uint64_t record, std::size_t record_size,
                                     std::size_t from, std::size_t size) const {
    if (record > bytes_.size() || bytes_.size() - record < record_size) {
      fail_cut();
    }
    return number(record + from, size);
  }

  /// Adds the file of the entry at `at`; the place of the next one.
  std::uint64_t add_member(std::uint64_t at, std::vector<ZipMember>& found) const {
    constexpr std::size_t kEntry = 46;
    constexpr std::string_view kMagic = "PK\x01\x02";
    const std::uint64_t name = number(at, kEntry, 28, 2);
    const std::uint64_t extra = number(at, kEntry, 30, 2);
    const std::uint64_t next = at + kEntry + name + extra + number(at, kEntry, 32, 2);
    if (next > bytes_.size() || !bytes_.substr(at).starts_with(kMagic)) {
      fail_cut();
    }
    ZipMember member{.name = bytes_.substr(at + kEntry, name),
                     .flags = static_cast<std::uint16_t>(number(at + 8, 2)),
                     .method = static_cast<std::uint16_t>(number(at + 10, 2)),
                     .sum = static_cast<std::uint32_t>(number(at + 16, 4)),
                     .size = number(at + 20, 4),
                     .at = number(at + 42, 4)};
    read_wide(at + kEntry + name, extra, number(at + 24, 4) == kElsewhere, member);
    found.push_back(member);
    return next;
  }

  /// Takes numbers of 64 bits from the extra fields `[at, at + size)`: of the size that is not
  /// stored (`plain`), of the stored one, and of the place, each if it is not in the entry itself.
  void read_wide(std::uint64_t at, std::uint64_t size, bool plain, ZipMember& member) const {
    constexpr std::uint64_t kWide = 1;
    for (const std::uint64_t end = at + size; at + 4 <= end;) {
      const std::uint64_t kind = number(at, 2);
      const std::uint64_t next = at + 4 + number(at + 2, 2);
      if (kind == kWide) {
        at += 4 + (plain ? 8U : 0U);
        for (std::uint64_t* const value : {&member.size, &member.at}) {
          if (*value == kElsewhere) {
            *value = number(at, 8);
            at += 8;
          }
        }
      }
      at = next;
    }
  }

  std::string_view bytes_;
  const std::string& name_;
};

/// The whole archive, in pieces as they come.
std::vector<char> bytes_of(LineReader& archive) {
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
  std::vector<char> bytes;
  while (true) {
    const std::string_view piece = archive.bytes(kPiece);
    if (piece.empty()) {
      return bytes;
    }
    if (bytes.size() + piece.size() > kMost) {
      throw Error(ErrorKind::out_of_memory, archive.name() + ": an archive of more than 4 GiB",
                  "save the array alone with numpy.save, which is read row by row");
    }
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  }
}

bool is_stored(const ZipMember& member) {
  return (member.flags & 1U) == 0 && member.method == 0;
}

/// Refuses an archive of which a member that is stored has changed, or a name stands twice.
void check_members(const ZipDirectory& directory, const std::vector<ZipMember>& members,
                   const std::string& name) {
  std::set<std::string_view> names;
  for (const ZipMember& member : members) {
    const std::string place = name + ", " + in_quotes(member.name);
    if (!names.insert(member.name).second) {
      throw Error(ErrorKind::bad_file, place + ": two members have this name",
                  "save the arrays again with numpy.savez");
    }
    if (!is_stored(member)) {
      continue;
    }
    Crc32 found;
    found.add(directory.content(member));
    if (found.value() != member.sum) {
      throw Error(ErrorKind::bad_file, place + ": its checksum (CRC-32) is wrong: it is damaged",
                  "copy the archive again, or save the arrays again with numpy.savez");
    }
  }
}

const ZipMember& chosen(const std::vector<ZipMember>& members, const std::string& name,
                        std::string_view what) {
  std::vector<const ZipMember*> arrays;
  std::string names;
  for (const ZipMember& member : members) {
    if (!member.name.ends_with(kExtension)) {
      continue;
    }
    const std::string_view array = member.name.substr(0, member.name.size() - kExtension.size());
    names += (arrays.empty() ? "" : ", ") + in_quotes(array);
    arrays.push_back(&member);
  }
  if (arrays.size() == 1) {
    return *arrays.front();
  }
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const ZipMember* member) {
    return member->name == std::string(what) + std::string(kExtension);
  });
  if (found == arrays.end()) {
    throw Error(ErrorKind::bad_file,
                name + (arrays.empty() ? ": a ZIP archive without an array of NumPy"
                                       : ": several arrays: " + names),
                "save one array, or name it " + in_quotes(what));
  }
  return **found;
}

LineReader array_of(LineReader& archive, std::string_view what) {
  const std::vector<char> bytes = bytes_of(archive);
  const ZipDirectory directory({bytes.data(), bytes.size()}, archive.name());
  const std::vector<ZipMember> members = directory.members();
  check_members(directory, members, archive.name());
  const ZipMember& member = chosen(members, archive.name(), what);
  const std::string name = archive.name() + ", " + in_quotes(member.name);
  if (!is_stored(member)) {
    throw Error(ErrorKind::unsupported, name + ": a compressed array",
                "save it with numpy.savez, which does not compress, or with numpy.save");
  }
  const std::string_view content = directory.content(member);
  if (!content.starts_with(kNpyMagic)) {
    throw Error(ErrorKind::bad_file, name + ": no array of NumPy",
                "save the array again with numpy.savez");
  }
  return {name, {content.begin(), content.end()}};
}

}  // namespace

NpzArray::NpzArray(LineReader& archive, std::string_view what) : file_(array_of(archive, what)) {
}

}  // namespace soms::detail
