#include "apps/shards/npz_join.h"

#include "soms/base/error.h"

#include "apps/output/npz_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

constexpr std::string_view kOffsets = "offsets";

/// A number of `size` bytes, the least first.
std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return value;
}

/// The arrays of a file that `NpzFile` wrote, front to back.
class NpzReader {
 public:
  struct Member {
    std::string name;
    std::uint64_t size = 0;
  };

  explicit NpzReader(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {
    if (!in_) {
      throw Error(ErrorKind::cannot_open, path.string() + ": cannot be read",
                  "give a folder that can be read");
    }
  }

  /// The next array; its bytes follow. Nothing behind the last one.
  [[nodiscard]] std::optional<Member> next() {
    const std::string head = take(kHead);
    if (number_at(head, 0, 4) == kListOfMembers) {
      return std::nullopt;
    }
    const std::size_t name_size = number_at(head, 26, 2);
    const std::size_t extra_size = number_at(head, 28, 2);
    if (number_at(head, 0, 4) != kMember || number_at(head, 8, 2) != 0 || extra_size != 20) {
      fail();
    }
    Member member{.name = take(name_size)};
    constexpr std::string_view kEnd = ".npy";
    if (!member.name.ends_with(kEnd)) {
      fail();
    }
    member.name.resize(member.name.size() - kEnd.size());
    member.size = number_at(take(extra_size), 4, 8);
    return member;
  }

  [[nodiscard]] std::string take(std::size_t size) {
    std::string bytes(size, '\0');
    if (!in_.read(bytes.data(), static_cast<std::streamsize>(size))) {
      fail();
    }
    return bytes;
  }

  [[noreturn]] void fail() const {
    throw Error(ErrorKind::bad_file, path_.string() + ": no file of answers of a shard",
                "answer this shard again");
  }

 private:
  static constexpr std::size_t kHead = 30;
  static constexpr std::uint64_t kMember = 0x04034b50;
  static constexpr std::uint64_t kListOfMembers = 0x02014b50;

  std::filesystem::path path_;
  std::ifstream in_;
};

/// What the head of an array says.
struct ArrayHead {
  std::string type;
  std::vector<std::size_t> shape;
  std::string bytes;  ///< the head itself
};

/// The text between two others; empty where there is none.
std::string_view between(std::string_view text, std::string_view before, std::string_view after) {
  const std::size_t begin = text.find(before);
  const std::size_t end =
      begin == std::string_view::npos ? begin : text.find(after, begin + before.size());
  return end == std::string_view::npos
             ? std::string_view()
             : text.substr(begin + before.size(), end - begin - before.size());
}

ArrayHead read_head(NpzReader& file) {
  constexpr std::size_t kBeforeText = 10;
  const std::string start = file.take(kBeforeText);
  const std::string text = file.take(number_at(start, 8, 2));
  ArrayHead head{
      .type = std::string(between(text, "'descr': '", "'")), .shape = {}, .bytes = start + text};
  const std::string_view sizes = between(text, "'shape': (", ")");
  for (const char* at = sizes.data(); at < sizes.data() + sizes.size(); ++at) {
    std::size_t size = 0;
    if (const auto [end, error] = std::from_chars(at, sizes.data() + sizes.size(), size);
        error == std::errc()) {
      head.shape.push_back(size);
      at = end - 1;
    }
  }
  if (head.type.empty() || head.shape.empty()) {
    file.fail();
  }
  return head;
}

std::optional<NpzColumn::Kind> kind_of(std::string_view type) {
  using Kind = NpzColumn::Kind;
  for (const auto& [name, kind] : {std::pair("<f8", Kind::number), std::pair("<i8", Kind::count),
                                   std::pair("|b1", Kind::flag), std::pair("|u1", Kind::code)}) {
    if (type == name) {
      return kind;
    }
  }
  return std::nullopt;
}

/// The whole answer as it grows.
class JoinedColumns {
 public:
  explicit JoinedColumns(const std::string& path) : file_(path) {}

  /// Adds the rows of one part behind those before.
  void add(const std::filesystem::path& path) {
    NpzReader part(path);
    std::size_t members = 0;
    while (const auto member = part.next()) {
      const ArrayHead head = read_head(part);
      if (head.bytes.size() > member->size) {
        part.fail();
      }
      add(part, *member, head);
      ++members;
    }
    if (members != columns_.size() + words_.size()) {
      part.fail();
    }
    first_ = false;
  }

  void finish() {
    for (const auto& [name, bytes] : words_in_order_) {
      file_.copy(name, bytes);
    }
    file_.finish();
  }

 private:
  void add(NpzReader& part, const NpzReader::Member& member, const ArrayHead& head) {
    const std::uint64_t size = member.size - head.bytes.size();
    const auto kind = kind_of(head.type);
    if (!kind) {
      add_words(part, member.name, head, size);
      return;
    }
    const std::vector<std::size_t> row(head.shape.begin() + 1, head.shape.end());
    if (first_) {
      columns_.emplace(member.name, &file_.column(member.name, *kind, row));
    }
    const auto column = columns_.find(member.name);
    if (column == columns_.end()) {
      part.fail();
    }
    if (member.name == kOffsets) {
      add_offsets(part, *column->second, size);
      return;
    }
    constexpr std::uint64_t kPiece = std::uint64_t{1} << 20U;
    for (std::uint64_t left = size; left > 0;) {
      const std::uint64_t piece = std::min(left, kPiece);
      column->second->add_bytes(part.take(piece));
      left -= piece;
    }
  }

  /// The first offset of a part is 0, which the part before has as its last.
  void add_offsets(NpzReader& part, NpzColumn& column, std::uint64_t size) {
    std::uint64_t last = 0;
    for (std::uint64_t i = 0; i < size / 8; ++i) {
      last = number_at(part.take(8), 0, 8);
      if (i > 0 || first_) {
        column.add(static_cast<std::int64_t>(listed_ + last));
      }
    }
    listed_ += last;
  }

  void add_words(NpzReader& part, const std::string& name, const ArrayHead& head,
                 std::uint64_t size) {
    const std::string bytes = part.take(size);
    if (first_) {
      words_.emplace(name, bytes);
      words_in_order_.emplace_back(name, head.bytes + bytes);
    }
    const auto there = words_.find(name);
    if (there == words_.end() || there->second != bytes) {
      part.fail();
    }
  }

  NpzFile file_;
  std::map<std::string, NpzColumn*, std::less<>> columns_;
  std::map<std::string, std::string, std::less<>> words_;
  std::vector<std::pair<std::string, std::string>> words_in_order_;
  std::uint64_t listed_ = 0;
  bool first_ = true;
};

}  // namespace

void join_npz(std::span<const std::filesystem::path> parts, const std::string& path) {
  JoinedColumns joined(path);
  for (const std::filesystem::path& part : parts) {
    joined.add(part);
  }
  joined.finish();
}

}  // namespace soms::command
