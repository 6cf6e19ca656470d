/// \file
/// What a fuzzer's target says when an answer is wrong: it ends the program, as fuzzers expect.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace soms::fuzz {

inline void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "wrong: %s\n", what);
    std::abort();
  }
}

}  // namespace soms::fuzz
