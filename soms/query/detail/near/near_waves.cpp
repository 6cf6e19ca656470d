#include "soms/query/detail/near/near_waves.h"

#include "soms/base/parallel.h"
#include "soms/query/detail/engine/limit.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

namespace {

constexpr std::size_t kParts = 16;         // of a wave
constexpr std::size_t kPairs = 8;          // that a part begins with, at most
constexpr std::uint64_t kPartSteps = 512;  // of up to four pairs each

}  // namespace

template <class Source>
struct NearWaves<Source>::Part {
  NearMemory memory;
  std::vector<KeyedPair> begin;
  std::optional<NearPose> pose;
  std::unique_ptr<NearGoal> goal;
  std::optional<NearTraversal<Source>> traversal;
  bool late = false;
};

template <class Source>
NearWaves<Source>::NearWaves(const PairFrame& frame, const NearPose& pose, const NearGoal& goal)
    : frame_(frame), pose_(pose), goal_(goal) {
}

template <class Source>
NearWaves<Source>::~NearWaves() = default;

template <class Source>
void NearWaves<Source>::run(NearTraversal<Source>& whole, const Limits& limits) {
  while (wave(whole, limits)) {
  }
}

template <class Source>
bool NearWaves<Source>::wave(NearTraversal<Source>& whole, const Limits& limits) {
  given_.clear();
  whole.give(kParts * kPairs, given_);
  const std::size_t count = std::min(kParts, given_.size());
  if (count == 0) {
    whole.finish();
    return false;
  }
  while (parts_.size() < count) {
    parts_.push_back(std::make_unique<Part>());
  }
  for (std::size_t i = 0; i < count; ++i) {
    parts_[i]->begin.clear();
  }
  for (std::size_t i = 0; i < given_.size(); ++i) {
    parts_[i % count]->begin.push_back(given_[i]);
  }
  // Parts after the first that ended the query need not be looked at.
  std::atomic<std::size_t> over = count;
  const Limits quiet = limits.silent();
  for_each_chunk(count, 1, quiet.without_deadline(), [&](std::size_t i, std::size_t) {
    if (i > over) {
      return;
    }
    Part& part = *parts_[i];
    Limit limit(quiet);
    part.pose.emplace(pose_);
    part.goal = goal_.for_part();
    part.traversal.emplace(frame_, *part.pose, *part.goal, part.memory);
    part.traversal->start_part(whole, part.begin);
    const bool ended = part.traversal->run(limit, kPartSteps);
    part.late = ended && !part.traversal->complete();
    if (!ended) {
      part.traversal->settle_part();
    }
    std::size_t first = over;
    while (part.goal->over() && i < first && !over.compare_exchange_weak(first, i)) {
    }
  });
  bool late = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (whole.take(*parts_[i]->traversal)) {
      return false;
    }
    late = late || parts_[i]->late;
  }
  return !late;
}

template class NearWaves<WideSource>;
template class NearWaves<CompactSource>;

}  // namespace soms::detail
