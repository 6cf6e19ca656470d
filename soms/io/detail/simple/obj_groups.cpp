#include "soms/io/detail/simple/obj_groups.h"

#include "soms/geometry/part_runs.h"

#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace soms::detail {

namespace {

/// Names of groups that differ from one another.
class GroupNames {
 public:
  /// `wanted`, with a number behind it if it is taken; "group" for a part without a name, if
  /// nothing else may be without one.
  std::string next(std::string wanted) {
    if (wanted.empty() && taken_.contains(wanted)) {
      wanted = "group";
    }
    if (taken_.insert(wanted).second) {
      return wanted;
    }
    std::uint64_t& last = numbers_.try_emplace(wanted, 1).first->second;
    while (true) {
      std::string numbered = wanted + '_' + std::to_string(++last);
      if (taken_.insert(numbered).second) {
        return numbered;
      }
    }
  }

  void take(const std::string& name) { taken_.insert(name); }

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::uint64_t> numbers_;  ///< last one behind a name
};

/// Outermost part around `part`, each part of several runs as its first.
std::uint32_t outermost(const MeshView& mesh, std::uint32_t part) {
  std::uint32_t at = first_run(mesh, part);
  // A part that encloses itself, which no reader makes, ends the search.
  for (std::size_t steps = 0; at != Part::kNoParent && steps < mesh.parts.size(); ++steps) {
    const std::uint32_t above = mesh.parts[at].parent;
    if (above == Part::kNoParent) {
      break;
    }
    at = first_run(mesh, above);
  }
  return at;
}

std::string name_in(const MeshView& mesh, std::uint32_t part) {
  return part == Part::kNoParent ? std::string() : line_name(mesh.parts[part].name);
}

std::string group_line_of(char keyword, const std::string& name) {
  return std::string(1, keyword) + (name.empty() ? "" : " ") + name + '\n';
}

/// How the parts of a mesh can be written.
enum class ObjShape { groups, objects, interleaved };

class ObjGrouping {
 public:
  explicit ObjGrouping(const MeshView& mesh) : mesh_(mesh), runs_(part_runs(mesh)) {}

  ObjGroups group() {
    const ObjShape shape = find_shape();
    ObjGroups groups;
    for (const PartRun& run : runs_) {
      const std::uint32_t part = first_run(mesh_, run.part);
      const std::string lines = shape == ObjShape::objects ? in_object(part) : group_line(part);
      // Triangles in front of all parts need no group.
      if (part != Part::kNoParent || run.first > 0) {
        groups.lines.push_back({run.first, lines});
      }
    }
    groups.renamed = renamed_;
    return groups;
  }

 private:
  [[nodiscard]] ObjShape find_shape() const {
    std::unordered_set<std::uint32_t> seen;
    std::set<std::string> names;
    bool objects = false;
    bool interleaved = false;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::uint32_t part = first_run(mesh_, runs_[i].part);
      const std::uint32_t outer = outermost(mesh_, part);
      objects = objects || outer != part;
      if (i == 0 || outer != last) {
        interleaved = interleaved || !seen.insert(outer).second;
        objects = objects || !names.insert(name_in(mesh_, outer)).second;
      }
      last = outer;
    }
    return interleaved ? ObjShape::interleaved : objects ? ObjShape::objects : ObjShape::groups;
  }

  /// The line of a group, of one name wherever it stands.
  std::string group_line(std::uint32_t part) {
    const auto found = given_.find(part);
    if (found != given_.end()) {
      return group_line_of('g', found->second);
    }
    const std::string wanted = name_in(mesh_, part);
    const std::string name = names_.next(wanted);
    renamed_ += name != wanted ? 1U : 0U;
    given_.emplace(part, name);
    return group_line_of('g', name);
  }

  /// The lines of a part within its outermost one.
  std::string in_object(std::uint32_t part) {
    const std::uint32_t outer = outermost(mesh_, part);
    std::string lines;
    if (!begun_ || outer != object_) {
      lines = group_line_of('o', name_in(mesh_, outer));
      object_ = outer;
      begun_ = true;
      names_ = {};
      names_.take("");  // what is of no group is the object's own
      given_.clear();
      return outer == part ? lines : lines + group_line(part);
    }
    return outer == part ? group_line_of('g', "") : group_line(part);
  }

  MeshView mesh_;
  std::vector<PartRun> runs_;
  GroupNames names_;
  std::unordered_map<std::uint32_t, std::string> given_;  ///< names of the groups so far
  std::uint32_t object_ = Part::kNoParent;
  bool begun_ = false;
  std::uint64_t renamed_ = 0;
};

}  // namespace

std::string line_name(std::string_view name) {
  std::string fit(name);
  for (char& c : fit) {
    c = (c >= 0 && c < ' ') || c == '\x7f' ? '_' : c;
  }
  if (fit.ends_with('\\')) {
    fit.back() = '_';
  }
  return fit;
}

ObjGroups obj_groups(const MeshView& mesh) {
  return ObjGrouping(mesh).group();
}

}  // namespace soms::detail
