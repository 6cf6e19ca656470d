/// \file
/// What work costs, in a unit that is the same on every machine.
#pragma once

#include <functional>

namespace soms::test {

/// Processor time that `work` takes, as a multiple of that of a fixed calculation: sorting a
/// million numbers in this build, about a tenth of a second. Of the processor, so other programs
/// do not count; a multiple, so that neither a slow machine nor a sanitizer changes it by much. A
/// limit should leave a factor of five.
[[nodiscard]] double effort_of(const std::function<void()>& work);

}  // namespace soms::test
