#include "soms/tiles/detail/tile_boxes.h"

#include "soms/base/parallel.h"
#include "soms/motion/detail/moved_bounds.h"

#include <algorithm>
#include <numeric>

namespace soms::detail {

namespace {

constexpr std::size_t kRowsOfChunk = 64;

}  // namespace

TileBoxes::TileBoxes(const TiledBody& body) : body_(&body) {
  check(body.pose);
  check_range(body.pose, body.tiles.bounds());
  std::vector<Box> boxes;
  for (const Tile& tile : body.tiles.tiles()) {
    boxes.push_back(moved_bounds(body.pose, tile.bounds));
  }
  boxes_.build(boxes);
}

void for_each_row(const TileSet& tiles, std::size_t count, const Limits& limits,
                  const std::function<std::uint32_t(std::size_t)>& first_tile,
                  const std::function<void(std::size_t)>& ask) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (tiles.bytes() > tiles.options().max_memory) {
    std::vector<std::uint32_t> tile(count);
    std::transform(order.begin(), order.end(), tile.begin(), first_tile);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return tile[a] < tile[b]; });
  }
  for_each_chunk(count, kRowsOfChunk, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t k = begin; k < end; ++k) {
                     ask(order[k]);
                   }
                 });
}

}  // namespace soms::detail
