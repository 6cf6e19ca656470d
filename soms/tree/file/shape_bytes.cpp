#include "soms/tree/file/shape_bytes.h"

#include "soms/base/error.h"
#include "soms/base/lanes_hash.h"
#include "soms/geometry/detail/counts.h"
#include "soms/tree/detail/held_mesh.h"
#include "soms/tree/file/detail/check_arrays.h"
#include "soms/tree/file/detail/head.h"
#include "soms/tree/file/detail/records.h"
#include "soms/tree/file/detail/statements.h"
#include "soms/tree/layout/detail/pages.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace soms {

namespace {

using detail::Section;
using detail::TreeFileHead;

/// Bytes that are gathered before they are passed on.
constexpr std::size_t kPiece = std::size_t{1} << 20;

using Put = std::function<void(std::span<const std::byte>)>;

/// Calls `put` with the records' bytes, the gaps in them 0.
template <class T>
void put_records(std::span<const T> records, const Put& put) {
  if (detail::gaps_of<T>().empty()) {
    put(std::as_bytes(records));
    return;
  }
  std::vector<std::byte> piece;
  constexpr std::size_t kAtOnce = kPiece / sizeof(T);
  for (std::size_t begin = 0; begin < records.size(); begin += kAtOnce) {
    const auto some = records.subspan(begin, std::min(kAtOnce, records.size() - begin));
    piece.resize(some.size_bytes());
    for (std::size_t i = 0; i < some.size(); ++i) {
      detail::copy_record(some[i], piece.data() + i * sizeof(T));
    }
    put(piece);
  }
}

/// What a file holds, each section as a function that puts its records.
class Content {
 public:
  explicit Content(const Shape& shape)
      : mesh_(shape.mesh()),
        arrays_(shape.layout().arrays()),
        statements_(detail::bytes_of_statements(mesh_)) {}

  /// Calls `visit(section, records)` for each section, in order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(Section::vertices, mesh_.vertices);
    visit(Section::triangles, mesh_.triangles);
    visit(Section::faces, mesh_.faces);
    visit(Section::statements, std::span<const char>(statements_));
    visit(Section::nodes, arrays_.nodes);
    visit(Section::blocks, arrays_.blocks);
    visit(Section::least_ids, arrays_.least_ids);
    visit(Section::cells, arrays_.cells);
    visit(Section::list_ends, arrays_.list_ends);
    visit(Section::list_nodes, arrays_.list_nodes);
    visit(Section::compact_nodes, arrays_.compact_nodes);
    visit(Section::compact_ids, arrays_.compact_ids);
  }

  [[nodiscard]] const LayoutArrays& arrays() const { return arrays_; }

 private:
  const MeshView& mesh_;
  LayoutArrays arrays_;
  std::string statements_;
};

/// The hash of a section's bytes as they are written.
template <class T>
std::uint64_t hash_of(std::span<const T> records) {
  if (detail::gaps_of<T>().empty()) {
    return lanes_hash(std::as_bytes(records));
  }
  std::vector<std::byte> bytes;
  bytes.reserve(records.size_bytes());
  put_records(records, [&](std::span<const std::byte> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  });
  return lanes_hash(bytes);
}

/// The records of a section, where they lie in a file.
template <class T>
std::span<const T> records_of(std::span<const std::byte> bytes, const TreeFileHead& head,
                              Section section) {
  const detail::SectionPlace& place = head.of(section);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): that is what the file holds
  return {reinterpret_cast<const T*>(bytes.data() + place.offset),
          static_cast<std::size_t>(place.count)};
}

LayoutArrays arrays_of(std::span<const std::byte> bytes, const TreeFileHead& head) {
  LayoutArrays arrays;
  arrays.nodes = records_of<WideNode>(bytes, head, Section::nodes);
  arrays.blocks = records_of<TriangleBlock>(bytes, head, Section::blocks);
  arrays.least_ids = records_of<TriangleId>(bytes, head, Section::least_ids);
  arrays.cells = records_of<layout::MinMaxGrid::Cell>(bytes, head, Section::cells);
  arrays.list_ends = records_of<std::uint32_t>(bytes, head, Section::list_ends);
  arrays.list_nodes = records_of<std::uint32_t>(bytes, head, Section::list_nodes);
  arrays.compact_nodes = records_of<CompactNode>(bytes, head, Section::compact_nodes);
  arrays.compact_ids = records_of<std::uint32_t>(bytes, head, Section::compact_ids);
  arrays.plan = head.plan;
  arrays.bounds = head.bounds;
  return arrays;
}

void check_hashes(std::span<const std::byte> bytes, const TreeFileHead& head,
                  const std::string& name, const Limits& limits) {
  for (std::size_t k = 0; k < detail::kSections; ++k) {
    const auto section = static_cast<Section>(k);
    const detail::SectionPlace& place = head.of(section);
    const auto size = static_cast<std::size_t>(place.count * detail::record_size(section));
    if (lanes_hash(bytes.subspan(static_cast<std::size_t>(place.offset), size), limits) !=
        place.hash) {
      detail::fail_tree_file(
          name, "section " + detail::name(section) + ": it does not have the hash that is stated");
    }
  }
}

