#include "soms/geometry/detail/counts.h"

#include "soms/base/error.h"
#include "soms/geometry/mesh.h"

namespace soms {

void check_counts(std::uint64_t vertices, std::uint64_t triangles, const std::string& place) {
  if (triangles > kMaxPrimitives || vertices > kMaxPrimitives) {
    throw Error(ErrorKind::out_of_range,
                place + ", " + std::to_string(triangles) + " triangles and " +
                    std::to_string(vertices) + " vertices",
                "split the mesh: at most 2^31 - 1 of either");
  }
}

std::string index_fault(const std::string& index, const std::string& items, std::uint64_t count) {
  if (count == 0) {
    return index + ", but there are no " + items;
  }
  return index + (count == 1 ? ", but the only one is 0"
                             : ", but " + items + " are 0 to " + std::to_string(count - 1));
}

}  // namespace soms
