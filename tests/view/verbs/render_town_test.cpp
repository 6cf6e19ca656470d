#include "tests/view/pictures.h"
#include "tests/view/verbs/render_support.h"

namespace soms::view {
namespace {

using test_render::render;

/// Shares of a picture.
struct TownShares {
  double houses = 0;  ///< sand
  double streets = 0;
};

TownShares shares_of(const Picture& picture) {
  TownShares shares;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      const Color c = picture.at(x, y);
      shares.houses += c.r > c.b + 14 ? 1 : 0;
      shares.streets += c.r <= c.b + 2 && c.g > 120 && c.g < 212 ? 1 : 0;
    }
  }
  const double pixels = static_cast<double>(picture.size.width) * picture.size.height;
  return {shares.houses / pixels, shares.streets / pixels};
}

// A generated town is what a reader draws first: streets between houses, not specks on a plain.
TEST(RenderTown, ShowsStreetsBetweenHouses) {
  SOMS_NEEDS_EGL();
  const test::TemporaryFolder folder;
  const std::string town = (folder.path() / "town.ply").string();
  const std::string png = (folder.path() / "town.png").string();
  const auto picture = [&](std::vector<std::string> words) {
    words.insert(words.begin(),
                 {SOMS_COMMAND, "generate", "city", "--triangles", "20000", "-o", town});
    EXPECT_EQ(test::run_program(words).status, 0);
    EXPECT_EQ(render({town, "-o", png, "--size", "480x270", "--no-key"}).status, 0);
    return read_png(png);
  };
  const TownShares built = shares_of(picture({}));
  EXPECT_GT(built.houses, 0.15);
  EXPECT_GT(built.streets, 0.1);
  const TownShares specks = shares_of(picture({"--extent", "4000", "--streets", "bare"}));
  EXPECT_LT(specks.houses, 0.03);
}

}  // namespace
}  // namespace soms::view
