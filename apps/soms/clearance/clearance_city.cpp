#include "apps/soms/clearance/clearance_city.h"

#include "soms/base/error.h"
#include "soms/geometry/parts_of.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <cstdint>
#include <utility>

namespace soms::command {

namespace {

/// Which parts fit a pattern, and which patterns fit a part.
class LeftOutParts {
 public:
  explicit LeftOutParts(const std::vector<std::string>& patterns)
      : patterns_(patterns), used_(patterns.size(), false) {}

  /// A flag for each part.
  std::vector<bool> of(const MeshView& mesh) {
    std::vector<bool> out(mesh.parts.size(), false);
    for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
      out[k] = fits(mesh.parts[k]);
    }
    std::vector<bool> with_parents = out;
    for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
      for (std::uint32_t above = mesh.parts[k].parent; above != Part::kNoParent && !with_parents[k];
           above = mesh.parts[above].parent) {
        with_parents[k] = out[above];
      }
    }
    return with_parents;
  }

  void require_all_used() const {
    for (std::size_t k = 0; k < patterns_.size(); ++k) {
      if (!used_[k]) {
        throw Error(ErrorKind::usage,
                    fmt::format("--ignore {}: no part of the city fits", patterns_[k]),
                    "soms info lists names, ids and types of parts; * stands for any letters");
      }
    }
  }

 private:
  bool fits(const Part& part) {
    bool any = false;
    for (std::size_t k = 0; k < patterns_.size(); ++k) {
      for (const std::string* const word : {&part.name, &part.id, &part.type}) {
        if (!word->empty() && fnmatch(patterns_[k].c_str(), word->c_str(), 0) == 0) {
          used_[k] = true;
          any = true;
        }
      }
    }
    return any;
  }

  const std::vector<std::string>& patterns_;
  std::vector<bool> used_;
};

/// Adds a body of the city, less the parts that are left out.
void add_compared(const Body& body, const std::vector<bool>& out, ComparedCity& city,
                  const Console& console) {
  const MeshView& mesh = body.shape.mesh();
  const PartsOf part(mesh);
  Mesh rest;
  rest.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
  rest.source = mesh.source;
  std::vector<TriangleId> triangles;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    if (const std::uint32_t number = part(i); number == Part::kNoParent || !out[number]) {
      rest.triangles.push_back(mesh.triangles[i]);
      triangles.push_back(i);
    }
  }
  if (triangles.size() == mesh.triangles.size()) {
    city.bodies.push_back(body);
    city.triangles.emplace_back();
    return;
  }
  city.bodies.emplace_back(build_shape(std::move(rest), {}, console), body.pose, body.name);
  city.triangles.push_back(std::move(triangles));
}

}  // namespace

void ComparedCity::rename(Clearance& answer) const {
  const auto rename_at = [this](ClearanceStation& station) {
    if (station.body && station.triangles && !triangles[*station.body].empty()) {
      station.triangles->second = triangles[*station.body][station.triangles->second];
    }
  };
  for (ClearanceStation& station : answer.stations) {
    rename_at(station);
  }
  for (ClearanceStretch& stretch : answer.stretches) {
    rename_at(stretch.least);
  }
  rename_at(answer.least);
  if (answer.first_contact) {
    rename_at(answer.first_contact->station);
  }
}

ComparedCity compared_city(const World& world, const std::vector<std::string>& patterns,
                           const Console& console) {
  ComparedCity city;
  if (patterns.empty()) {
    city.bodies = world.city;
    city.triangles.resize(world.city.size());
    return city;
  }
  LeftOutParts parts(patterns);
  std::size_t left = 0;
  std::size_t all = 0;
  for (const Body& body : world.city) {
    add_compared(body, parts.of(body.shape.mesh()), city, console);
    left += city.bodies.back().shape.mesh().triangles.size();
    all += body.shape.mesh().triangles.size();
  }
  parts.require_all_used();
  if (left == 0) {
    throw Error(ErrorKind::usage, "--ignore leaves nothing of the city",
                "give patterns that fit fewer parts");
  }
  console.note(
      fmt::format("--ignore leaves {} of {}", with_commas(left), counted(all, "triangle")));
  return city;
}

}  // namespace soms::command
