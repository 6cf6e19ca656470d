#include "apps/draw/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::look {

namespace {

std::size_t byte_of(const Picture& picture, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
              static_cast<std::size_t>(x));
}

}  // namespace

Color mixed(Color from, Color to, double share) {
  const auto mix = [share](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
  };
  return {mix(from.r, to.r), mix(from.g, to.g), mix(from.b, to.b), from.a};
}

Color lit(Color color, double light) {
  const auto part = [light](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::lround(std::min(value * light, 255.0)));
  };
  return {part(color.r), part(color.g), part(color.b), color.a};
}

Color mean_of(std::span<const Color> samples) {
  std::array<std::size_t, 3> sum{};
  for (const Color& c : samples) {
    sum[0] += c.r;
    sum[1] += c.g;
    sum[2] += c.b;
  }
  const auto mean = [count = samples.size()](std::size_t of) {
    return static_cast<std::uint8_t>((of + count / 2) / count);
  };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2]), 255};
}

Color Picture::at(int x, int y) const {
  const std::size_t i = byte_of(*this, x, y);
  return {bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]};
}

void Picture::put(int x, int y, Color color) {
  const std::size_t i = byte_of(*this, x, y);
  bytes[i] = color.r;
  bytes[i + 1] = color.g;
  bytes[i + 2] = color.b;
  bytes[i + 3] = color.a;
}

Picture filled(Size size, Color color) {
  Picture picture{size, {}};
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  picture.bytes.reserve(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    picture.bytes.insert(picture.bytes.end(), {color.r, color.g, color.b, color.a});
  }
  return picture;
}

}  // namespace soms::look
