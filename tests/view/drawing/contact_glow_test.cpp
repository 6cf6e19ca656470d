#include "apps/view/drawing/contact_glow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soms::view {
namespace {

/// A ring about a place, of many pieces.
void add_ring(ContactGlow& glow, const Vec3& center, double radius, double most) {
  constexpr int kPieces = 64;
  const auto at = [&](int k) {
    const double turn = 2 * std::numbers::pi * (k % kPieces) / kPieces;
    return center + Vec3{radius * std::cos(turn), radius * std::sin(turn), 0};
  };
  for (int k = 0; k < kPieces; ++k) {
    glow.add(at(k), at(k + 1), most);
  }
}

double widest(const std::vector<Glow>& glows) {
  double most = 0;
  for (const Glow& glow : glows) {
    most = std::max(most, glow.radius);
  }
  return most;
}

TEST(ContactGlow, ReachesAsFarAsTheRingIsWideWhateverThePartIs) {
  for (const double most : {0.5, 5.0, 500.0}) {
    ContactGlow glow;
    add_ring(glow, {1, 2, 3}, 0.1, most);
    EXPECT_LT(widest(glow.glows()), 0.07) << most;
    EXPECT_GT(widest(glow.glows()), 0.02) << most;
  }
  ContactGlow small;
  add_ring(small, {}, 10, 0.25);
  EXPECT_EQ(widest(small.glows()), 0.25) << "no farther than the part is large";
}

TEST(ContactGlow, OfManyRingsEachHasItsOwn) {
  ContactGlow glow;
  add_ring(glow, {0, 0, 0}, 0.1, 50);
  add_ring(glow, {30, 0, 0}, 0.1, 50);
  add_ring(glow, {0, 30, 0}, 1, 50);
  for (const Glow& each : glow.glows()) {
    const bool large = each.a.y > 20;
    EXPECT_EQ(each.radius > 0.2, large);
  }
}

TEST(ContactGlow, OfALongScratchIsNarrow) {
  ContactGlow glow;
  for (int k = 0; k < 50; ++k) {
    glow.add({1.0 * k, 0, 0}, {1.0 * k + 1, 0, 0}, 4.5);
  }
  EXPECT_GT(widest(glow.glows()), 0);
  EXPECT_LT(widest(glow.glows()), 0.5);
  ContactGlow point;
  point.add({1, 1, 1}, {1, 1, 1}, 4.5);
  ASSERT_EQ(point.glows().size(), 1U);
  EXPECT_GT(point.glows()[0].radius, 0);
}

TEST(ContactGlow, PiecesOfASelectionAreOneByTheirGroup) {
  ContactGlow glow;
  for (int k = 0; k < 8; ++k) {
    const double turn = k * std::numbers::pi / 4;
    const Vec3 at{std::cos(turn), std::sin(turn), 0};
    glow.add(at, at + Vec3{0, 0, 1e-3}, 50, 7);
  }
  EXPECT_GT(widest(glow.glows()), 0.4);
}

}  // namespace
}  // namespace soms::view
