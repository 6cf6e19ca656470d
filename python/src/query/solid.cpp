#include "soms/query/solid.h"

#include "soms/query/print.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/point_query.h"
#include "python/src/query/pose_query.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kSolidDoc =
    R"(solid(a, b, poses=None, *, timeout=None, threads=1, progress=None)

How do two closed bodies stand to each other: clear, touching, crossing, one in the other, the same?
Decided exactly.

a, b: ClosedBody, or Body, Shape or Mesh, which are checked first each time. poses, timeout, threads,
progress: as for overlap.

Returns Solid, or with poses SolidBatch, where a pose at which a is not closed is undecided. Raises
Error of kind not_closed, and as overlap does.
Cost: that of overlap with mode 'any' and of one contains for each connected part; where bodies touch
of the order of 0.1 ms for each triangle that takes part.)";

/// A body that is given as closed, or checked for the call.
class ClosedArgument {
 public:
  ClosedArgument(const py::object& given, const char* what, int threads)
      : body_(inside<ClosedBody>(given)) {
    if (body_ == nullptr) {
      const BodyArgument body(given, what, threads);
      made_.emplace(run(Work::many, threads, py::none(),
                        [&](const Limits& limits) { return ClosedBody(body.get(), limits); }));
      body_ = &*made_;
    }
  }

  ClosedArgument(const ClosedArgument&) = delete;
  ClosedArgument& operator=(const ClosedArgument&) = delete;

  [[nodiscard]] const ClosedBody& get() const { return *body_; }

 private:
  std::optional<ClosedBody> made_;
  const ClosedBody* body_;
};

/// With poses the mover is checked where it was built, as its own pose plays no part.
py::object at_poses(const py::object& a, const py::object& b, const py::object& poses,
                    const CallLimits& allowed, const py::object& progress) {
  const Rows<Pose> places = poses_of(poses);
  const ClosedArgument fixed(b, "b", allowed.threads);
  const auto answer = [&](const ClosedBody& mover) {
    return made(run(Work::many, allowed, progress, [&](const Limits& limits) {
      return solid(mover, places.get(), fixed.get(), limits);
    }));
  };
  if (const auto* const closed = inside<ClosedBody>(a)) {
    return answer(*closed);
  }
  const BodyArgument body(a, "a", allowed.threads);
  return answer(run(Work::many, allowed.threads, py::none(), [&](const Limits& limits) {
    return ClosedBody(Body(body.get().shape), limits);
  }));
}

py::object query_solid(const py::object& a, const py::object& b, const py::object& poses,
                       std::optional<double> timeout, int threads, const py::object& progress) {
  if (!poses.is_none()) {
    return at_poses(a, b, poses, {threads, timeout}, progress);
  }
  const ClosedArgument first(a, "a", threads);
  const ClosedArgument second(b, "b", threads);
  return made(run(Work::one, {threads, timeout}, progress,
                  [&](const Limits& limits) { return solid(first.get(), second.get(), limits); }));
}

}  // namespace

void bind_solid(py::module_& module) {
  bind_answers_of<Solid>(module);
  def_function(module, "solid", &query_solid, kSolidDoc,
               with_limits({{"a"}, {"b"}, {"poses", py::none()}}));
}

}  // namespace soms::python
