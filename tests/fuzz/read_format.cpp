#include "tests/fuzz/read_format.h"

namespace soms::fuzz {

const char* const kFormat = SOMS_FUZZ_FORMAT;

}  // namespace soms::fuzz
