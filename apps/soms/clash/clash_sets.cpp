#include "apps/soms/clash/clash_sets.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace soms::command {

namespace {

bool fits(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::string set_of_file(const MeshView& mesh) {
  const std::string stem = std::filesystem::path(mesh.source).stem().string();
  return stem.empty() ? mesh.source : stem;
}

const Part* named_part(const ClashSet& set, std::uint32_t part) {
  const std::uint32_t number = set.parts[part].part;
  return number == Part::kNoParent ? nullptr : &set.mesh_of(part).parts[number];
}

/// The parts that a side of a clash stands for: all of an open group (`body_in`), or itself.
std::vector<std::uint32_t> parts_in(const ClashSet& set, std::uint32_t part, const PartBody& other,
                                    const Clash& clash) {
  const PartBody& own = set.parts[part];
  if (&body_in(clash, own, other) == &own) {
    return {part};
  }
  // Those of a mesh follow each other, and the first of a group leads it.
  std::vector<std::uint32_t> parts;
  for (std::uint32_t k = part; k < set.parts.size() && set.mesh[k] == set.mesh[part]; ++k) {
    if (set.parts[k].together.body == own.together.body) {
      parts.push_back(k);
    }
  }
  return parts;
}

/// Whether two parts of a set with itself belong to one object, or one to the other.
bool are_sibling_parts(const ClashModels& models, std::uint32_t part_a, std::uint32_t part_b) {
  const ClashSet& second = models.second();
  const Mesh& mesh = models.a.mesh_of(part_a);
  const Part* const a = named_part(models.a, part_a);
  const Part* const b = named_part(second, part_b);
  if (a == nullptr || b == nullptr || &mesh != &second.mesh_of(part_b)) {
    return false;
  }
  const std::uint32_t of_a = first_run(mesh, a->parent);
  const std::uint32_t of_b = first_run(mesh, b->parent);
  const auto is = [&](std::uint32_t number, const Part* part) {
    return number != Part::kNoParent && &mesh.parts[number] == part;
  };
  return (of_a == of_b && of_a != Part::kNoParent) || is(of_a, b) || is(of_b, a);
}

/// The first pattern that fits a part.
std::optional<std::size_t> pattern_of_part(const ClashSetOptions& options, const ClashSet& set,
                                           std::uint32_t part) {
  const Part* const named = named_part(set, part);
  for (std::size_t k = 0; k < options.patterns.size(); ++k) {
    const std::string& pattern = options.patterns[k].second;
    if (is_called(set, part, pattern) || fits(pattern, set.mesh_of(part).source) ||
        (named != nullptr && !named->type.empty() && fits(pattern, named->type))) {
      return k;
    }
  }
  return std::nullopt;
}

/// A pattern that fits nothing is misspelled, as a rule.
void check_patterns(const ClashSetOptions& options, const ClashModels& models,
                    const std::vector<bool>& fitting) {
  for (std::size_t k = 0; k < fitting.size(); ++k) {
    if (!fitting[k]) {
      const auto& [name, pattern] = options.patterns[k];
      throw Error(
          ErrorKind::usage,
          fmt::format("--set {}={}: no part fits, or an earlier --set has them all", name, pattern),
          models.a.labels.empty()
              ? "give models that have parts"
              : fmt::format("patterns are case-sensitive; the first part is named \"{}\"",
                            models.a.labels.front()));
    }
  }
}

void name_sets_of_groups(ClashSet& set) {
  std::map<const PartBody*, std::set<std::string>> names;
  for (std::uint32_t part = 0; part < set.parts.size(); ++part) {
    if (const PartBody* const group = set.parts[part].together.body.get()) {
      names[group].insert(set.sets[part]);
    }
  }
  for (std::uint32_t part = 0; part < set.parts.size() && !names.empty(); ++part) {
    const PartBody* const group = set.parts[part].together.body.get();
    if (group != nullptr && set.parts[part].leads()) {
      set.sets_of_groups[part] = std::move(names[group]);
    }
  }
}

std::pair<std::string, std::string> halves(const std::string& option, const std::string& text,
                                           char between, const std::string& remedy) {
  const std::size_t at = text.find(between);
  if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
    throw Error(ErrorKind::usage, option + " '" + text + "'", remedy);
  }
  return {text.substr(0, at), text.substr(at + 1)};
}

std::string type_of(const ClashSet& set, std::uint32_t part) {
  const Part* const named = named_part(set, part);
  return named == nullptr || named->type.empty() ? "-" : named->type;
}

std::string parent_of(const ClashSet& set, std::uint32_t part) {
  const Part* const named = named_part(set, part);
  if (named == nullptr || named->parent == Part::kNoParent) {
    return "-";
  }
  return part_path_label(set.mesh_of(part), named->parent);
}

}  // namespace

