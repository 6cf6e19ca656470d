#include "soms/generate/detail/counts.h"

#include "soms/base/error.h"

namespace soms::detail {

void check_closed_count(const std::string& what, std::uint64_t triangles, std::uint64_t least) {
  const std::string place = what + " of " + std::to_string(triangles) + " triangles";
  if (triangles < least) {
    throw Error(ErrorKind::usage, place, "the least is " + std::to_string(least));
  }
  if (triangles > kMostTriangles) {
    throw Error(ErrorKind::usage, place, "the most is " + std::to_string(kMostTriangles));
  }
  if (triangles % 2 != 0) {
    throw Error(ErrorKind::usage, place,
                "a closed surface has an even number of triangles; take " +
                    std::to_string(triangles - 1) + " or " + std::to_string(triangles + 1));
  }
}

}  // namespace soms::detail
