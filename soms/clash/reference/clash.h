/// \file
/// The brute-force twin of `clashes`: every part against every other, without a broad phase or
/// trees. What tests and `--verify` believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/clash/clash.h"

#include <optional>
#include <span>
#include <vector>

namespace soms::reference {

/// What closes an open body, as PartBody::caps has it, by odd edges that are counted one by one.
[[nodiscard]] Mesh caps_by_brute_force(const Body& open);

/// The clash of two parts as `clashes` has it, but for `place` and `box`, which are left as they
/// are by default: by `solid_by_brute_force`, `overlap` and `distance_by_brute_force`. Nothing
/// where they are clear of each other. Numbers of parts are 0.
/// \errors ErrorKind::cancelled.
/// \cost O(n m) for n and m triangles; where surfaces do not meet, and a gap or a side is wanted, a
/// good deal more for each pair of triangles.
[[nodiscard]] std::optional<Clash> clash_by_brute_force(const PartBody& a, const PartBody& b,
                                                        std::optional<double> within,
                                                        const Limits& limits = {});

/// The same of all pairs of a part of `a` and a part of `b`, by a, then b.
[[nodiscard]] std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> a,
                                                        std::span<const PartBody> b,
                                                        std::optional<double> within,
                                                        const Limits& limits = {});

/// The same of all pairs of one set.
[[nodiscard]] std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> parts,
                                                        std::optional<double> within,
                                                        const Limits& limits = {});

}  // namespace soms::reference
