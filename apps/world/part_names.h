/// \file
/// What parts are called where somebody reads of them.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/geometry/parts_of.h"

#include "apps/model/file_numbers.h"
#include "apps/output/json.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

/// The name of a part as its file has it; "part 7" where it has none, and the file's name without
/// folder and extension for Part::kNoParent.
[[nodiscard]] std::string part_label(const MeshView& mesh, std::uint32_t part);

/// The labels of the parts around a part, the outermost first, and its own, with a slash between;
/// empty for Part::kNoParent. Of a path longer than `most` bytes at least the last `most`.
[[nodiscard]] std::string part_path_label(
    const MeshView& mesh, std::uint32_t part,
    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The path of a part for people: `part_path_label`, or `part_label` of no part, printable.
[[nodiscard]] std::string part_in_text(const MeshView& mesh, std::uint32_t part);

/// Number, name and path of a part, null and an empty path for Part::kNoParent.
[[nodiscard]] Json part_as_json(const MeshView& mesh, std::uint32_t part);

/// Labels of what is one body with a plus between; of more than three, how many more there are.
[[nodiscard]] std::string joined_label(const std::vector<std::string>& labels);

/// What a body of a part and others is called: `part_path_label`, or `part_label` of no part, of
/// each, as `joined_label` has it.
[[nodiscard]] std::string body_label(const MeshView& mesh, std::uint32_t part,
                                     std::span<const std::uint32_t> joined);

/// `part_as_json` of the part; `joined` has that of each other part, where there is one.
[[nodiscard]] Json body_as_json(const MeshView& mesh, std::uint32_t part,
                                std::span<const std::uint32_t> joined);

/// The number of a triangle as people read it: "12", or "12 (wall)" where its part has a name.
/// `numbers` are those of the file, where the mesh is what is left of it.
/// \cost O(p) for p parts.
[[nodiscard]] std::string triangle_label(const MeshView& mesh, TriangleId i,
                                         const FileNumbers& numbers = {});

/// Number and name of a part as two fields of CSV, empty for Part::kNoParent.
[[nodiscard]] std::string part_csv_fields(const MeshView& mesh, std::uint32_t part);

/// Number of a triangle, number and name of its part, as three fields of CSV; empty for no
/// triangle. `parts` are those of `mesh`.
[[nodiscard]] std::string triangle_csv_fields(const MeshView& mesh, const PartsOf& parts,
                                              std::optional<TriangleId> triangle);

}  // namespace soms::command
