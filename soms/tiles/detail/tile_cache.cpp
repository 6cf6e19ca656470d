#include "soms/tiles/detail/tile_cache.h"

#include <iterator>
#include <utility>

namespace soms::detail {

TileCache::Opened TileCache::get(std::size_t tile, std::uint64_t bytes,
                                 const std::function<Opened()>& open) {
  if (Opened opened = find(tile)) {
    return opened;
  }
  return keep({tile, bytes, open()});
}

TileCache::Opened TileCache::find(std::size_t tile) {
  const std::scoped_lock lock(mutex_);
  const auto at = places_.find(tile);
  if (at == places_.end()) {
    return nullptr;
  }
  entries_.splice(entries_.begin(), entries_, at->second);
  return at->second->opened;
}

TileCache::Opened TileCache::keep(Entry entry) {
  std::list<Entry> gone;  // unmapped without the lock
  const std::scoped_lock lock(mutex_);
  ++openings_;
  const auto at = places_.find(entry.tile);
  if (at != places_.end()) {
    return at->second->opened;
  }
  bytes_ += entry.bytes;
  const std::size_t tile = entry.tile;
  entries_.push_front(std::move(entry));
  places_[tile] = entries_.begin();
  while (bytes_ > most_bytes_ && entries_.size() > 1) {
    bytes_ -= entries_.back().bytes;
    places_.erase(entries_.back().tile);
    gone.splice(gone.begin(), entries_, std::prev(entries_.end()));
  }
  return entries_.front().opened;
}

std::uint64_t TileCache::openings() const {
  const std::scoped_lock lock(mutex_);
  return openings_;
}

}  // namespace soms::detail
