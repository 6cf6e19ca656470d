/// \file
/// Which parts of a building, a plant or a city clash: cross, contain, touch or come near each
/// other? Decided exactly for each pair.
///
/// \code
/// const soms::Mesh mesh = soms::generate_sphere(320);  // of radius 1, about the origin
/// const auto ball = [&mesh](double x) {
///   return soms::part_bodies(mesh, soms::Pose::translation(x, 0, 0)).front();
/// };
/// const std::vector<soms::PartBody> parts{ball(0), ball(1.5), ball(4)};
/// for (const soms::Clash& clash : soms::clashes(parts, {.within = 1}).clashes) {
///   std::cout << clash.a << " and " << clash.b << ": " << clash.kind << ", gap "
///             << clash.gap.lower << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// 0 and 1: crossing, gap 0
/// 1 and 2: near, gap 0.530384
/// \endverbatim
#pragma once

#include "soms/base/box.h"
#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/clash/part_bodies.h"
#include "soms/clash/penetration.h"
#include "soms/query/answer.h"
#include "soms/query/solid.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace soms {

/// What kind of clash a pair of parts is; the order is that of a list.
enum class ClashKind : unsigned char {
  /// Interior is shared, and each has interior outside the other. Where a part is open: an edge of
  /// one goes through the inside of a triangle of the other, so that both surfaces go on to both
  /// sides. Or some of several components of an open part are in the other.
  crossing,
  inside,     ///< one lies in the other: `Clash::relation` says which
  same,       ///< both fill the same space
  touching,   ///< surfaces meet, and no interior is shared
  near,       ///< nothing is shared, and the surfaces are within ClashOptions::within
  undecided,  ///< see `Clash::why`
};

template <>
inline constexpr auto kWords<ClashKind> =
    words("ClashKind", "What kind of clash a pair of parts is; undecided where a part is open.",
          "crossing", "inside", "same", "touching", "near", "undecided");

/// Options of `clashes`.
struct ClashOptions {
  /// Parts that share nothing and are at most so far from each other are `near`, decided exactly.
  /// Nothing: no pair is near.
  std::optional<double> within = std::nullopt;
  /// Pairs of parts, by their numbers, that are looked at. Empty: all. Must give the same answer
  /// for the same pair, from any thread. An open group is looked at with its first part.
  std::function<bool(std::uint32_t a, std::uint32_t b)> wanted = {};
};

/// Throws ErrorKind::usage for a `within` that is negative, infinite or not a number.
void check(const ClashOptions& options);

/// Two parts that clash.
struct Clash {
  std::uint32_t a = 0;  ///< number of the part of the first set
  std::uint32_t b = 0;  ///< of the second; of one set, the greater number
  ClashKind kind = ClashKind::undecided;
  /// As `solid` says, where both are closed; `clear` of near ones. An open part is in a closed one
  /// if its surface is.
  Relation relation = Relation::undecided;
  /// Why it is undecided. `open` where a part is not closed (PartBody::odd_edges), and surfaces
  /// meet without passing through each other. Or the other part may be inside it, or inside what it
  /// encloses together with others (`body_in`).
  Undecided why = Undecided::none;
  std::uint64_t triangle_pairs = 0;  ///< pairs of triangles that overlap, as `overlap` counts them
  /// Holds the least distance of the surfaces: [0, 0] where they meet, otherwise as `Distance` has
  /// it.
  Bracket gap = {};
  /// A point of the clash. Where surfaces meet, of both (rounded, as `crossing` says). Where one is
  /// in the other and they do not, a vertex of the inner one. Otherwise the middle of a shortest
  /// segment between the two.
  Vec3 place = {};
  /// Holds all that the surfaces share; where they share nothing, the inner part, or a shortest
  /// segment.
  Box box = {};
  /// How to separate the two, of crossing, inside and same ones: `b` is moved. Nothing unless both
  /// are convex (ConvexPart).
  std::optional<Penetration> penetration = std::nullopt;

