// Drives a fuzzer's target without one: with the files it is given, else with random inputs that
// are the same on every run. `target [-N] [FILE...]`: N random inputs (default 1000).
#include "soms/base/random.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::vector<std::uint8_t>& input) {
  static_cast<void>(LLVMFuzzerTestOneInput(input.data(), input.size()));
}

void run_random(std::uint64_t count) {
  constexpr std::uint64_t kMost = 1500;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    soms::Rng rng(seed);
    std::vector<std::uint8_t> input(rng.below(kMost));
    for (std::uint8_t& byte : input) {
      byte = static_cast<std::uint8_t>(rng.next());
    }
    run(input);
  }
  std::printf("%llu random inputs\n", static_cast<unsigned long long>(count));
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t random = argc > 1 ? 0 : 1000;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.size() > 1 && argument[0] == '-') {
      random = std::strtoull(argument.c_str() + 1, nullptr, 10);
      continue;
    }
    std::ifstream file(argument, std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "%s: cannot be read\n", argument.c_str());
      return 3;
    }
    run({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
  }
  run_random(random);
  return 0;
}
