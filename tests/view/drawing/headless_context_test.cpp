#include "apps/view/drawing/gl/headless_context.h"

#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"

#include <epoxy/egl.h>

#include <string>
#include <utility>

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

PFNEGLCREATECONTEXTPROC made_by = nullptr;
int refused = 0;
int passed_on = 0;

/// A driver without OpenGL 3.3 for the first display, then the real one.
EGLContext refuse_once(EGLDisplay display, EGLConfig config, EGLContext share,
                       const EGLint* words) {
  if (refused == 0) {
    ++refused;
    return EGL_NO_CONTEXT;
  }
  ++passed_on;
  return made_by(display, config, share, words);
}

TEST(HeadlessContext, TriesTheNextDisplayWhereOneOffersTooLittle) {
  SOMS_NEEDS_GL(drawing);
  drawing.renderer.reset();
  drawing.context.reset();
  made_by = std::exchange(epoxy_eglCreateContext, refuse_once);
  try {
    const HeadlessContext next;
    EXPECT_FALSE(GlRenderer::device().empty());
    EXPECT_GE(passed_on, 1);
  } catch (const Error& error) {
    EXPECT_EQ(passed_on, 0) << error.what();  // there is one display here
    EXPECT_NE(error.place().find("OpenGL 3.3"), std::string::npos);
  }
  EXPECT_EQ(refused, 1);
  epoxy_eglCreateContext = made_by;
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
