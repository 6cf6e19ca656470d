#include "apps/view/drawing/gl/gl_slicer.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace soms::view {

namespace {

/// What llvmpipe draws in some 50 ms on one core.
constexpr std::uint64_t kTriangles = 100'000;
constexpr int kPixels = 1'000'000;
/// Passes over the picture: background, depths, hidden sky, finish, samples and reading.
constexpr double kPasses = 6;

}  // namespace

void GlSlicer::watch(const Limits& limits) {
  limits_ = limits;
  watched_ = limits.stop.stop_possible() || limits.progress != nullptr;
}

void GlSlicer::begin(std::uint64_t triangles, Size size) {
  done_ = 0;
  all_ = static_cast<double>(triangles) + kPasses * size.width * size.height;
}

std::size_t GlSlicer::copies(std::size_t all, std::uint64_t triangles) const {
  if (!watched_) {
    return all;
  }
  const std::uint64_t some = kTriangles / std::max<std::uint64_t>(triangles, 1);
  return std::clamp<std::size_t>(some, 1, std::max<std::size_t>(all, 1));
}

void GlSlicer::drawn(std::uint64_t triangles) {
  done_ += static_cast<double>(triangles);
  if (watched_) {
    wait();
  }
}

void GlSlicer::in_bands(Size size, const std::function<void(int low, int high)>& draw) {
  const int rows = watched_ ? std::max(1, kPixels / size.width) : size.height;
  for (int low = 0; low < size.height; low += rows) {
    const int high = std::min(size.height, low + rows);
    draw(low, high);
    drawn(static_cast<std::uint64_t>(high - low) * static_cast<std::uint64_t>(size.width));
  }
}

void GlSlicer::wait() {
  glFinish();
  check_stop(limits_);
  if (limits_.progress) {
    limits_.progress(std::min(1.0, done_ / all_));
  }
}

Band::Band(Size size, int low, int high) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, low, size.width, high - low);
}

Band::~Band() {
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace soms::view
