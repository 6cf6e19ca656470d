/// \file
/// The questions about a body and a point, or a ray: a row each, as `query_table.h` has them of two
/// bodies.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"

#include "tests/support/truth/answer_row.h"

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace soms::test {

/// A question about a body and a `Probe`, which is Vec3 or Ray.
template <class Probe>
struct ProbeRow : AnswerRow {
  /// A query takes one thread.
  Answer (*ask)(const Body& body, const Probe& probe, const RowOptions& options) = nullptr;
  BatchAnswer (*ask_batch)(const Body& body, std::span<const Probe> probes,
                           const RowOptions& options, const Limits& limits) = nullptr;

  /// What is promised of the answer, by brute force.
  Answer (*twin)(const Body& body, const Probe& probe, const RowOptions& options) = nullptr;

  /// True if what a cut answer says is true, where `truth` is the twin's answer.
  bool (*holds)(const Answer& cut, const Answer& truth) = nullptr;
};

/// All questions about points, and about rays. One that is new gets a row here; those of closed
/// bodies are the last ones.
template <class Probe>
[[nodiscard]] std::span<const ProbeRow<Probe>> probe_table();
template <>
[[nodiscard]] std::span<const ProbeRow<Vec3>> probe_table<Vec3>();
template <>
[[nodiscard]] std::span<const ProbeRow<Ray>> probe_table<Ray>();

/// The rows that this body may be queried for: all if it is closed.
template <class Probe>
[[nodiscard]] std::vector<ProbeRow<Probe>> probe_table(const Body& body) {
  const bool all = is_closed(body);
  std::vector<ProbeRow<Probe>> rows;
  for (const ProbeRow<Probe>& row : probe_table<Probe>()) {
    if (all || !row.of_closed_bodies) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// Points and rays that try a body.
struct Probes {
  std::vector<Vec3> points;
  std::vector<Ray> rays;
};

/// Points on up to `count` triangles spread over a body, where its pose moves them: a corner, a
/// point of an edge and one of the face, the last bit beside the corner, the middle of its box, and
/// points far away. Rays from some of these through others, along the axes, and with a length that
/// just reaches. The same on every machine.
[[nodiscard]] Probes probes_of(const Body& body, std::size_t count);

/// The probes of one kind.
template <class Probe>
[[nodiscard]] const std::vector<Probe>& of_kind(const Probes& probes) {
  if constexpr (std::is_same_v<Probe, Ray>) {
    return probes.rays;
  } else {
    return probes.points;
  }
}

}  // namespace soms::test
