#include "soms/query/detail/collector.h"

#include "soms/query/detail/pair_sort.h"

#include <span>

namespace soms::detail {

bool Collector::add_to_few(const TrianglePair& pair) {
  if (mode_ == OverlapMode::first) {
    if (!any_ || pair < least_) {
      least_ = pair;
    }
    any_ = true;
    return false;
  }
  any_ = true;
  if (pairs_->size() - begin_ >= limit_) {
    full_ = true;
    return true;
  }
  pairs_->push_back(pair);
  return mode_ == OverlapMode::any;
}

void Collector::finish() {
  if (mode_ == OverlapMode::first && any_) {
    if (limit_ == 0) {
      full_ = true;
    } else {
      pairs_->push_back(least_);
    }
  }
  sort_pairs(std::span(*pairs_).subspan(begin_));
}

}  // namespace soms::detail
