#include "apps/support/part_names.h"

#include "soms/geometry/parts_of.h"

#include "apps/support/world.h"

#include <fmt/format.h>

#include <vector>

namespace soms::command {

std::string part_label(const Mesh& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return short_name(mesh.source);
  }
  const std::string& name = mesh.parts[part].name;
  return name.empty() ? fmt::format("part {}", part) : name;
}

std::string part_path_label(const Mesh& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return {};
  }
  std::string label;
  for (const std::string& name : part_path(mesh, mesh.parts[part].parent)) {
    label += (name.empty() ? "..." : name) + "/";
  }
  return label + part_label(mesh, part);
}

}  // namespace soms::command
