/// \file
/// What the claims about E-Node compare, and on which trips.
#pragma once

#include "thesis/claims/thesis_claims.h"
#include "thesis/races/moved_trip.h"
#include "thesis/run/experiment.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Places in `enode_racers`.
enum class RacerPlace : std::size_t {
  simultaneous,            ///< Larsson's DFS by our reconstruction, by an explicit stack
  simultaneous_recursive,  ///< the same by recursion
  e_node,
  e_node_recursive,
  e_node_chain,
  e_node_chain_recursive,
  e_node_start,  ///< from the last front
  larger,
  e_node_larger,
  e_node_larger_start,
};

/// All that are compared, by place.
[[nodiscard]] std::span<const TripRacer> enode_racers();

/// E-Node in one of its readings against an opponent.
struct Pairing {
  std::string_view e_node;         ///< "family test, both nodes"
  std::string_view opponent;       ///< "Larsson's (simultaneous)"
  std::string_view manner;         ///< "stack / recursion"; empty for counts, where it is the same
  RacerPlace one;                  ///< E-Node
  RacerPlace other;                ///< its opponent
  std::string_view unjudged = {};  ///< why it is shown but not judged; empty if it is judged
};

/// "family test, both nodes, against Larsson's (simultaneous): stack / stack".
[[nodiscard]] std::string reading_of(const Pairing& pairing);

/// The readings that are judged, against Larsson's traversal: family test, descending on, last
/// front; for counts, which are the same by stack and by recursion.
[[nodiscard]] std::span<const Pairing> counted_pairings();

/// The same for times: the reading nearest to the text in all four ways to program both, the others
/// like against like. The start from the last front goes along a list and has no recursive form.
[[nodiscard]] std::span<const Pairing> timed_pairings();

/// What a skeptic asks and is not judged: Ericson's traversal as the opponent, the larger node. By
/// explicit stack.
[[nodiscard]] std::span<const Pairing> pairings_aside();

/// What version 0.1.0 said, that a claim about E-Node does not hold. `reason` is what it left out:
/// it is given if the rows that it judged still say so, else that its numbers were others.
[[nodiscard]] Revision revision_of(std::span<const ClaimRow> rows,
                                   const std::function<bool(const ClaimRow&)>& judged_before,
                                   std::string_view reason);

/// "Against Ericson's ...: ratio of ... from 1.05 to 10.8 (not judged).": the rows of this metric
/// by the reading nearest to the text with the other opponent, in a sentence; empty if there are
/// none.
[[nodiscard]] std::string ericson_words(std::span<const ClaimRow> rows, std::string_view metric);

/// The trees that E-Node is made for by the abstract, and that are judged.
inline constexpr const char* kEnodeRule = "soms";

/// Trips of one kind.
struct TripKind {
  std::string model;  ///< name of the object that moves
  std::string tests;  ///< "orientation tests"
  std::string rule;
  std::vector<Trip> trips = {};

  /// "bunny, orientation tests": the subject of a claim.
  [[nodiscard]] std::string subject() const { return model + ", " + tests; }
};

/// Of each object the four orientation tests on trees of SOMS and spatial median, and both drives
/// through the scenes on trees of SOMS and object median. Trips on which the bodies never come near
/// each other are left out.
struct EnodeTrips {
  std::vector<TripKind> kinds = {};
  std::vector<std::string> remarks = {};  ///< what the models and drives are

  [[nodiscard]] std::size_t trips() const;
};

/// \errors ErrorKind::cancelled.
[[nodiscard]] EnodeTrips enode_trips(const Context& context);

/// "right", or "u_mixed": a trip within its kind.
[[nodiscard]] std::string label_in_kind(const Trip& trip);

/// Rounds that a time of these claims rests on: 100, in a quick run 10.
[[nodiscard]] int enode_rounds(const Context& context);

/// Sums of rounds, trip by trip: round i of the sum is that of all trips.
/// \pre as many rounds in each.
void add_rounds(std::vector<double>& sum, std::span<const double> rounds);

}  // namespace soms::reproduce
