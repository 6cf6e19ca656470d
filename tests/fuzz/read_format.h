/// \file
/// The format that a program of read_fuzz.cpp reads.
#pragma once

namespace soms::fuzz {

/// The ending of file names, without its point.
extern const char* const kFormat;

}  // namespace soms::fuzz
