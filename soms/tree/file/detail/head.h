/// \file
/// The head of a tree file: what it holds, and where.
#pragma once

#include "soms/base/box.h"
#include "soms/tree/build_options.h"
#include "soms/tree/layout/detail/ground_plan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace soms::detail {

inline constexpr std::uint32_t kTreeFileVersion = 1;
/// Sections begin at multiples of it, as pages of memory do; the head takes the first.
inline constexpr std::uint64_t kTreeFilePage = 4096;

/// The arrays of a file, in their order in it.
enum class Section {
  vertices,
  triangles,
  faces,
  statements,  ///< what the mesh states beside its arrays: parts, unit, source, notes
  nodes,
  blocks,
  least_ids,
  cells,
  list_ends,
  list_nodes,
  compact_nodes,
  compact_ids,
};

inline constexpr std::size_t kSections = 12;

/// Name of a section, for messages.
[[nodiscard]] std::string name(Section section);

/// Bytes of a record of a section.
[[nodiscard]] std::size_t record_size(Section section);

/// A section's place in the file.
struct SectionPlace {
  std::uint64_t offset = 0;  ///< of its first byte
  std::uint64_t count = 0;   ///< of its records
  std::uint64_t hash = 0;    ///< of its bytes
};

struct TreeFileHead {
  std::uint64_t bytes = 0;  ///< of the whole file
  Box bounds;
  BuildOptions options;
  double sah_area_ratio = 0;
  double sah_degradation = 1;
  layout::GroundPlan plan;
  std::array<SectionPlace, kSections> sections = {};

  [[nodiscard]] SectionPlace& of(Section section) {
    return sections[static_cast<std::size_t>(section)];
  }

  [[nodiscard]] const SectionPlace& of(Section section) const {
    return sections[static_cast<std::size_t>(section)];
  }

  /// Gives each section its place, by the records it has.
  void place();
};

/// The head as kTreeFilePage bytes, its own hash among them.
[[nodiscard]] std::string bytes_of(const TreeFileHead& head);

/// The head of a file. Each section is known to lie in `bytes`, in order and apart from others.
/// \errors ErrorKind::bad_file, unsupported; `name` is the file's.
[[nodiscard]] TreeFileHead read_head(std::span<const std::byte> bytes, const std::string& name);

/// The hash that the head has of itself. \pre `read_head` passes.
[[nodiscard]] std::uint64_t hash_of_head(std::span<const std::byte> bytes);

/// Throws ErrorKind::bad_file: "NAME, WHAT; ...".
[[noreturn]] void fail_tree_file(const std::string& name, const std::string& what);

}  // namespace soms::detail
