#include "apps/view/drawing/picture.h"

#include "soms/base/error.h"

#include "apps/output/output.h"
#include "apps/output/png_file.h"

namespace soms::view {

Color Picture::at(int x, int y) const {
  const auto i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                      static_cast<std::size_t>(x));
  return {bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]};
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

std::string to_png(const Picture& picture, const Limits& limits) {
  if (picture.size.width < 1 || picture.size.height < 1) {
    throw Error(ErrorKind::usage, "picture: it has no pixels", "draw a frame before writing it");
  }
  const auto height = static_cast<std::size_t>(picture.size.height);
  return command::png_bytes(
      static_cast<std::size_t>(picture.size.width), height, picture.bytes, [&](std::size_t rows) {
        check_stop(limits);
        if (limits.progress) {
          limits.progress(static_cast<double>(rows) / static_cast<double>(height));
        }
      });
}

void write_png(const Picture& picture, const std::filesystem::path& path) {
  command::OutputFile file(path);
  file.stream() << to_png(picture);
  file.commit();
}

}  // namespace soms::view
