#include "soms/io/detail/mesh_builder.h"

#include "tests/io/files.h"

#include <gtest/gtest.h>

namespace soms::detail {
namespace {

TEST(MeshBuilder, RefusesMoreFacesThanNumbersAreGivenTo) {
  const Limits limits;
  Source source{.bytes = {}, .name = "a.ply", .budget = Budget(1 << 20), .limits = limits};
  MeshBuilder builder(source);
  // An instance may have faces without triangles: as many as would take minutes one by one.
  builder.add_instance({}, 0, static_cast<std::uint32_t>(kMaxPrimitives - 1), false);
  builder.add_face({});
  EXPECT_EQ(builder.face_count(), kMaxPrimitives);
  test::expect_refused([&] { builder.add_face({}); }, ErrorKind::out_of_range,
                       "a.ply: more than 2^31 - 1 faces");
}

}  // namespace
}  // namespace soms::detail