bool is_called(const ClashSet& set, std::uint32_t part, const std::string& pattern) {
  if (fits(pattern, set.labels[part])) {
    return true;
  }
  const MeshView& mesh = set.mesh_of(part);
  const PartBody& body = set.parts[part];
  const auto is = [&](std::uint32_t number) {
    const Part* const named = number == Part::kNoParent ? nullptr : &mesh.parts[number];
    return named != nullptr &&
           (fits(pattern, named->name) || (!named->id.empty() && fits(pattern, named->id)) ||
            (!body.joined.empty() && fits(pattern, part_path_label(mesh, number))));
  };
  return is(body.part) || std::any_of(body.joined.begin(), body.joined.end(), is);
}

std::pair<std::string, std::string> set_pattern(const std::string& text) {
  return halves("--set", text, '=', "give a name and a pattern, as in --set 'pipes=Pipe*'");
}

std::pair<std::string, std::string> set_pair(const std::string& text) {
  return halves("--between", text, ',', "give the names of two sets, as in --between walls,pipes");
}

void give_sets(const ClashSetOptions& options, ClashModels& models) {
  std::set<std::string> names;
  std::vector<bool> fitting(options.patterns.size(), false);
  for (ClashSet* const set : {&models.a, &models.b}) {
    for (std::uint32_t part = 0; part < set->parts.size(); ++part) {
      const std::optional<std::size_t> pattern = pattern_of_part(options, *set, part);
      if (pattern) {
        fitting[*pattern] = true;
      }
      set->sets.push_back(pattern ? options.patterns[*pattern].first
                                  : set_of_file(set->mesh_of(part)));
      names.insert(set->sets.back());
    }
    name_sets_of_groups(*set);
  }
  check_patterns(options, models, fitting);
  for (const auto& [first, second] : options.between) {
    for (const std::string& name : {first, second}) {
      if (!names.contains(name)) {
        throw unknown_choice("--between", name, {names.begin(), names.end()});
      }
    }
  }
}

bool are_compared(const ClashSetOptions& options, const ClashModels& models, std::uint32_t a,
                  std::uint32_t b) {
  const std::string& of_a = models.a.sets[a];
  const std::string& of_b = models.second().sets[b];
  return options.between.empty() ||
         std::any_of(options.between.begin(), options.between.end(), [&](const auto& pair) {
           return (pair.first == of_a && pair.second == of_b) ||
                  (pair.first == of_b && pair.second == of_a);
         });
}

bool bodies_are_compared(const ClashSetOptions& options, const ClashModels& models, std::uint32_t a,
                         std::uint32_t b) {
  if (are_compared(options, models, a, b)) {
    return true;
  }
  const ClashSet& second = models.second();
  const auto of_a = models.a.sets_of_groups.find(a);
  const auto of_b = second.sets_of_groups.find(b);
  const bool a_is_group = of_a != models.a.sets_of_groups.end();
  const bool b_is_group = of_b != second.sets_of_groups.end();
  const PartBody& part_a = models.a.parts[a];
  const PartBody& part_b = second.parts[b];
  if ((!a_is_group && !b_is_group) || !part_a.leads() || !part_b.leads() ||
      part_a.together.body == part_b.together.body) {
    return false;
  }
  const auto has = [](bool is_group, const auto& of, const std::string& own,
                      const std::string& name) {
    return is_group ? of->second.contains(name) : own == name;
  };
  const auto are = [&](const std::string& first, const std::string& other) {
    return has(a_is_group, of_a, models.a.sets[a], first) &&
           has(b_is_group, of_b, second.sets[b], other);
  };
  return std::any_of(options.between.begin(), options.between.end(), [&](const auto& pair) {
    return are(pair.first, pair.second) || are(pair.second, pair.first);
  });
}

