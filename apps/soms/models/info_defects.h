/// \file
/// What `info` tells of a model's defects: how many of each kind, and where the first ones are.
#pragma once

#include "soms/geometry/defects.h"
#include "soms/geometry/mesh.h"

#include "apps/model/file_numbers.h"
#include "apps/output/json.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace soms::command {

class Console;

/// A model, or the parts of it that are looked at.
struct ExaminedMesh : Mesh {
  FileNumbers triangle_numbers = {};  ///< in the file
  FileNumbers vertex_numbers = {};
};

/// A part as its file calls it, or "number 3" where it has no name.
[[nodiscard]] std::string name_or_number(const ExaminedMesh& mesh, std::size_t part);

/// The counts, as the member `defects` of the JSON.
[[nodiscard]] Json defect_counts(const Defects& defects);

/// The places, as the member `places` of the JSON: a list for each kind.
[[nodiscard]] Json defect_places(const ExaminedMesh& mesh, const Defects& defects);

/// Places of edges, as a list of JSON.
[[nodiscard]] Json edge_places(const ExaminedMesh& mesh, std::span<const EdgePlace> edges);

/// Prints places of edges below a line with their `title`; `count` is how many there are in all.
/// \errors ErrorKind::cancelled; those of Console::print.
void print_edges(const ExaminedMesh& mesh, std::string_view title, std::span<const EdgePlace> edges,
                 std::uint64_t count, Console& console);

/// The counts in one line.
[[nodiscard]] std::string describe_defects(const Defects& defects);

/// How vertices are joined, in one line; empty if no two are in one place.
[[nodiscard]] std::string describe_joining(const ExaminedMesh& mesh, const Defects& defects);

/// Whether part number `part` is closed by itself: "closed", "open", or empty where that is unknown
/// or the part holds no triangle.
[[nodiscard]] std::string describe_part(const ExaminedMesh& mesh, const Defects& defects,
                                        std::size_t part);

/// Prints the places, a paragraph for each kind that there is.
/// \errors ErrorKind::cancelled; those of Console::print.
void print_places(const ExaminedMesh& mesh, const Defects& defects, Console& console);

}  // namespace soms::command
