#include "soms/geometry/counts.h"

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

}  // namespace soms
