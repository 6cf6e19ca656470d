#include "soms/query/detail/engine/limit.h"

namespace soms::detail {

void Limit::look() {
  spent_ = 0;
  check_stop(*limits_);
  late_ = late_ || limits_->late();
  done_elsewhere_ = done_ != nullptr && done_->load(std::memory_order_relaxed);
}

}  // namespace soms::detail
