#include "soms/geometry/parts_of.h"

#include <algorithm>
#include <iterator>

namespace soms {

PartsOf::PartsOf(const MeshView& mesh) : runs_(part_runs(mesh)) {
  for (PartRun& run : runs_) {
    run.part = first_run(mesh, run.part);
  }
}

std::uint32_t PartsOf::operator()(TriangleId triangle) const {
  const auto behind =
      std::upper_bound(runs_.begin(), runs_.end(), triangle,
                       [](TriangleId t, const PartRun& run) { return t < run.first; });
  return behind == runs_.begin() ? Part::kNoParent : std::prev(behind)->part;
}

std::vector<std::string> part_path(const MeshView& mesh, std::uint32_t part) {
  std::vector<std::string> path;
  while (part != Part::kNoParent && path.size() < mesh.parts.size()) {
    path.push_back(mesh.parts[part].name);
    part = mesh.parts[part].parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace soms
