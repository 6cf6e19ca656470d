#include "soms/base/error.h"

#include "apps/view/drawing/picture_file.h"
#include "tests/support/support.h"
#include "tests/view/pictures.h"

#include <fstream>
#include <stop_token>
#include <vector>

namespace soms::view {
namespace {

Picture noise(Rng& rng, Size size, bool opaque) {
  Picture picture = filled(size, {0, 0, 0, 255});
  for (std::size_t i = 0; i < picture.bytes.size(); ++i) {
    if (i % 4 != 3 || !opaque) {
      picture.bytes[i] = static_cast<std::uint8_t>(rng.below(256));
    }
  }
  return picture;
}

TEST(Picture, ComesBackFromItsFile) {
  test::for_each_case("picture/png", 20, [](Rng& rng) {
    const Size size{static_cast<int>(1 + rng.below(40)), static_cast<int>(1 + rng.below(40))};
    const Picture picture = noise(rng, size, rng.below(2) == 0);
    EXPECT_EQ(from_png(to_png(picture)), picture);
  });
}

TEST(Picture, TellsHowFarItIsWrittenAndStopsWhenRequested) {
  const Picture picture = filled({5, 4}, {1, 2, 3, 255});
  std::vector<double> shares;
  EXPECT_EQ(to_png(picture, {.progress = [&](double share) { shares.push_back(share); }}),
            to_png(picture));
  EXPECT_EQ(shares, (std::vector{0.25, 0.5, 0.75, 1.0}));
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)to_png(picture, {.stop = source.get_token()}), Error);
}

TEST(Picture, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const Picture picture = filled({3, 2}, {1, 2, 3, 255});
  write_png(picture, folder.path() / "a.png");
  EXPECT_EQ(read_png(folder.path() / "a.png"), picture);
  EXPECT_THROW(write_png(picture, folder.path() / "missing" / "a.png"), Error);
  EXPECT_THROW(write_png(picture, folder.path()), Error);
  EXPECT_THROW(write_png(Picture{}, folder.path() / "b.png"), Error);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
  }
  EXPECT_EQ(files, 1U) << "nothing half written stays behind";
}

TEST(Picture, CountsColorsAndDifferences) {
  const Picture a = filled({4, 4}, {10, 20, 30, 255});
  EXPECT_EQ(count_near(a, {12, 18, 30, 255}, 2), 16U);
  EXPECT_EQ(count_near(a, {13, 18, 30, 255}, 2), 0U);
  Picture b = a;
  b.bytes[0] = 20;
  EXPECT_EQ(difference(a, b, 5).beyond, 1U);
  EXPECT_NEAR(difference(a, b, 5).mean, 10.0 / 64, 1e-12);
  EXPECT_EQ(b.at(0, 0), (Color{20, 20, 30, 255}));
  EXPECT_EQ(b.at(3, 3), (Color{10, 20, 30, 255}));
}

}  // namespace
}  // namespace soms::view
