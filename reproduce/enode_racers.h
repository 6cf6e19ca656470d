/// \file
/// What the claims about E-Node compare, and on which trips.
#pragma once

#include "reproduce/claim.h"
#include "reproduce/experiment.h"
#include "reproduce/moved_trip.h"

#include <cstddef>
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
  e_node_start,  ///< from the last front
  larger,
  larger_recursive,
  e_node_larger,
  e_node_larger_recursive,
  e_node_larger_start,
};

/// All that are compared, by place.
[[nodiscard]] std::span<const Racer> enode_racers();

/// E-Node in one of its readings, and the traversal that descends the same nodes.
struct Pairing {
  std::string_view reading;
  RacerPlace one;    ///< E-Node
  RacerPlace other;  ///< its opponent
  /// What E-Node tests is that of an earlier pairing by construction; only the pairs entered
  /// differ.
  bool same_tests = false;
};

/// Pairings for counts, which are the same by stack and by recursion.
[[nodiscard]] std::span<const Pairing> counted_pairings();

/// Pairings for times.
[[nodiscard]] std::span<const Pairing> timed_pairings();

/// Trips of one kind.
struct TripKind {
  std::string name;  ///< "orientation tests, SOMS trees"
  std::string tests;
  std::string rule;
  std::vector<Trip> trips = {};
};

/// The orientation tests right, left and top of the first object on trees of SOMS and spatial
/// median; both drives through the scenes on trees of SOMS and object median. Trips on which the
/// bodies never come near each other are left out.
struct EnodeTrips {
  std::vector<TripKind> kinds = {};
  std::vector<std::string> remarks = {};  ///< what the models and drives are

  [[nodiscard]] std::size_t trips() const;
};

/// \errors ErrorKind::cancelled.
[[nodiscard]] EnodeTrips enode_trips(const Context& context);

/// "right", or "u_mixed": a trip within its kind.
[[nodiscard]] std::string label_in_kind(const Trip& trip);

/// Rounds that a time of these claims rests on: 100, in a quick run 20.
[[nodiscard]] int enode_rounds(const Context& context);

/// Sums of rounds, trip by trip: round i of the sum is that of all trips.
/// \pre as many rounds in each.
void add_rounds(std::vector<double>& sum, std::span<const double> rounds);

}  // namespace soms::reproduce
