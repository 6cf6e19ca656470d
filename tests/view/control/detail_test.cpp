#include "apps/view/control/detail.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::view {
namespace {

constexpr std::uint64_t kCity = 1'000'000;

/// A device: fixed time for filling (by samples) and time for each million triangles.
struct Device {
  double fill = 0;
  double million = 0;

  [[nodiscard]] double ms(const DrawOptions& options, std::uint64_t triangles) const {
    const double pixels = options.scale * options.scale * options.samples;
    return fill * pixels + million * static_cast<double>(triangles) / 1e6;
  }
};

/// Draws frames of a moving city; the options after them.
DrawOptions after_frames(Detail& detail, const Device& device, int frames) {
  for (int i = 0; i < frames; ++i) {
    const DrawOptions options = detail.options(Care::moving, kCity);
    const std::uint64_t drawn = std::min(kCity, options.most_triangles);
    detail.add(device.ms(options, drawn), drawn, options);
  }
  return detail.options(Care::moving, kCity);
}

TEST(Detail, DrawsEverythingBeforeAnyFrameWasTimed) {
  EXPECT_EQ(Detail().options(Care::moving, kCity).most_triangles, DrawOptions::kAll);
  EXPECT_EQ(Detail().options(Care::moving, kCity).samples, DrawOptions{}.samples);
}

TEST(Detail, DrawsEverythingWithSmoothEdgesWhenStillHoweverSlow) {
  Detail detail;
  (void)after_frames(detail, {100, 4000}, 20);
  EXPECT_EQ(detail.options(Care::full, kCity).most_triangles, DrawOptions::kAll);
  EXPECT_EQ(detail.options(Care::full, kCity).samples, DrawOptions{}.samples);
}

TEST(Detail, DrawsEverythingOnAFastDevice) {
  Detail detail;
  const DrawOptions options = after_frames(detail, {0.5, 8}, 20);
  EXPECT_EQ(options.most_triangles, DrawOptions::kAll);
  EXPECT_EQ(options.samples, DrawOptions{}.samples);
}

TEST(Detail, GivesUpSmoothEdgesBeforeTriangles) {
  Detail detail;
  const DrawOptions options = after_frames(detail, {9, 20}, 20);  // 56 ms smooth, 29 without
  EXPECT_EQ(options.most_triangles, DrawOptions::kAll);
  EXPECT_EQ(options.samples, 1);
  EXPECT_FALSE(options.relief || options.shadows);
}

TEST(Detail, SteersToTheGoalWithTrianglesAndStaysThere) {
  for (const Device device : {Device{10, 200}, Device{30, 300}, Device{1, 500}}) {
    Detail detail;
    for (int i = 0; i < 20; ++i) {
      (void)after_frames(detail, device, 1);
    }
    for (int i = 0; i < 20; ++i) {
      const DrawOptions options = after_frames(detail, device, 1);
      EXPECT_EQ(options.samples, 1);
      const double ms = device.ms(options, options.most_triangles);
      EXPECT_NEAR(ms, Detail::kGoalMs, 0.25 * Detail::kGoalMs);
    }
  }
}

TEST(Detail, NeverDrawsLessThanAUsefulCount) {
  Detail detail;
  EXPECT_EQ(after_frames(detail, {500, 5000}, 30).most_triangles, Detail::kLeast);
}

TEST(Detail, GivesUpPixelsLastAndTakesThemBackFirst) {
  Detail detail;
  EXPECT_EQ(after_frames(detail, {10, 500}, 20).scale, 1);
  const DrawOptions coarse = after_frames(detail, {60, 100}, 20);
  EXPECT_EQ(coarse.most_triangles, Detail::kLeast);
  EXPECT_LT(coarse.scale, 0.75);
  EXPECT_EQ(detail.options(Care::whole, kCity).scale, 1);
  EXPECT_EQ(detail.options(Care::full, kCity).scale, 1);
  const DrawOptions free = after_frames(detail, {12, 100}, 1);
  EXPECT_EQ(free.scale, 1);
  EXPECT_EQ(free.most_triangles, Detail::kLeast);
  EXPECT_GT(after_frames(detail, {12, 100}, 3).most_triangles, Detail::kLeast);
}

TEST(Detail, KeepsItsPixelsWhereTheyFit) {
  for (const double fill : {40.0, 50.0, 80.0, 200.0}) {
    Detail detail;
    const DrawOptions before = after_frames(detail, {fill, 100}, 30);
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(after_frames(detail, {fill, 100}, 1).scale, before.scale) << fill;
    }
  }
}

TEST(Detail, ASlowDeviceDrawsAllTrianglesBeforeItDrawsWithCare) {
  Detail detail;
  EXPECT_EQ(detail.next(Care::moving), Care::full);
  (void)after_frames(detail, {100, 4000}, 20);
  EXPECT_EQ(detail.next(Care::moving), Care::whole);
  EXPECT_EQ(detail.next(Care::whole), Care::full);
  EXPECT_EQ(detail.next(Care::full), Care::full);
  const DrawOptions whole = detail.options(Care::whole, kCity);
  EXPECT_EQ(whole.most_triangles, DrawOptions::kAll);
  EXPECT_EQ(whole.samples, 1);
  EXPECT_FALSE(whole.relief || whole.shadows);
}

TEST(Detail, BeginsCoarseAfterALongFrameWithUploadsAndBecomesFine) {
  Detail detail;
  detail.add_with_uploads(Detail::kGoalMs / 2);
  EXPECT_EQ(detail.options(Care::moving, kCity).samples, DrawOptions{}.samples);
  detail.add_with_uploads(10 * Detail::kGoalMs);
  EXPECT_EQ(detail.options(Care::moving, kCity).samples, 1);
  EXPECT_LT(detail.options(Care::moving, kCity).most_triangles, kCity / 4);
  EXPECT_EQ(detail.options(Care::full, kCity).most_triangles, DrawOptions::kAll);
  EXPECT_EQ(after_frames(detail, {0.5, 2}, 30).samples, DrawOptions{}.samples);
}

TEST(Detail, ComesBackWhenTheDeviceIsFreeAgain) {
  Detail detail;
  (void)after_frames(detail, {50, 1000}, 20);
  const DrawOptions options = after_frames(detail, {0.5, 2}, 30);
  EXPECT_EQ(options.most_triangles, DrawOptions::kAll);
  EXPECT_EQ(options.samples, DrawOptions{}.samples);
}

TEST(Detail, BeginsCoarseWhereThereIsMuchToDraw) {
  Detail detail;
  detail.begin(2'000'000);
  const DrawOptions first = detail.options(Care::moving, 2'000'000);
  EXPECT_LT(first.most_triangles, 200'000U);
  EXPECT_EQ(first.samples, 1);
  EXPECT_EQ(detail.next(Care::moving), Care::whole);
  Detail little;
  little.begin(20'000);
  EXPECT_EQ(little.options(Care::moving, 20'000).most_triangles, DrawOptions::kAll);
}

TEST(Detail, GivesUpPixelsWhereNoFewerTrianglesCanBeDrawn) {
  Detail detail;
  detail.begin(2'000'000);
  for (int i = 0; i < 60; ++i) {  // copies of all tiles are more than is granted
    const DrawOptions options = detail.options(Care::moving, 2'000'000);
    detail.add(100 * options.scale, 33'000, options);
  }
  EXPECT_LT(detail.options(Care::moving, 2'000'000).scale, 0.6);
}

}  // namespace
}  // namespace soms::view
