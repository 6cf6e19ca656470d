/// \file
/// Compiles what lies between for an instruction set that the file's other functions do not have.
/// Everything that is included from elsewhere comes before, so that no inline function of another
/// header is compiled for it and then used, by the linker's choice, where it is missing.
#pragma once

#define SOMS_PRAGMA(text) _Pragma(#text)
#if defined(__clang__)
#define SOMS_TARGET_BEGIN(set) \
  SOMS_PRAGMA(clang attribute push(__attribute__((target(set))), apply_to = function))
#define SOMS_TARGET_END SOMS_PRAGMA(clang attribute pop)
#else
#define SOMS_TARGET_BEGIN(set)  \
  SOMS_PRAGMA(GCC push_options) \
  SOMS_PRAGMA(GCC target(set))
#define SOMS_TARGET_END SOMS_PRAGMA(GCC pop_options)
#endif
