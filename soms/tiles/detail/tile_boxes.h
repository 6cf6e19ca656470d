/// \file
/// Which tiles does a question meet?
#pragma once

#include "soms/scene/detail/box_index.h"
#include "soms/tiles/tile_set.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace soms::detail {

/// The boxes of tiles where the body's pose has moved them.
class TileBoxes {
 public:
  /// Refers to the body. \errors Those of its pose. \cost O(t log t) for t tiles.
  explicit TileBoxes(const TiledBody& body);

  [[nodiscard]] const BoxIndex& boxes() const { return boxes_; }

  [[nodiscard]] const TiledBody& body() const { return *body_; }

  /// The tile as a body, which is open as long as it lives.
  [[nodiscard]] std::shared_ptr<const OpenTile> open(std::size_t tile) const {
    return body_->tiles.open_tile(tile);
  }

 private:
  const TiledBody* body_;
  BoxIndex boxes_;
};

/// Calls `ask(row)` for rows 0 to `count`, shared by threads. Where not all tiles can stay open,
/// rows come tile by tile: `first_tile(row)` says where one begins.
/// \errors Those of `ask`; ErrorKind::cancelled.
void for_each_row(const TileSet& tiles, std::size_t count, const Limits& limits,
                  const std::function<std::uint32_t(std::size_t)>& first_tile,
                  const std::function<void(std::size_t)>& ask);

}  // namespace soms::detail
