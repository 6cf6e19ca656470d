/// \file
/// A thread whose stack is small, to show that code does not recurse as deep as its input.
#pragma once

#include <functional>

namespace soms::test {

/// Runs `body` on a thread with a stack of 256 KiB and waits for it.
void on_small_stack(std::function<void()> body);

}  // namespace soms::test
