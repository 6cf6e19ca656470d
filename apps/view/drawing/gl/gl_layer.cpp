#include "apps/view/drawing/gl/gl_layer.h"

#include "apps/view/drawing/gl/gl_objects.h"

#include <epoxy/gl.h>

namespace soms::view {

GlLayer::~GlLayer() {
  glDeleteFramebuffers(1, &frame_);
  glDeleteTextures(1, &texture_);
}

void GlLayer::begin(Size size) {
  if (texture_ == 0) {
    glGenTextures(1, &texture_);
    glGenFramebuffers(1, &frame_);
  }
  if (size_ != size) {
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, size.width, size.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    check_device("making a layer of the picture");
    size_ = size;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, size.width, size.height);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace soms::view
