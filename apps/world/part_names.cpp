#include "apps/world/part_names.h"

#include "soms/base/text.h"

#include "apps/model/models.h"
#include "apps/world/world.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace soms::command {

std::string part_label(const MeshView& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return short_name(mesh.source);
  }
  const std::string& name = mesh.parts[part].name;
  return name.empty() ? fmt::format("part {}", part) : name;
}

std::string part_path_label(const MeshView& mesh, std::uint32_t part, std::size_t most) {
  if (part == Part::kNoParent) {
    return {};
  }
  // From the inside out, so that where parts are nested deeply the outer ones need not be visited.
  std::vector<std::string> names{part_label(mesh, part)};
  std::size_t size = names.front().size();
  for (std::uint32_t at = mesh.parts[part].parent;
       at != Part::kNoParent && size <= most && names.size() < mesh.parts.size();
       at = mesh.parts[at].parent) {
    const std::string& name = mesh.parts[at].name;
    names.push_back(name.empty() ? "..." : name);
    size += names.back().size() + 1;
  }
  std::reverse(names.begin(), names.end());
  return fmt::format("{}", fmt::join(names, "/"));
}

std::string part_in_text(const MeshView& mesh, std::uint32_t part) {
  return printable(part == Part::kNoParent ? part_label(mesh, part) : part_path_label(mesh, part));
}

Json part_as_json(const MeshView& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return {{"id", nullptr}, {"name", nullptr}, {"path", Json::array()}};
  }
  return {{"id", part}, {"name", mesh.parts[part].name}, {"path", part_path(mesh, part)}};
}

std::string joined_label(const std::vector<std::string>& labels) {
  constexpr std::size_t kMost = 3;
  const std::size_t named = labels.size() > kMost ? kMost - 1 : labels.size();
  std::string text = fmt::format(
      "{}", fmt::join(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(named), " + "));
  return named == labels.size() ? text : fmt::format("{} + {} more", text, labels.size() - named);
}

std::string body_label(const MeshView& mesh, std::uint32_t part,
                       std::span<const std::uint32_t> joined) {
  const auto label = [&](std::uint32_t number) {
    return number == Part::kNoParent ? part_label(mesh, number) : part_path_label(mesh, number);
  };
  std::vector<std::string> labels{label(part)};
  for (const std::uint32_t other : joined) {
    labels.push_back(label(other));
  }
  return joined_label(labels);
}

Json body_as_json(const MeshView& mesh, std::uint32_t part, std::span<const std::uint32_t> joined) {
  Json json = part_as_json(mesh, part);
  for (const std::uint32_t other : joined) {
    json["joined"].push_back(part_as_json(mesh, other));
  }
  return json;
}

std::string triangle_label(const MeshView& mesh, TriangleId i, const FileNumbers& numbers) {
  const std::string part = part_name(mesh, i);
  return part.empty() ? fmt::format("{}", numbers(i))
                      : fmt::format("{} ({})", numbers(i), printable(part));
}

std::string part_csv_fields(const MeshView& mesh, std::uint32_t part) {
  return part == Part::kNoParent ? std::string(",")
                                 : fmt::format("{},{}", part, csv_field(mesh.parts[part].name));
}

std::string triangle_csv_fields(const MeshView& mesh, const PartsOf& parts,
                                std::optional<TriangleId> triangle) {
  return triangle ? fmt::format("{},{}", *triangle, part_csv_fields(mesh, parts(*triangle)))
                  : std::string(",,");
}

}  // namespace soms::command
