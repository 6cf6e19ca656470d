#include "apps/soms/overlap_rows.h"

#include "apps/soms/overlap_parts.h"

#include <algorithm>
#include <unordered_set>

namespace soms::command {

OverlapRows::OverlapRows(const Mesh& a, const Mesh& b, std::size_t most)
    : a_(a), b_(b), parts_a_(a), parts_b_(b), most_(most), share_(most) {
}

OverlapRows::Row& OverlapRows::row_of(const TrianglePair& pair) {
  const std::uint32_t part_a = parts_a_(pair.first);
  const std::uint32_t part_b = parts_b_(pair.second);
  const std::uint64_t key = (std::uint64_t{part_a} << 32) | part_b;
  const auto [at, added] = numbers_.try_emplace(key, rows_.size());
  if (added) {
    Row& row = rows_.emplace_back();
    row.part_a = part_a;
    row.part_b = part_b;
  }
  return rows_[at->second];
}

void OverlapRows::add(std::uint64_t pose, const Poses& poses, std::span<const TrianglePair> pairs) {
  const PosedParts a{a_, parts_a_, poses.first};
  const PosedParts b{b_, parts_b_, poses.second};
  bool kept = false;
  for (const TrianglePair& pair : pairs) {
    Row& row = row_of(pair);
    if (row.count == 0) {
      row.begin = pose;
      row.first = pair;
    }
    row.poses += row.count == 0 || row.end != pose ? 1U : 0U;
    row.end = pose;
    grow_by_contact(row.box, row.count, a.triangle(pair.first), b.triangle(pair.second));
    kept = keep(row, pose, pair) || kept;
    ++row.count;
  }
  if (kept) {
    placed_[pose] = poses;
    if (placed_.size() > 2 * most_) {
      drop_unused_poses();
    }
  }
}

/// True if the pair was kept, perhaps not for long.
bool OverlapRows::keep(Row& row, std::uint64_t pose, const TrianglePair& pair) {
  if (row.pause == 0 || row.count % row.pause != 0) {
    return false;
  }
  row.samples.push_back({pose, pair});
  ++held_;
  while (row.samples.size() > share_) {
    halve(row);
  }
  if (held_ > most_) {
    thin_out();
  }
  if (held_ > most_) {  // more rows than samples: this one gets none
    row.samples.clear();
    row.pause = 0;
    --held_;
  }
  return row.pause != 0;
}

/// Drops every other sample; the first stays.
void OverlapRows::halve(Row& row) {
  std::vector<Sample>& samples = row.samples;
  const std::size_t left = (samples.size() + 1) / 2;
  for (std::size_t k = 0; k < left; ++k) {
    samples[k] = samples[2 * k];
  }
  held_ -= samples.size() - left;
  samples.resize(left);
  row.pause *= 2;
}

void OverlapRows::thin_out() {
  while (held_ > most_ && share_ > 1) {
    share_ /= 2;
    for (Row& row : rows_) {
      while (row.samples.size() > share_) {
        halve(row);
      }
    }
  }
}

void OverlapRows::drop_unused_poses() {
  std::unordered_set<std::uint64_t> used;
  for (const Row& row : rows_) {
    for (const Sample& sample : row.samples) {
      used.insert(sample.pose);
    }
  }
  std::erase_if(placed_, [&](const auto& entry) { return !used.contains(entry.first); });
}

}  // namespace soms::command
