/// \file
/// Waiting for events. Tests wait for what happens, never for time to pass, so that a slow or busy
/// machine changes nothing (CONTRIBUTING.md). tests/structure/clock_test.py finds what does not.
#pragma once

#include <filesystem>
#include <functional>

namespace soms::test {

/// Returns once `happened()` is true, which is looked at every few milliseconds. What never happens
/// is ended by ctest, which fails the test.
void wait_until(const std::function<bool()>& happened);

/// True where the process (0: this one) has `path` open, by how many descriptors at least.
[[nodiscard]] bool has_open(int process, const std::filesystem::path& path,
                            std::size_t descriptors = 1);

/// Waits until files written from now on have a later date than those written before.
void wait_for_a_later_date(const std::filesystem::path& folder);

/// Lets so many seconds pass, or more: for a program that shows something after a time, where what
/// is expected holds however much more passed.
void wait_at_least(double seconds);

}  // namespace soms::test
