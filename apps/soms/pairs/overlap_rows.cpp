#include "apps/soms/pairs/overlap_rows.h"

#include <algorithm>
#include <unordered_set>

namespace soms::command {

OverlapRows::OverlapRows(const MeshView& a, const MeshView& b, std::size_t most)
    : a_(a), b_(b), parts_a_(a), parts_b_(b), most_(most), share_(most) {
}

std::vector<PartPair> OverlapRows::parts(const Poses& poses, std::span<const TrianglePair> pairs,
                                         const Limits& limits) const {
  const auto earlier = [this](std::uint32_t part_a, std::uint32_t part_b) {
    const auto at = numbers_.find(part_key(part_a, part_b));
    return at == numbers_.end() ? std::pair(std::uint64_t{0}, Box())
                                : std::pair(rows_[at->second].count, rows_[at->second].box);
  };
  return part_pairs({a_, parts_a_, poses.first}, {b_, parts_b_, poses.second}, pairs, limits,
                    earlier);
}

void OverlapRows::begin_rows(std::uint64_t pose, std::span<const PartPair> parts) {
  std::vector<const PartPair*> added;
  for (const PartPair& part : parts) {
    const auto at = numbers_.find(part_key(part.a, part.b));
    if (at == numbers_.end()) {
      added.push_back(&part);
      continue;
    }
    Row& row = rows_[at->second];
    ++row.poses;
    row.end = pose;
    row.box.grow(part.box);
  }
  std::sort(added.begin(), added.end(),
            [](const PartPair* x, const PartPair* y) { return x->first < y->first; });
  for (const PartPair* part : added) {
    numbers_.emplace(part_key(part->a, part->b), rows_.size());
    rows_.push_back({.part_a = part->a,
                     .part_b = part->b,
                     .poses = 1,
                     .begin = pose,
                     .end = pose,
                     .first = part->first,
                     .box = part->box});
  }
}

void OverlapRows::add(std::uint64_t pose, const Poses& poses, std::span<const TrianglePair> pairs,
                      std::span<const PartPair> parts) {
  begin_rows(pose, parts);
  bool kept = false;
  for (const TrianglePair& pair : pairs) {
    Row& row = rows_[numbers_.at(part_key(parts_a_(pair.a), parts_b_(pair.b)))];
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
