#include "soms/query/instruction_set.h"

#include "soms/query/detail/kernels/instruction_set.h"

namespace soms {

std::vector<std::string_view> instruction_sets() {
  std::vector<std::string_view> names;
  for (const detail::Kernels* kernels : detail::kernels_here()) {
    names.push_back(kernels->name);
  }
  return names;
}

std::string_view instruction_set() {
  return detail::kernels().name;
}

}  // namespace soms
