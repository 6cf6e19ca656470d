#include "soms/scene/step_report.h"

#include "soms/base/hash.h"

#include <algorithm>

namespace soms {

std::vector<MoverId> StepReport::touching_movers() const {
  std::vector<MoverId> touching;
  touching.reserve(environment.size() + 2 * movers.size());
  for (const EnvironmentContact& contact : environment) {
    touching.push_back(contact.mover);
  }
  for (const MoverContact& contact : movers) {
    touching.push_back(contact.a);
    touching.push_back(contact.b);
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

std::uint64_t StepReport::hash() const {
  Fnv1a hash;
  for (const EnvironmentContact& contact : environment) {
    for (const std::uint32_t value : {contact.mover, contact.part, contact.i, contact.j}) {
      hash.add(value);
    }
  }
  for (const MoverContact& contact : movers) {
    for (const std::uint32_t value : {contact.a, contact.b, contact.i, contact.j}) {
      hash.add(value);
    }
  }
  return hash.value();
}

}  // namespace soms
