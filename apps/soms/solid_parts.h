/// \file
/// `solid --by part`: the parts of two models, and how each pair of them stands to each other.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/contains.h"
#include "soms/query/solid.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace soms::command {

/// The triangles of a model whose innermost part it is, as a body of its own.
struct SolidPart {
  std::uint32_t part = Part::kNoParent;  ///< index in Mesh::parts; triangles without a part: none
  std::uint64_t odd_edges = 0;           ///< of an open part
  Body body = {};
  std::optional<ClosedBody> closed = std::nullopt;  ///< none: the part is open
};

/// Two parts that are not clear of each other.
struct SolidPair {
  const SolidPart* a;
  const SolidPart* b;
  Solid answer;
};

/// The answer where one of two bodies is open: undecided, and whether their surfaces meet.
/// \errors As `overlap`.
[[nodiscard]] Solid open_answer(
    const Body& a, const Body& b,
    std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt,
    const Parallel& parallel = {});

/// The parts of a model, in the order of Mesh::parts.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<SolidPart> solid_parts(const Mesh& mesh, const Parallel& parallel);

/// The pairs of parts that are not clear, by part of a, then of b. An open part is undecided beside
/// every part whose box meets its own.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<SolidPair> solid_pairs(
    const std::vector<SolidPart>& a, const Pose& pose_a, const std::vector<SolidPart>& b,
    const Pose& pose_b, std::optional<std::chrono::steady_clock::time_point> deadline,
    const Parallel& parallel);

}  // namespace soms::command
