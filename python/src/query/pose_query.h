/// \file
/// Queries of two bodies, for one pose or n of them, whose answer is one class or its batch.
#pragma once

#include "soms/tiles/tiled_queries.h"

#include "python/src/call.h"
#include "python/src/objects.h"
#include "python/src/poses.h"
#include "python/src/scene/bodies.h"

#include <pybind11/pybind11.h>

#include <span>

namespace soms::python {

/// `query(limits, a, b)` without poses, else `query(limits, shape of a, poses, b)`.
template <class Query>
py::object answer_poses(const py::object& a, const py::object& b, const py::object& poses,
                        const CallLimits& allowed, const py::object& progress, const Query& query) {
  const BodyArgument mover(a, "a", allowed.threads);
  const BodyArgument fixed(b, "b", allowed.threads);
  if (poses.is_none()) {
    return made(run(Work::one, allowed, progress,
                    [&](const Limits& limits) { return query(limits, mover.get(), fixed.get()); }));
  }
  const Rows<Pose> places = poses_of(poses);
  return made(run(Work::many, allowed, progress, [&](const Limits& limits) {
    return query(limits, mover.get().shape, places.get(), fixed.get());
  }));
}

/// The same where b may be a folder of tiles, which answer batches alone:
/// `query(limits, shape of a, poses, tiles)`.
template <class Query>
py::object answer_poses_or_tiles(const py::object& a, const py::object& b, const py::object& poses,
                                 const CallLimits& allowed, const py::object& progress,
                                 const Query& query) {
  if (!py::isinstance<TileSet>(b)) {
    return answer_poses(a, b, poses, allowed, progress, query);
  }
  const BodyArgument mover(a, "a", allowed.threads);
  const TiledBody fixed{b.cast<TileSet>()};
  if (poses.is_none()) {
    return made(run(Work::many, allowed, progress, [&](const Limits& limits) {
      const Body& body = mover.get();
      return query(limits, body.shape, std::span<const Pose>(&body.pose, 1), fixed).at(0);
    }));
  }
  const Rows<Pose> places = poses_of(poses);
  return made(run(Work::many, allowed, progress, [&](const Limits& limits) {
    return query(limits, mover.get().shape, places.get(), fixed);
  }));
}

}  // namespace soms::python
