#include "apps/support/parts_of.h"

#include <algorithm>
#include <iterator>

namespace soms::command {

PartsOf::PartsOf(const Mesh& mesh) : mesh_(&mesh), runs_(part_runs(mesh)) {
}

std::uint32_t PartsOf::operator()(TriangleId triangle) const {
  const auto behind =
      std::upper_bound(runs_.begin(), runs_.end(), triangle,
                       [](TriangleId t, const PartRun& run) { return t < run.first; });
  return behind == runs_.begin() ? Part::kNoParent : std::prev(behind)->part;
}

std::string PartsOf::name(TriangleId triangle) const {
  const std::uint32_t part = (*this)(triangle);
  return part == Part::kNoParent ? std::string() : mesh_->parts[part].name;
}

}  // namespace soms::command