bool is_looked_for(const ClashSetOptions& options, const ClashModels& models, const Clash& clash) {
  const PartBody& a = models.a.parts[clash.a];
  const PartBody& b = models.second().parts[clash.b];
  return &body_in(clash, a, b) != &a || &body_in(clash, b, a) != &b ||
         are_compared(options, models, clash.a, clash.b);
}

bool of_all_parts(const ClashModels& models, const Clash& clash,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& holds) {
  const ClashSet& second = models.second();
  const std::vector<std::uint32_t> of_a = parts_in(models.a, clash.a, second.parts[clash.b], clash);
  const std::vector<std::uint32_t> of_b = parts_in(second, clash.b, models.a.parts[clash.a], clash);
  for (const std::uint32_t a : of_a) {
    if (!std::all_of(of_b.begin(), of_b.end(), [&](std::uint32_t b) { return holds(a, b); })) {
      return false;
    }
  }
  return true;
}

bool are_siblings(const ClashModels& models, const Clash& clash) {
  return of_all_parts(models, clash, [&](std::uint32_t a, std::uint32_t b) {
    return are_sibling_parts(models, a, b);
  });
}

ClashGrouping clash_grouping(const std::string& text) {
  const std::string cell = "cell=";
  if (text.rfind(cell, 0) == 0) {
    const double side = parse_number("--group-by cell=SIZE", text.substr(cell.size()));
    if (!(side > 0)) {
      throw Error(ErrorKind::usage, "--group-by " + text + ": cells need a size above 0",
                  "give the side of a cell, as in --group-by cell=5");
    }
    return {.by = ClashGroup::cell, .cell = side};
  }
  const std::vector<std::pair<std::string, ClashGroup>> known{
      {"a", ClashGroup::a},       {"b", ClashGroup::b},     {"parent", ClashGroup::parent},
      {"type", ClashGroup::type}, {"set", ClashGroup::set},
  };
  std::vector<std::string> names;
  for (const auto& [name, by] : known) {
    if (name == text) {
      return {.by = by};
    }
    names.push_back(name);
  }
  names.emplace_back("cell=SIZE");
  throw unknown_choice("--group-by", text, names);
}

ClashGroups::ClashGroups(const ClashGrouping& grouping, const ClashModels& models)
    : grouping_(grouping), models_(models) {
  const bool of_second = grouping.by == ClashGroup::b;
  if (grouping.by != ClashGroup::a && !of_second && grouping.by != ClashGroup::parent) {
    return;
  }
  const ClashSet& set = of_second ? models.second() : models.a;
  // Several objects of one name are groups of their own, which then say where they are.
  using Object = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Object> objects;
  std::map<std::string, std::set<Object>> named;
  for (std::uint32_t part = 0; part < set.parts.size(); ++part) {
    const bool parent = grouping.by == ClashGroup::parent;
    const Part* const own = named_part(set, part);
    const std::uint32_t number = !parent          ? set.parts[part].part
                                 : own == nullptr ? Part::kNoParent
                                                  : own->parent;
    objects.emplace_back(set.mesh[part], first_run(set.mesh_of(part), number));
    labels_.push_back(parent ? parent_of(set, part) : set.labels[part]);
    named[labels_.back()].insert(objects.back());
  }
  for (std::uint32_t part = 0; part < set.parts.size(); ++part) {
    const auto& [mesh, number] = objects[part];
    if (number != Part::kNoParent && named[labels_[part]].size() > 1) {
      labels_[part] += fmt::format(" ({}, part {})", set.mesh_of(part).source, number);
    }
  }
}

std::string ClashGroups::operator()(const Clash& clash) const {
  const ClashSet& a = models_.a;
  const ClashSet& b = models_.second();
  switch (grouping_.by) {
    case ClashGroup::a:
    case ClashGroup::parent:
      return labels_[clash.a];
    case ClashGroup::b:
      return labels_[clash.b];
    case ClashGroup::type:
      return type_of(a, clash.a) + " and " + type_of(b, clash.b);
    case ClashGroup::set:
      return a.sets[clash.a] + " and " + b.sets[clash.b];
    case ClashGroup::cell: {
      const auto index = [&](double place) { return std::floor(place / grouping_.cell); };
      return fmt::format("cell {:.0f} {:.0f} {:.0f}", index(clash.place.x), index(clash.place.y),
                         index(clash.place.z));
    }
    case ClashGroup::none:
      break;
  }
  return "-";
}

}  // namespace soms::command
