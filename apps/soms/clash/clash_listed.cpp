#include "apps/soms/clash/clash_listed.h"

#include "apps/soms/clash/clash_output.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace soms::command {

namespace {

/// Beyond this, squares of lengths overflow.
constexpr double kFarthestPlace = 1e150;

std::optional<Vec3> json_vector(const Json& value) {
  if (!value.is_array() || value.size() != 3) {
    return std::nullopt;
  }
  Vec3 v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!value[axis].is_number()) {
      return std::nullopt;
    }
    v[axis] = value[axis].get<double>();
    if (!(std::fabs(v[axis]) <= kFarthestPlace)) {
      return std::nullopt;
    }
  }
  return v;
}

Box json_corners(const Json& value) {
  Box box;
  if (value.is_array() && value.size() == 2) {
    const std::optional<Vec3> lower = json_vector(value[0]);
    const std::optional<Vec3> upper = json_vector(value[1]);
    if (lower && upper) {
      box.grow(*lower);
      box.grow(*upper);
    }
  }
  return box;
}

const Json& side_of(const Json& row, std::string_view side) {
  static const Json kNoSide = Json::object();
  const auto at = row.find(side);
  return at != row.end() && at->is_object() ? *at : kNoSide;
}

std::string path_text(const Json& side) {
  std::string path;
  if (const auto at = side.find("path"); at != side.end() && at->is_array()) {
    for (const Json& step : *at) {
      path.append(path.empty() ? "" : "/");
      path.append(step.is_string() ? step.get<std::string>() : std::string());
    }
  }
  return path;
}

}  // namespace

std::string side_mark(const Json& side) {
  const std::string id = text_of(side, "id");
  return fmt::format("{}{}", id.empty() ? 'p' : 'i', id.empty() ? path_text(side) : id);
}

std::string text_of(const Json& row, std::string_view key) {
  const auto at = row.find(key);
  if (at == row.end() || at->is_null()) {
    return {};
  }
  return at->is_string() ? at->get<std::string>() : json_text(*at);
}

std::string side_label(const Json& row, std::string_view side) {
  const Json& part = side_of(row, side);
  if (std::string path = path_text(part); !path.empty() && !text_of(part, "part").empty()) {
    return path;
  }
  if (std::string name = text_of(part, "part"); !name.empty()) {
    return name;
  }
  if (const std::string index = text_of(part, "index"); !index.empty()) {
    return fmt::format("part {}", index);
  }
  const std::string file = text_of(part, "file");
  return file.empty() ? "a part without a name" : std::filesystem::path(file).stem().string();
}

MarkedParts marked_parts(const ClashSet& set) {
  MarkedParts parts;
  for (std::uint32_t part = 0; part < set.parts.size(); ++part) {
    parts[side_mark(clash_side(set, part))].push_back(part);
  }
  return parts;
}

ListedClashes::ListedClashes(const ClashReport& report) : report_(report) {
  if (!report.resolved.empty()) {
    of_a_ = marked_parts(report.models.a);
    of_b_ = report.models.two_sets ? marked_parts(report.models.b) : of_a_;
  }
}

ListedClash ListedClashes::at(std::size_t k) const {
  if (k < report_.rows.size()) {
    const ClashRow& row = report_.rows[k];
    return {row_as_json(report_, row), row.clash.a, row.clash.b, row.clash.place, row.clash.box};
  }
  ListedClash listed{.row = report_.resolved[k - report_.rows.size()]};
  listed.row["status"] = kResolved;
  const auto number = [&](const MarkedParts& parts,
                          const char* side) -> std::optional<std::uint32_t> {
    const auto at = parts.find(side_mark(side_of(listed.row, side)));
    return at == parts.end() || at->second.size() > 1 ? std::nullopt
                                                      : std::optional(at->second.front());
  };
  listed.a = number(of_a_, "a");
  listed.b = number(of_b_, "b");
  listed.place = json_vector(listed.row["place"]);
  listed.box = json_corners(listed.row["box"]);
  return listed;
}

}  // namespace soms::command
