/// \file
/// Printing of motions and their answers, for tests, messages and debugging.
#pragma once

#include "soms/describe/print_answers.h"
#include "soms/motion/first_contact.h"

#include <iosfwd>

namespace soms {

class RigidMotion;

/// One line, as in soms/base/print.h.
std::ostream& operator<<(std::ostream& out, const RigidMotion& value);

}  // namespace soms
