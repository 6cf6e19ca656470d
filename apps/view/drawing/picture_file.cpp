#include "apps/view/drawing/picture_file.h"

#include "soms/base/error.h"

#include "apps/output/output.h"
#include "apps/output/png_file.h"

namespace soms::view {

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
