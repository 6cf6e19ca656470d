#include "soms/tree/file/detail/head.h"

#include "soms/base/byte_fields.h"
#include "soms/base/error.h"
#include "soms/base/lanes_hash.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <cstring>
#include <string_view>

namespace soms::detail {

namespace {

struct SectionKind {
  const char* name;
  std::size_t size;  ///< of a record
};

constexpr std::array<SectionKind, kSections> kKinds = {{
    {"vertices", sizeof(Vec3)},
    {"triangles", sizeof(std::array<std::uint32_t, 3>)},
    {"faces", sizeof(std::uint32_t)},
    {"statements", 1},
    {"nodes", sizeof(WideNode)},
    {"blocks", sizeof(TriangleBlock)},
    {"least_ids", sizeof(TriangleId)},
    {"cells", sizeof(layout::MinMaxGrid::Cell)},
    {"list_ends", sizeof(std::uint32_t)},
    {"list_nodes", sizeof(std::uint32_t)},
    {"compact_nodes", sizeof(CompactNode)},
    {"compact_ids", sizeof(std::uint32_t)},
}};

constexpr std::size_t kHashAt = 24;        // of the head's own hash
constexpr std::size_t kSectionsAt = 256;   // of the table of sections
constexpr std::size_t kSectionBytes = 32;  // of each in the table

std::uint64_t rounded_up(std::uint64_t bytes) {
  return (bytes + kTreeFilePage - 1) / kTreeFilePage * kTreeFilePage;
}

void put_signed(std::string& bytes, int value) {
  put(bytes, static_cast<std::uint32_t>(value));
}

int take_signed(ByteReader& reader) {
  return static_cast<std::int32_t>(reader.number<std::uint32_t>());
}

void put_options(std::string& bytes, const BuildOptions& options) {
  put_signed(bytes, static_cast<int>(options.rule));
  put_signed(bytes, static_cast<int>(options.midpoint));
  put_signed(bytes, options.c_vertex);
  put_signed(bytes, options.axis_from ? static_cast<int>(*options.axis_from) : -1);
  put_signed(bytes, static_cast<int>(options.empty_side));
  put_signed(bytes, options.level);
  put_signed(bytes, options.root_level);
  put_signed(bytes, options.per_leaf);
}

template <class Enum>
Enum take_enum(ByteReader& reader, Enum last, const std::string& file, const char* what) {
  const int value = take_signed(reader);
  if (value < 0 || value > static_cast<int>(last)) {
    fail_tree_file(file, std::string("head: ") + what + " " + std::to_string(value));
  }
  return static_cast<Enum>(value);
}

BuildOptions take_options(ByteReader& reader, const std::string& file) {
  BuildOptions options;
  options.rule = take_enum(reader, Rule::quick, file, "rule");
  options.midpoint = take_enum(reader, Midpoint::aabb, file, "midpoint");
  options.c_vertex = take_signed(reader);
  const int axis_from = take_signed(reader);
  if (axis_from < -1 || axis_from > static_cast<int>(AxisFrom::inner)) {
    fail_tree_file(file, "head: axis_from " + std::to_string(axis_from));
  }
  if (axis_from >= 0) {
    options.axis_from = static_cast<AxisFrom>(axis_from);
  }
  options.empty_side = take_enum(reader, EmptySide::chain, file, "empty_side");
  options.level = take_signed(reader);
  options.root_level = take_signed(reader);
  options.per_leaf = take_signed(reader);
  return options;
}

void put_plan(std::string& bytes, const layout::GroundPlan& plan) {
  for (const std::uint8_t axis : plan.axis) {
    put(bytes, std::uint32_t{axis});
  }
  put(bytes, std::uint32_t{0});
  for (const double number : {plan.origin[0], plan.origin[1], plan.last[0], plan.last[1],
                              plan.columns_a_unit, plan.rounding}) {
    put(bytes, number);
  }
}

layout::GroundPlan take_plan(ByteReader& reader) {
  layout::GroundPlan plan;
  for (std::uint8_t& axis : plan.axis) {
    axis = static_cast<std::uint8_t>(reader.number<std::uint32_t>());
  }
  static_cast<void>(reader.number<std::uint32_t>());
  for (double* number : {&plan.origin[0], &plan.origin[1], &plan.last[0], &plan.last[1],
                         &plan.columns_a_unit, &plan.rounding}) {
    *number = reader.real();
  }
  return plan;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The hash of a head's bytes but for the hash itself.
std::uint64_t own_hash(std::string_view head) {
  std::string bytes(head.substr(0, kTreeFilePage));
  bytes.replace(kHashAt, sizeof(std::uint64_t), sizeof(std::uint64_t), '\0');
  return lanes_hash(std::as_bytes(std::span(bytes)));
}

void read_sections(ByteReader& reader, const std::string& file, TreeFileHead& head) {
  std::uint64_t end = kTreeFilePage;
  for (std::size_t k = 0; k < kSections; ++k) {
    const auto where = [&] { return "section " + name(static_cast<Section>(k)) + ": "; };
    SectionPlace& place = head.sections[k];
    const auto kind = reader.number<std::uint32_t>();
    const auto size = reader.number<std::uint32_t>();
    place.offset = reader.number<std::uint64_t>();
    place.count = reader.number<std::uint64_t>();
    place.hash = reader.number<std::uint64_t>();
    if (kind != k || size != kKinds[k].size) {
      fail_tree_file(file, where() + "kind " + std::to_string(kind) + " with records of " +
                               std::to_string(size) + " bytes");
    }
    if (place.offset != end) {
      fail_tree_file(file, where() + "offset " + std::to_string(place.offset) + " in place of " +
                               std::to_string(end));
    }
    if (place.count > (head.bytes - end) / size) {
      fail_tree_file(file,
                     where() + std::to_string(place.count) + " records do not fit into the file");
    }
    end = rounded_up(end + place.count * size);
  }
  if (end != head.bytes) {
    fail_tree_file(file, "head: the sections end at byte " + std::to_string(end) +
                             ", the file at " + std::to_string(head.bytes));
  }
}

}  // namespace

std::string name(Section section) {
  return kKinds[static_cast<std::size_t>(section)].name;
}

std::size_t record_size(Section section) {
  return kKinds[static_cast<std::size_t>(section)].size;
}

void fail_tree_file(const std::string& name, const std::string& what) {
  throw Error(ErrorKind::bad_file, name + ", " + what,
              "the file is damaged or was not written whole; build it again: soms build");
}

void TreeFileHead::place() {
  bytes = kTreeFilePage;
  for (std::size_t k = 0; k < kSections; ++k) {
    sections[k].offset = bytes;
    bytes = rounded_up(bytes + sections[k].count * kKinds[k].size);
  }
}

std::string bytes_of(const TreeFileHead& head) {
  std::string bytes(kTreeFileMagic);
  put(bytes, kTreeFileVersion);
  put(bytes, static_cast<std::uint32_t>(kTreeFilePage));
  put(bytes, head.bytes);
  put(bytes, std::uint64_t{0});  // the hash
  put_options(bytes, head.options);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(bytes, head.bounds.lower[axis]);
    put(bytes, head.bounds.upper[axis]);
  }
  put(bytes, head.sah_area_ratio);
  put(bytes, head.sah_degradation);
  put_plan(bytes, head.plan);
  bytes.resize(kSectionsAt, '\0');
  for (std::size_t k = 0; k < kSections; ++k) {
    put(bytes, static_cast<std::uint32_t>(k));
    put(bytes, static_cast<std::uint32_t>(kKinds[k].size));
    put(bytes, head.sections[k].offset);
    put(bytes, head.sections[k].count);
    put(bytes, head.sections[k].hash);
  }
  static_assert(kSectionsAt + kSections * kSectionBytes <= kTreeFilePage);
  bytes.resize(kTreeFilePage, '\0');
  std::string hash;
  put(hash, own_hash(bytes));
  return bytes.replace(kHashAt, hash.size(), hash);
}

TreeFileHead read_head(std::span<const std::byte> bytes, const std::string& name) {
  if (!is_tree_file(bytes)) {
    throw Error(ErrorKind::bad_file, name + ": not a tree file",
                "build one: soms build MODEL -o " + name);
  }
  ByteReader reader(text_of(bytes).substr(kTreeFileMagic.size()));
  const auto version = reader.number<std::uint32_t>();
  if (version != kTreeFileVersion && !reader.failed()) {
    throw Error(ErrorKind::unsupported,
                name + ": a tree file of version " + std::to_string(version) +
                    ", and this program reads version " + std::to_string(kTreeFileVersion),
                "build it again: soms build");
  }
  const auto page = reader.number<std::uint32_t>();
  TreeFileHead head;
  head.bytes = reader.number<std::uint64_t>();
  if (bytes.size() < kTreeFilePage || head.bytes != bytes.size()) {
    fail_tree_file(name,
                   "head: the file has " + std::to_string(bytes.size()) + " bytes" +
                       (reader.failed() ? std::string()
                                        : ", and was written with " + std::to_string(head.bytes)));
  }
  const auto hash = reader.number<std::uint64_t>();
  if (page != kTreeFilePage || hash != own_hash(text_of(bytes))) {
    fail_tree_file(name, "head: it does not have the hash that it states");
  }
  head.options = take_options(reader, name);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    head.bounds.lower[axis] = reader.real();
    head.bounds.upper[axis] = reader.real();
  }
  head.sah_area_ratio = reader.real();
  head.sah_degradation = reader.real();
  head.plan = take_plan(reader);
  ByteReader table(text_of(bytes).substr(kSectionsAt));
  read_sections(table, name, head);
  return head;
}

std::uint64_t hash_of_head(std::span<const std::byte> bytes) {
  return get<std::uint64_t>(text_of(bytes).data() + kHashAt);
}

}  // namespace soms::detail
