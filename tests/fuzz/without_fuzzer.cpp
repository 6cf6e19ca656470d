// Drives a fuzzer's target without one: `target [-N] [FILE...]` runs the files, then N inputs
// (default 1000) that are the same on every run: changed files, or random bytes where none is
// named.
#include "soms/base/random.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;

void run(const Input& input) {
  static_cast<void>(LLVMFuzzerTestOneInput(input.data(), input.size()));
}

Input random_input(soms::Rng& rng) {
  constexpr std::uint64_t kMost = 1500;
  Input input(rng.below(kMost));
  for (std::uint8_t& byte : input) {
    byte = static_cast<std::uint8_t>(rng.next());
  }
  return input;
}

/// A few bytes replaced, flipped, left out or doubled; now and then the end cut off.
Input changed(Input input, soms::Rng& rng) {
  for (std::uint64_t changes = 1 + rng.below(4); changes > 0 && !input.empty(); --changes) {
    const std::uint64_t at = rng.below(input.size());
    const auto here = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto some =
        static_cast<std::ptrdiff_t>(1 + rng.below(std::min<std::uint64_t>(16, input.size() - at)));
    switch (rng.below(5)) {
      case 0:
        *here = static_cast<std::uint8_t>(rng.next());
        break;
      case 1:
        *here = static_cast<std::uint8_t>(*here ^ (1U << rng.below(8)));
        break;
      case 2:
        input.erase(here, here + some);
        break;
      case 3: {
        const Input piece(here, here + some);
        const std::uint64_t to = rng.below(input.size());
        input.insert(input.begin() + static_cast<std::ptrdiff_t>(to), piece.begin(), piece.end());
        break;
      }
      default:
        input.resize(rng.below(4) == 0 ? at : input.size());
    }
  }
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t count = 1000;
  std::vector<Input> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.size() > 1 && argument[0] == '-') {
      count = std::strtoull(argument.c_str() + 1, nullptr, 10);
      continue;
    }
    std::ifstream file(argument, std::ios::binary);
    if (!file) {
      std::fprintf(stderr, "%s: cannot be read\n", argument.c_str());
      return 3;
    }
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    run(files.back());
  }
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    soms::Rng rng(seed);
    run(files.empty() ? random_input(rng) : changed(files[seed % files.size()], rng));
  }
  std::printf("%zu files, %llu inputs\n", files.size(), static_cast<unsigned long long>(count));
  return 0;
}
