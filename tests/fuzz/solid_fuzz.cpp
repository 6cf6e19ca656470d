// Two closed meshes of awkward numbers at awkward poses, by any rule in either layout: against
// brute force, exchanged, in batches and by two threads. Meshes that lack triangles are refused.
#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/query/reference/solid.h"
#include "soms/query/solid.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/closed_mesh.h"
#include "tests/fuzz/poses.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scales.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using fuzz::Bytes;
using fuzz::require;

Relation the_other_way(Relation relation) {
  return relation == Relation::a_in_b   ? Relation::b_in_a
         : relation == Relation::b_in_a ? Relation::a_in_b
                                        : relation;
}

bool is_closed(const Body& body) {
  return closedness(body.shape.mesh(), {.pose = body.pose}).whole.closed;
}

Body body_of(Bytes& bytes, double unit) {
  const Mesh mesh = fuzz::closed_mesh(bytes, unit);
  const Pose pose = bytes.below(2) == 0 ? Pose{} : fuzz::pose_of(bytes, unit);
  return Body(Shape(mesh, fuzz::shape_options(bytes)), pose);
}

void check_relation(const Body& a, const Body& b) {
  const Solid answer = solid(a, b);
  const Solid truth = reference::solid_by_brute_force(a, b);
  require(answer.relation == truth.relation, "a relation");
  require(answer.surfaces_meet == truth.surfaces_meet, "whether surfaces meet");
  require(answer.why == Undecided::none, "undecided");
  require(solid(b, a).relation == the_other_way(answer.relation), "the other way round");
  if (is_closed(Body(a.shape))) {
    const std::vector<Pose> poses(3, a.pose);
    require(solid(a.shape, poses, b, {.threads = 2}).at(2) == answer, "a batch");
  }
}

void check_input(Bytes& bytes) {
  const double unit = fuzz::unit_of(bytes);
  const Body a = body_of(bytes, unit);
  const Body b = bytes.below(8) == 0 ? Body(a.shape, a.pose) : body_of(bytes, unit);
  const bool closed = is_closed(a) && is_closed(b);
  try {
    check_relation(a, b);
    require(closed, "an open body");
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::not_closed && !closed, "a closed body");
  }
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::fuzz::Bytes bytes({data, size});
  soms::check_input(bytes);
  return 0;
}
