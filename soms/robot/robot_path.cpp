#include "soms/robot/robot_path.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/robot/detail/path_query.h"

#include <algorithm>
#include <atomic>
#include <string>

namespace soms {

namespace {

/// Segments that a thread takes at a time.
constexpr std::size_t kSegmentsOfAChunk = 32;

/// The first segment that is not free; later ones are of no interest.
void lower_to(std::atomic<std::size_t>& first, std::size_t segment) {
  std::size_t known = first.load();
  while (segment < known && !first.compare_exchange_weak(known, segment)) {
  }
}

/// Ends a path at the first segment that is not free if that is all that matters.
void finish(const RobotPathOptions& options, RobotPath& path) {
  for (std::size_t k = 0; k < path.segments.size() && !path.blocked; ++k) {
    if (path.segments[k].verdict != ContactVerdict::free) {
      path.blocked = k;
    }
  }
  if (options.first_blocked && path.blocked) {
    path.segments.resize(*path.blocked + 1);
  }
  for (const RobotAnswer& state : path.states) {
    path.cost += state.cost;
  }
  for (const RobotSegment& segment : path.segments) {
    path.cost += segment.cost;
  }
}

}  // namespace

RobotPath robot_path(const RobotModel& model, std::span<const double> states,
                     const RobotPathOptions& options, const Limits& limits) {
  RobotPath path{.states = robot_contacts(model, states, options.states, limits.silent())};
  const PlainArithmetic plain;
  const std::size_t width = model.kinematics().size();
  const detail::RobotChains chains(model.kinematics(), model.base());
  path.segments.resize(path.states.empty() ? 0 : path.states.size() - 1);
  std::atomic<std::size_t> blocked = path.segments.size();
  const auto follow = [&](std::size_t begin, std::size_t end) {
    const PlainArithmetic also_plain;
    detail::PathQuery query(model, chains, limits);
    for (std::size_t k = begin; k < end; ++k) {
      if (options.first_blocked && k > blocked.load()) {
        return;
      }
      try {
        path.segments[k] =
            query.answer(states.subspan(k * width, width), states.subspan((k + 1) * width, width),
                         path.states[k], path.states[k + 1]);
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled) {
          throw;
        }
        throw Error(error.kind(), "segment " + std::to_string(k) + ": " + error.place(),
                    error.remedy());
      }
      if (path.segments[k].verdict != ContactVerdict::free) {
        lower_to(blocked, k);
      }
    }
  };
  for_each_chunk(path.segments.size(), kSegmentsOfAChunk, limits.without_deadline(), follow);
  finish(options, path);
  return path;
}

}  // namespace soms
