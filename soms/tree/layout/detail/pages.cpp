#include "soms/tree/layout/detail/pages.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace soms::layout::detail {

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;
constexpr std::align_val_t kLine{64};

/// From here on pages of 2 MB pay: at most the last one is not whole, and it is cut into small
/// ones.
bool is_large(std::size_t bytes) {
  return bytes >= 2 * kLargePage;
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  if (!is_large(bytes)) {
    return ::operator new(bytes, kLine);
  }
  void* pages = ::operator new (bytes, std::align_val_t{kLargePage});
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  // Advice only: without large pages the memory is as good, and slower to come by.
  static_cast<void>(madvise(pages, bytes / kLargePage * kLargePage, MADV_HUGEPAGE));
#endif
  return pages;
}

void free_pages(void* pages, std::size_t bytes) noexcept {
  ::operator delete(pages, is_large(bytes) ? std::align_val_t{kLargePage} : kLine);
}

}  // namespace soms::layout::detail
