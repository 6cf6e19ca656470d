/// \file
/// How many threads a call may be given.
#pragma once

namespace soms {

/// Most threads that programs and bindings accept: more are a mistake, such as a count of triangles
/// in the place of a count of threads.
inline constexpr int kMostThreads = 1024;

}  // namespace soms
