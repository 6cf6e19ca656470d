#include "apps/view/drawing/gl/gl_target.h"

#include "soms/base/error.h"

#include "apps/view/drawing/gl/gl_objects.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <string>

namespace soms::view {

namespace {

int limit(GLenum what) {
  GLint value = 0;
  glGetIntegerv(what, &value);
  return value;
}

std::string in_text(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

unsigned make_store(Size size, int samples, GLenum format) {
  unsigned id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, size.width,
                                   size.height);
  return id;
}

unsigned make_frame(unsigned color, unsigned depth) {
  unsigned id = 0;
  glGenFramebuffers(1, &id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  if (depth != 0) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  }
  return id;
}

}  // namespace

GlTarget::~GlTarget() {
  release();
  glDeleteFramebuffers(1, &wide_frame_);
  glDeleteRenderbuffers(1, &wide_color_);
}

void GlTarget::release() {
  glDeleteFramebuffers(1, &frame_);
  glDeleteFramebuffers(1, &smooth_frame_);
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
  glDeleteRenderbuffers(1, &smooth_color_);
  glDeleteFramebuffers(1, &depth_frame_);
  glDeleteTextures(1, &depth_texture_);
  frame_ = smooth_frame_ = color_ = depth_ = smooth_color_ = 0;
  depth_frame_ = depth_texture_ = 0;
  size_ = {0, 0};
}

void GlTarget::make(Size size, int samples) {
  color_ = make_store(size, samples, GL_RGBA8);
  depth_ = make_store(size, samples, GL_DEPTH_COMPONENT32F);
  frame_ = make_frame(color_, depth_);
  bool whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (samples > 1) {
    smooth_color_ = make_store(size, 1, GL_RGBA8);
    smooth_frame_ = make_frame(smooth_color_, 0);
    whole = whole && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  const std::string pixels = in_text(size);
  check_device("making a picture of " + pixels);
  if (!whole) {
    throw Error(ErrorKind::cannot_write,
                "OpenGL: the driver has no memory for a picture of " + pixels + " with " +
                    std::to_string(samples) + (samples == 1 ? " sample" : " samples") +
                    " per pixel",
                samples > 1 ? "use one sample (--samples 1), or a smaller --size"
                            : "choose a smaller --size");
  }
}

void GlTarget::begin(Size size, int samples) {
  const int largest = std::min(limit(GL_MAX_RENDERBUFFER_SIZE), 1 << 15);
  if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest) {
    throw Error(ErrorKind::usage, "picture: a size of " + in_text(size),
                "give a width and a height from 1 to " + std::to_string(largest));
  }
  const int possible = std::clamp(samples, 1, std::max(limit(GL_MAX_SAMPLES), 1));
  if (!(size == size_) || possible != samples_) {
    release();
    try {
      make(size, possible);
    } catch (...) {
      release();
      throw;
    }
    size_ = size;
    samples_ = possible;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, size.width, size.height);
}

unsigned GlTarget::depths(GlSlicer& slicer) {
  if (depth_texture_ == 0) {
    glGenTextures(1, &depth_texture_);
    glBindTexture(GL_TEXTURE_2D, depth_texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size_.width, size_.height, 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &depth_frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, depth_frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_texture_, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, depth_frame_);
  slicer.in_bands(size_, [this](int low, int high) {
    glBlitFramebuffer(0, low, size_.width, high, 0, low, size_.width, high, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
  });
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  return depth_texture_;
}

void GlTarget::resume() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, size_.width, size_.height);
}

void GlTarget::make_wide(Size size) {
  if (size == wide_size_) {
    return;
  }
  glDeleteFramebuffers(1, &wide_frame_);
  glDeleteRenderbuffers(1, &wide_color_);
  wide_color_ = make_store(size, 1, GL_RGBA8);
  wide_frame_ = make_frame(wide_color_, 0);
  check_device("making a picture of " + in_text(size));
  wide_size_ = size;
}

unsigned GlTarget::finished_frame() const {
  return wanted_ != size_ ? wide_frame_ : smooth_frame_ != 0 ? smooth_frame_ : frame_;
}

void GlTarget::finish(GlSlicer& slicer, Size wanted) {
  if (smooth_frame_ != 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, smooth_frame_);
    slicer.in_bands(size_, [this](int low, int high) {
      glBlitFramebuffer(0, low, size_.width, high, 0, low, size_.width, high, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    });
  }
  wanted_ = wanted;
  if (wanted != size_) {
    make_wide(wanted);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_frame_ != 0 ? smooth_frame_ : frame_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, wide_frame_);
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, wanted.width, wanted.height,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, finished_frame());
  glViewport(0, 0, wanted.width, wanted.height);
}

void GlTarget::leave() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Picture GlTarget::read(GlSlicer& slicer) const {
  const std::size_t row = std::size_t{4} * static_cast<std::size_t>(wanted_.width);
  Picture picture{wanted_,
                  std::vector<std::uint8_t>(row * static_cast<std::size_t>(wanted_.height))};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, finished_frame());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  slicer.in_bands(wanted_, [&](int low, int high) {
    // OpenGL's first row is the lowest.
    auto upper = picture.bytes.begin() + static_cast<std::ptrdiff_t>(row) * (wanted_.height - high);
    const auto begin = upper;
    auto lower = begin + static_cast<std::ptrdiff_t>(row) * (high - low);
    const auto end = lower;
    glReadPixels(0, low, wanted_.width, high - low, GL_RGBA, GL_UNSIGNED_BYTE, &*begin);
    for (; lower - upper > static_cast<std::ptrdiff_t>(row);
         upper += static_cast<std::ptrdiff_t>(row)) {
      lower -= static_cast<std::ptrdiff_t>(row);
      std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
    }
    for (auto opacity = begin + 3; opacity < end; opacity += 4) {
      *opacity = 255;  // what was drawn translucent has an opaque ground
    }
  });
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  check_device("reading a picture");
  return picture;
}

void GlTarget::present() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, finished_frame());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, wanted_.width, wanted_.height, 0, 0, wanted_.width, wanted_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  leave();
}

}  // namespace soms::view
