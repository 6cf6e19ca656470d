/// \file
/// Checks of what must hold inside the library; off in release builds.
#pragma once

#include <cstdlib>

#if SOMS_ASSERTIONS
#define SOMS_ASSERT(condition) ((condition) ? static_cast<void>(0) : std::abort())
#else
#define SOMS_ASSERT(condition) static_cast<void>(sizeof(condition))
#endif
