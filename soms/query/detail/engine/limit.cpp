#include "soms/query/detail/engine/limit.h"

namespace soms::detail {

void Limit::look() {
  spent_ = 0;
  check_stop(*parallel_);
  late_ = late_ || (deadline_ && std::chrono::steady_clock::now() >= *deadline_);
  done_elsewhere_ = done_ != nullptr && done_->load(std::memory_order_relaxed);
}

}  // namespace soms::detail
