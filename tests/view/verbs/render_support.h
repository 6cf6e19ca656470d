/// \file
/// For tests of `soms render`: a run of it, and a folder with a model.
#pragma once

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/io/write_mesh.h"

#include "apps/view/drawing/gl/headless_context.h"
#include "apps/view/drawing/picture_file.h"
#include "tests/support/support.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::view::test_render {

inline bool can_draw() {
  try {
    const HeadlessContext context;
    return true;
  } catch (const Error&) {
    return false;
  }
}

inline test::RunResult render(std::vector<std::string> words) {
  words.insert(words.begin(), {SOMS_VIEW_COMMAND, "render"});
  return test::run_program(words);
}

inline std::size_t count_red(const Picture& picture) {
  std::size_t count = 0;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      const Color c = picture.at(x, y);
      count += c.r > 130 && c.g < 90 && c.b < 90 ? 1U : 0U;
    }
  }
  return count;
}

/// A folder with a ball of 800 triangles and radius about 1.
class BallFolder : public testing::Test {
 protected:
  void SetUp() override {
    ball_ = (folder_.path() / "ball.ply").string();
    write_mesh(ball_, generate_sphere(800), MeshFormat::ply);
    picture_ = (folder_.path() / "out.png").string();
  }

  test::TemporaryFolder folder_;
  std::string ball_;
  std::string picture_;
};

}  // namespace soms::view::test_render

/// Skips a test aloud where nothing can be drawn.
#define SOMS_NEEDS_EGL()                                                      \
  if (!::soms::view::test_render::can_draw()) {                               \
    GTEST_SKIP() << "nothing is drawn here without EGL, so this is untested"; \
  }                                                                           \
  static_assert(true)
