#include "soms/query/self_overlap.h"

#include "soms/query/print.h"

#include "python/src/call.h"
#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/scene/bodies.h"

#include <cstdint>
#include <optional>

namespace soms::python {

namespace {

constexpr const char* kSelfOverlapDoc =
    R"(self_overlap(model, *, by='index', mode='all', limit=None, timeout=None, threads=1, progress=None)

Which triangles of a model cross each other or touch, beyond the corners that they share? Decided
exactly. Triangles with the same corners are listed apart, as duplicates.

model: Shape or Mesh; a Body's pose changes nothing. by: 'index', corners of one vertex, or
'position', those in one place, as of files that repeat vertices. mode: 'all' pairs, 'any' one, or
'first', the least. limit: most pairs. timeout, threads, progress: as for overlap.

Returns SelfOverlap. Raises Error of kind usage.
Cost: typically linear in the triangles and in the answer.)";

py::object query_self_overlap(const py::object& model, const py::object& by, const py::object& mode,
                              std::optional<std::uint64_t> limit, std::optional<double> timeout,
                              int threads, const py::object& progress) {
  SelfOverlapOptions options{.by = enum_of<CommonCorners>(by, "by"),
                             .mode = enum_of<OverlapMode>(mode, "mode")};
  if (limit) {
    options.limit = *limit;
  }
  const BodyArgument body(model, "model", threads);
  return made(run(Work::one, {threads, timeout}, progress, [&](const Limits& limits) {
    return self_overlap(body.get().shape, options, limits);
  }));
}

}  // namespace

void bind_self_overlap(py::module_& module) {
  bind_answer<SelfOverlap>(module);
  def_function(module, "self_overlap", &query_self_overlap, kSelfOverlapDoc,
               with_limits({{"model"},
                            {"by", py::str("index"), true},
                            {"mode", py::str("all"), true},
                            {"limit", py::none(), true}}));
}

}  // namespace soms::python
