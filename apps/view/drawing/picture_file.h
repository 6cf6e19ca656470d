/// \file
/// PNG files of pictures.
#pragma once

#include "soms/base/parallel.h"

#include "apps/draw/picture.h"

#include <filesystem>
#include <string>

namespace soms::view {

using look::Color;
using look::filled;
using look::Picture;
using look::Size;

/// The bytes of a PNG file.
/// \errors ErrorKind::usage for a picture without pixels; ErrorKind::out_of_memory;
///         ErrorKind::cancelled.
[[nodiscard]] std::string to_png(const Picture& picture, const Limits& limits = {});

/// Writes a file that appears whole or not at all.
/// \errors As `to_png`; ErrorKind::cannot_write.
void write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace soms::view