  [[nodiscard]] bool operator==(const Clash&) const = default;
};

/// What `part` stands for in a clash with `other`. An undecided clash of parts whose surfaces do
/// not meet is of the bodies that the two lead (PartBody::leads), of which one may be inside the
/// other. That is its open group, if `other` is of another one or none. In all else a part stands
/// for itself.
[[nodiscard]] const PartBody& body_in(const Clash& clash, const PartBody& part,
                                      const PartBody& other);

/// Answer of `clashes`.
struct ClashList {
  std::vector<Clash> clashes;  ///< by a, then b
  std::uint64_t compared = 0;  ///< pairs of parts that were decided
  std::uint64_t left_out = 0;  ///< pairs that were not, as the deadline passed
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const ClashList&) const = default;
};

/// Numbers of two parts.
using PartNumbers = std::pair<std::uint32_t, std::uint32_t>;

/// The pairs of a part of `a` and one of `b` whose boxes share a point, or come within
/// `options.within`, sorted; all others are clear of each other. The box of the first part of an
/// open group is around the group, too, for other bodies. Pairs that `options.wanted` refuses are
/// left out.
/// \errors  As `check(ClashOptions)`; ErrorKind::out_of_range above 2^27 parts.
/// \cost    O(n + p) for n parts and p pairs, as a rule (BroadPhase).
[[nodiscard]] std::vector<PartNumbers> clash_candidates(std::span<const PartBody> a,
                                                        std::span<const PartBody> b,
                                                        const ClashOptions& options = {});

/// The same among the parts of one set: each pair once, the lesser number first.
[[nodiscard]] std::vector<PartNumbers> clash_candidates(std::span<const PartBody> parts,
                                                        const ClashOptions& options = {});

/// Decides pairs of parts that `clash_candidates` named: for callers who do some of them at a time.
/// \errors  As `check(ClashOptions)`; ErrorKind::out_of_range for a part that is not there;
///          cancelled.
[[nodiscard]] ClashList clashes_of(std::span<const PartBody> a, std::span<const PartBody> b,
                                   std::span<const PartNumbers> pairs,
                                   const ClashOptions& options = {}, const Limits& limits = {});

/// All clashes of a part of `a` with a part of `b`. Two parts are clear of each other, and not in
/// the list, where both are closed and `solid` says so, or where their boxes share no point. Those
/// within ClashOptions::within are near.
///
/// What an open part encloses is unknown; it is taken to be closed by caps (PartBody::caps). So
/// much is decided all the same. Surfaces that pass through each other, where both bound something,
/// cross. An open part whose surface lies in a closed one is inside, unless a component of that
/// fits into its box. Where surfaces do not meet, and no component of either lies wholly in the box
/// of an open one or goes through its caps, the two are clear. All else is undecided.
///
/// Open parts that hang together (PartBody::together) are compared one by one, and their group as
/// one open body, too. Surfaces of the group and of another body may not meet, with neither in a
/// closed one. If one may then be inside the other, the first part and the other body are
/// undecided, not near.
///
/// The answer does not depend on threads, trees, layouts or instruction sets, nor on the order of
/// the parts but for their numbers; with a deadline it may.
///
/// \errors  As `clash_candidates` and `clashes_of`.
/// \cost    A broad phase over the boxes. One `solid` for each pair of boxes that meet, and one
///          `overlap` with mode `all` where surfaces meet. One `distance` for each other pair that
///          may be near.
/// \threads Any number of callers; pairs are shared by as many threads as `limits` says.
[[nodiscard]] ClashList clashes(std::span<const PartBody> a, std::span<const PartBody> b,
                                const ClashOptions& options = {}, const Limits& limits = {});

/// All clashes among the parts of one set.
[[nodiscard]] ClashList clashes(std::span<const PartBody> parts, const ClashOptions& options = {},
                                const Limits& limits = {});

}  // namespace soms
