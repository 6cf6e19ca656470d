#include "soms/motion/print_motion.h"

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/motion/rigid_motion.h"

#include <ostream>

namespace soms {

std::ostream& operator<<(std::ostream& out, const RigidMotion& value) {
  return out << PrintedFields("RigidMotion")
                    .item(value.straight() ? "straight" : "turning")
                    .add("start", value.start())
                    .add("end", value.end())
                    .add("pivot", value.pivot());
}

}  // namespace soms
