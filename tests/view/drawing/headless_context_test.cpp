#include "apps/view/drawing/headless_context.h"

#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"

namespace soms::view {
namespace {

TEST(HeadlessContext, IsMadeAgainAfterItsEnd) {
  SOMS_NEEDS_GL(drawing);
  drawing.renderer.reset();
  drawing.context.reset();
  const HeadlessContext again;
  GlRenderer renderer;
  renderer.draw({}, {}, {8, 8});
  EXPECT_FALSE(GlRenderer::device().empty());
}

TEST(HeadlessContext, SaysWhatIsMissing) {
  const test_drawing::Drawing drawing;
  if (drawing.renderer) {
    EXPECT_TRUE(drawing.missing.empty());
  } else {
    EXPECT_NE(drawing.missing.find("; "), std::string::npos) << "place, then remedy";
  }
}

}  // namespace
}  // namespace soms::view