/// Options that a build could have been made with, and numbers that go with them.
void check_head(const TreeFileHead& head, const MeshView& mesh, const std::string& name) {
  try {
    check(head.options);
    check_counts(mesh.vertices.size(), mesh.triangles.size(), name);
  } catch (const Error& error) {
    detail::fail_tree_file(name, "head: " + error.place());
  }
  if (!std::isfinite(head.sah_area_ratio) || std::isnan(head.sah_degradation)) {
    detail::fail_tree_file(name, "head: the areas of boxes are no numbers");
  }
}

/// What keeps a mesh's statements and the arrays of a file.
struct Owner {
  Mesh statements;
  std::shared_ptr<const void> file;
};

}  // namespace

bool is_tree_file(std::span<const std::byte> bytes) {
  return bytes.size() >= kTreeFileMagic.size() &&
         std::memcmp(bytes.data(), kTreeFileMagic.data(), kTreeFileMagic.size()) == 0;
}

void write_tree_file(const Shape& shape, const Put& put) {
  if constexpr (std::endian::native == std::endian::big) {
    throw Error(ErrorKind::unsupported, "tree files on a machine of this byte order",
                "keep the model, and build the shape where it is used");
  }
  const Content content(shape);
  TreeFileHead head;
  head.bounds = content.arrays().bounds;
  head.options = shape.build_options();
  head.plan = content.arrays().cells.empty() ? layout::GroundPlan{} : content.arrays().plan;
  std::tie(head.sah_area_ratio, head.sah_degradation) = detail::areas_of(shape);
  content.for_each([&](Section section, const auto& records) {
    head.of(section).count = records.size();
    head.of(section).hash = hash_of(records);
  });
  head.place();
  const std::string head_bytes = bytes_of(head);
  put(std::as_bytes(std::span(head_bytes)));
  const std::vector<std::byte> zeros(detail::kTreeFilePage);
  content.for_each([&](Section, const auto& records) {
    put_records(records, put);
    const std::size_t rest = records.size_bytes() % detail::kTreeFilePage;
    if (rest != 0) {
      put(std::span(zeros).first(detail::kTreeFilePage - rest));
    }
  });
}

Shape open_shape(std::shared_ptr<const void> owner, std::span<const std::byte> bytes,
                 const std::string& name, const OpenOptions& options, const Limits& limits) {
  if constexpr (std::endian::native == std::endian::big) {
    throw Error(ErrorKind::unsupported, name + ": tree files on a machine of this byte order",
                "build the shape from the model");
  }
  const TreeFileHead head = detail::read_head(bytes, name);
  if (options.check >= TreeCheck::sound) {
    check_hashes(bytes, head, name, limits);
  }
  const auto statements = records_of<char>(bytes, head, Section::statements);
  auto held = std::make_shared<Owner>(Owner{
      detail::read_statements({statements.data(), statements.size()}, name), std::move(owner)});
  const MeshView mesh(held->statements, records_of<Vec3>(bytes, head, Section::vertices),
                      records_of<std::array<std::uint32_t, 3>>(bytes, head, Section::triangles),
                      records_of<std::uint32_t>(bytes, head, Section::faces));
  check_head(head, mesh, name);
  const LayoutArrays arrays = arrays_of(bytes, head);
  if (options.check >= TreeCheck::safe) {
    check(mesh);
    detail::check_arrays(arrays, mesh, name, options.check >= TreeCheck::sound, limits);
  }
  auto layout = std::make_shared<const WideTree>(arrays, held);
  if (options.check == TreeCheck::full && !(WideTree(*layout, mesh, limits) == *layout)) {
    detail::fail_tree_file(name, "section nodes: boxes are not those of the triangles");
  }
  auto held_mesh = std::make_shared<detail::HeldMesh>(mesh, held);
  held_mesh->set_tree_file({name, detail::hash_of_head(bytes)});
  return detail::opened({.mesh = std::move(held_mesh),
                         .layout = std::move(layout),
                         .build_options = head.options,
                         .sah_area_ratio = head.sah_area_ratio,
                         .sah_degradation = head.sah_degradation});
}

Shape open_shape(std::span<const std::byte> bytes, const std::string& name,
                 const OpenOptions& options, const Limits& limits) {
  auto copy = std::make_shared<layout::Pages<std::byte>>();
  copy->assign(bytes.begin(), bytes.end());
  const std::span<const std::byte> held(*copy);
  return open_shape(std::move(copy), held, name, options, limits);
}

std::uint64_t tree_file_hash(std::span<const std::byte> bytes, const std::string& name) {
  static_cast<void>(detail::read_head(bytes, name));
  return detail::hash_of_head(bytes);
}

}  // namespace soms
