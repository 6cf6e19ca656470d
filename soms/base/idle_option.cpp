#include "soms/base/idle_option.h"

#include "soms/base/error.h"

namespace soms {

void refuse_idle(const std::string& whose, const IdleOption& idle) {
  const std::string needs(idle.needs);
  const std::string cure = idle.value.empty() ? "choose another " + needs
                                              : "set " + needs + " to " + std::string(idle.value);
  throw Error(ErrorKind::usage,
              whose + ": " + std::string(idle.name) + " has no effect: " + std::string(idle.reason),
              "leave it at its default, or " + cure);
}

}  // namespace soms
