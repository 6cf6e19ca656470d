#include "apps/view/drawing/markers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace soms::view {
namespace {

constexpr Size kPicture{320, 180};

Camera from_south(double distance) {
  return {{0, -distance, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
}

std::uint64_t sum(const std::vector<PlacedMarker>& placed) {
  return std::accumulate(
      placed.begin(), placed.end(), std::uint64_t{0},
      [](std::uint64_t all, const PlacedMarker& marker) { return all + marker.count; });
}

TEST(Markers, StandWhereWhatTheyMarkIsSmall) {
  const std::vector<Marker> one{{.at = {1, 0, 0}, .reach = 0.1}};
  // A pixel at distance d is 0.0047 d wide.
  EXPECT_TRUE(place_markers(one, from_south(2), kPicture).empty());
  const auto far = place_markers(one, from_south(20), kPicture);
  ASSERT_EQ(far.size(), 1U);
  const auto seen = project(from_south(20), kPicture, {1, 0, 0});
  EXPECT_NEAR(far[0].at.x, seen->pixel.x, 1e-9);
  EXPECT_NEAR(far[0].at.y, seen->pixel.y, 1e-9);
  const std::vector<Marker> always{{.at = {0, 0, 0}, .reach = 0.1, .always = true}};
  EXPECT_EQ(place_markers(always, from_south(2), kPicture).size(), 1U);
}

TEST(Markers, ThoseOutsideThePictureAreLeftOut) {
  const std::vector<Marker> outside{{.at = {100, 0, 0}}, {.at = {0, -30, 0}}, {.at = {0, 0, -99}}};
  EXPECT_TRUE(place_markers(outside, from_south(20), kPicture).empty());
}

TEST(Markers, NeighborsBecomeOneWithTheSumAndTheSumIsKept) {
  std::vector<Marker> many;
  for (int k = 0; k < 60; ++k) {
    many.push_back({.at = {0.11 * (k % 30) - 1.6, 0, 0.1 * (k / 30)},
                    .count = static_cast<std::uint32_t>(1 + k % 3)});
  }
  std::uint64_t all = 0;
  for (const Marker& marker : many) {
    all += marker.count;
  }
  std::size_t last = 61;
  for (const double distance : {3.0, 10.0, 40.0, 4000.0}) {
    const auto placed = place_markers(many, from_south(distance), kPicture);
    if (distance > 4) {
      EXPECT_EQ(sum(placed), all) << distance;
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GE(std::hypot(placed[i].at.x - placed[k].at.x, placed[i].at.y - placed[k].at.y),
                  kMarkersApart);
      }
    }
    EXPECT_LE(placed.size(), last);
    last = placed.size();
  }
  EXPECT_EQ(last, 1U);
}

}  // namespace
}  // namespace soms::view
