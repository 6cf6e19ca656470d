/// \file
/// Reading models: the format is recognized by the content, then by the name.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace soms {

/// Options of reading a model.
struct ReadOptions {
  /// Accept a model without triangles.
  bool allow_empty = false;
  /// Most bytes to allocate; 0 means 64 times the file's size plus 64 MiB.
  std::uint64_t max_memory = 0;
  /// Most seconds that soms-import may take, for formats that soms does not read itself; what is
  /// not above 0 counts as 0.
  double import_seconds = 60;
  /// Make an error of what would be noted in `Mesh::notes`: a model is read without a note, or not
  /// at all.
  bool strict = false;
  /// Level of detail that is read of each object of a city (CityJSON): 1.2. Nothing: the most
  /// detailed one.
  std::optional<double> lod = std::nullopt;
  /// Make each semantic surface of a city's object (roof, wall) a part in the part of the object.
  bool surfaces = false;

  [[nodiscard]] bool operator==(const ReadOptions&) const = default;
};

/// Reads a PLY, 3DS, STL, OFF, OBJ, glTF, GLB, CityJSON, 3D Tiles or COLLADA model as stored, in
/// double. Nothing is welded, moved or lost but by the nodes of a scene. Triangle i is triangle i
/// of the file, and a polygon of n corners gives n-2 triangles. The mesh passes `check`. What else
/// the file holds is an error or is counted in `Mesh::notes`, by the rule of docs/formats.md, which
/// also says what each reader accepts. Only glTF models and tilesets open other files: those in
/// their folder that they name.
///
/// \errors  cannot_open (missing, unreadable, a directory), bad_file (names line or byte; with
///          `strict` also what is noted else), empty_mesh, not_finite, out_of_range, unsupported
///          (says what to do), out_of_memory, usage (`lod` or `surfaces` for what is no city).
/// \threads `limits` gives progress and cancellation; reading is one thread.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path, const ReadOptions& options = {},
                             const Limits& limits = {});

/// The same from bytes in memory; `name` stands for the path in messages and tells the format where
/// the content does not.
[[nodiscard]] Mesh read_mesh(std::span<const std::byte> bytes, const std::string& name,
                             const ReadOptions& options = {}, const Limits& limits = {});

}  // namespace soms
