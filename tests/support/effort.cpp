#include "tests/support/effort.h"

#include "soms/base/random.h"

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <vector>

namespace soms::test {

namespace {

double processor_seconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double seconds_of_unit() {
  Rng rng(1);
  std::vector<std::uint64_t> numbers(1'000'000);
  for (std::uint64_t& number : numbers) {
    number = rng.next();
  }
  const double seconds = processor_seconds([&] { std::sort(numbers.begin(), numbers.end()); });
  return std::max(seconds, 1e-3);
}

}  // namespace

double effort_of(const std::function<void()>& work) {
  static const double unit = seconds_of_unit();
  return processor_seconds(work) / unit;
}

}  // namespace soms::test
