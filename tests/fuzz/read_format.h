/// \file
/// The format that a program of read_fuzz.cpp reads.
#pragma once

namespace soms::fuzz {

/// The file extension, without its point.
extern const char* const kFormat;

}  // namespace soms::fuzz
