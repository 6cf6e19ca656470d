/// \file
/// Tiles that are open: those met last, up to so many bytes.
#pragma once

#include "soms/tiles/tile_set.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace soms::detail {

/// Keeps what was opened as long as it fits. It may be used by many threads at once.
class TileCache {
 public:
  explicit TileCache(std::uint64_t most_bytes) : most_bytes_(most_bytes) {}

  using Opened = std::shared_ptr<const OpenTile>;

  /// The tile, opened by `open` unless it is kept. Two threads may open one tile; one of both is
  /// kept. What does not fit beside it goes, the one that was not met for the longest time first.
  [[nodiscard]] Opened get(std::size_t tile, std::uint64_t bytes,
                           const std::function<Opened()>& open);

  [[nodiscard]] std::uint64_t openings() const;

 private:
  struct Entry {
    std::size_t tile = 0;
    std::uint64_t bytes = 0;
    Opened opened;
  };

  [[nodiscard]] Opened find(std::size_t tile);
  Opened keep(Entry entry);

  mutable std::mutex mutex_;
  std::uint64_t most_bytes_;
  std::uint64_t bytes_ = 0;
  std::uint64_t openings_ = 0;
  std::list<Entry> entries_;  // the one met last first
  std::unordered_map<std::size_t, std::list<Entry>::iterator> places_;
};

}  // namespace soms::detail
