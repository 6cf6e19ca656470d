/// \file
/// What E-Node might be, by the words of the thesis, and what each reading does on a trip.
#pragma once

#include "soms/base/limits.h"

#include "thesis/races/moved_trip.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// What a reading answers.
enum class EnodeAnswer {
  all_pairs,      ///< all pairs of leaves whose boxes overlap, whose triangles are then tested
  first_leaves,   ///< whether boxes of two leaves overlap: stops at the first such pair
  first_contact,  ///< whether triangles touch: stops at the first pair that does
  boxes_only,     ///< pairs of nodes of an earlier level whose boxes overlap; no triangle test
};

/// A reading of E-Node.
struct EnodeReading {
  std::string_view name;  ///< as in the tables: "family_both"
  std::string_view title;
  std::string_view speaks_for;      ///< quotation, with its place
  std::string_view speaks_against;  ///< quotation, with its place, or what is missing
  std::string_view stands;          ///< "taken", "open", "against", "excluded by words"
  EnodeAnswer answer = EnodeAnswer::all_pairs;
  TraversalOptions options = {.traversal = Traversal::e_node};
  bool chain = false;  ///< `e_node_chain`
};

/// All readings; the first is the one that is taken.
/// \source ours. The thesis has the name, captions and headings.
[[nodiscard]] std::span<const EnodeReading> e_node_readings();

/// The level at which the reading without leaves stops where one level is shown.
/// \source thesis, figure 5.5 by its caption: "level 7 (SOMS Balanced BVH)".
inline constexpr int kEarlierLevel = 7;

/// Work of a traversal.
struct EnodeWork {
  std::uint64_t box_tests = 0;
  std::uint64_t entered = 0;
  std::uint64_t leaf_pairs = 0;
  std::uint64_t triangle_pairs = 0;  ///< in those pairs of leaves

  EnodeWork& operator+=(const EnodeWork& other);
};

/// Work up to the first hit of a frame, summed over frames.
struct FirstHit {
  EnodeWork to_hit = {};                 ///< over the frames that have a hit
  EnodeWork stopping = {};               ///< over all frames: of a query that stops at its hit
  std::vector<std::size_t> frames = {};  ///< those with a hit, in order

  FirstHit& operator+=(const FirstHit& other);
};

/// Work on a trip.
struct EnodeTripWork {
  EnodeWork whole = {};
  FirstHit leaves = {};   ///< up to the first overlapping leaves
  FirstHit contact = {};  ///< up to the first triangles that touch

  EnodeTripWork& operator+=(const EnodeTripWork& other);
};

/// Traverses all frames of a trip to their ends, as a reading that answers all pairs. Up to a hit a
/// traversal from a fresh start does the same as one that stops there; from the last front it goes
/// on from whole frames. \errors ErrorKind::cancelled.
[[nodiscard]] EnodeTripWork e_node_work(const MovedTrip& moved, const EnodeReading& reading,
                                        const Limits& limits);

}  // namespace soms::reproduce
