#include "soms/geometry/detail/counts.h"

#include "soms/base/error.h"
#include "soms/geometry/mesh.h"

#include <gtest/gtest.h>

#include <string>

namespace soms {
namespace {

TEST(Counts, BeyondTheLimitAreRefusedBeforeAnythingIsAllocated) {
  EXPECT_NO_THROW(check_counts(kMaxPrimitives, kMaxPrimitives, "city.ply"));
  const auto refused = [](std::uint64_t vertices, std::uint64_t triangles) {
    try {
      check_counts(vertices, triangles, "city.ply");
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("city.ply"), std::string::npos);
      return error.kind() == ErrorKind::out_of_range;
    }
    return false;
  };
  EXPECT_TRUE(refused(0, std::uint64_t{1} << 31));
  EXPECT_TRUE(refused(std::uint64_t{1} << 31, 0));
  EXPECT_TRUE(refused(0, ~std::uint64_t{0}));
}

}  // namespace
}  // namespace soms
