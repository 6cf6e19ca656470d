#include "apps/model/part_filter.h"

#include "soms/base/error.h"
#include "soms/geometry/parts_of.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/suggest.h"
#include "apps/cli/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <utility>

namespace soms::command {

namespace {

/// Name, id, type, and the path of names; empty ones are left out.
std::vector<std::string> names_of(const MeshView& mesh, std::uint32_t number) {
  const Part& part = mesh.parts[number];
  std::vector<std::string> names{part.name, part.id, part.type};
  if (part.parent != Part::kNoParent) {
    names.push_back(fmt::format("{}", fmt::join(part_path(mesh, number), "/")));
  }
  std::erase(names, std::string());
  return names;
}

/// Adds to the parts that are marked those inside of them.
void mark_inner_parts(const MeshView& mesh, std::vector<bool>& marked) {
  const std::vector<bool> outer = marked;
  for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
    std::size_t steps = 0;  // a part may enclose itself
    for (std::uint32_t above = mesh.parts[k].parent;
         above != Part::kNoParent && !marked[k] && steps < mesh.parts.size();
         above = mesh.parts[above].parent, ++steps) {
      marked[k] = outer[above];
    }
  }
}

/// The triangles of these numbers, with their corners alone.
PartsLeft selected(const MeshView& mesh, std::vector<TriangleId> numbers) {
  constexpr std::uint32_t kUnused = 0xffffffffU;
  PartsLeft left;
  Mesh& rest = left.mesh;
  rest.unit = mesh.unit;
  rest.up = mesh.up;
  rest.georeference = mesh.georeference;
  rest.source = mesh.source;
  rest.notes = mesh.notes;
  rest.parts = mesh.parts;
  for (Part& part : rest.parts) {
    const auto begin = std::lower_bound(numbers.begin(), numbers.end(), part.first);
    const auto end = std::lower_bound(begin, numbers.end(), part.first + part.count);
    part.first = static_cast<std::uint32_t>(begin - numbers.begin());
    part.count = static_cast<std::uint32_t>(end - begin);
  }
  std::vector<std::uint32_t> corner(mesh.vertices.size(), kUnused);
  for (const TriangleId number : numbers) {
    for (const std::uint32_t vertex : mesh.triangles[number]) {
      corner[vertex] = 0;
    }
    rest.faces.push_back(mesh.faces.empty() ? number : mesh.faces[number]);
  }
  for (std::size_t vertex = 0; vertex < corner.size(); ++vertex) {
    if (corner[vertex] != kUnused) {
      corner[vertex] = static_cast<std::uint32_t>(rest.vertices.size());
      rest.vertices.push_back(mesh.vertices[vertex]);
      left.vertices.push_back(static_cast<std::uint32_t>(vertex));
    }
  }
  for (const TriangleId number : numbers) {
    const auto& [a, b, c] = mesh.triangles[number];
    rest.triangles.push_back({corner[a], corner[b], corner[c]});
  }
  left.numbers = std::move(numbers);
  return left;
}

}  // namespace

std::string PartFilter::options() const {
  std::string names;
  for (const bool only : {true, false}) {
    if (std::any_of(patterns_.begin(), patterns_.end(),
                    [&](const Pattern& pattern) { return pattern.only == only; })) {
      names += (names.empty() ? "" : " and ") + std::string(only ? "--only" : "--ignore");
    }
  }
  return names;
}

std::vector<std::string> PartFilter::patterns(bool only) const {
  std::vector<std::string> texts;
  for (const Pattern& pattern : patterns_) {
    if (pattern.only == only) {
      texts.push_back(pattern.text);
    }
  }
  return texts;
}

std::string PartFilter::text() const {
  std::string text;
  for (const Pattern& pattern : patterns_) {
    text += fmt::format("{}{} {}", text.empty() ? "" : " ", pattern.only ? "--only" : "--ignore",
                        pattern.text);
  }
  return text;
}

/// The parts that a pattern of the one option fits.
std::vector<bool> PartFilter::fitting(const MeshView& mesh, bool only) {
  std::vector<bool> fits(mesh.parts.size(), false);
  for (std::uint32_t k = 0; k < mesh.parts.size(); ++k) {
    for (const std::string& name : names_of(mesh, k)) {
      for (Pattern& pattern : patterns_) {
        if (pattern.only == only && fnmatch(pattern.text.c_str(), name.c_str(), 0) == 0) {
          pattern.used = fits[k] = true;
        }
      }
      names_.insert(name);
    }
  }
  mark_inner_parts(mesh, fits);
  return fits;
}

std::vector<TriangleId> PartFilter::numbers_left(const MeshView& mesh) {
  const std::vector<bool> named = fitting(mesh, true);
  const std::vector<bool> ignored = fitting(mesh, false);
  const bool any = std::find(named.begin(), named.end(), true) != named.end();
  const bool chooses = options().starts_with("--only") && (any || unnamed_ == Unnamed::left_out);
  const PartsOf part(mesh);
  std::vector<TriangleId> numbers;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t number = part(i);
    const bool inside = number != Part::kNoParent;
    if ((!chooses || (inside && named[number])) && !(inside && ignored[number])) {
      numbers.push_back(i);
    }
  }
  triangles_ += mesh.triangles.size();
  left_ += numbers.size();
  return numbers;
}

std::optional<PartsLeft> PartFilter::left_of(const MeshView& mesh) {
  if (!is_given()) {
    return std::nullopt;
  }
  std::vector<TriangleId> numbers = numbers_left(mesh);
  if (numbers.size() == mesh.triangles.size()) {
    return std::nullopt;
  }
  return selected(mesh, std::move(numbers));
}

Mesh PartFilter::left(Mesh mesh) {
  std::optional<PartsLeft> rest = left_of(mesh);
  return rest ? std::move(rest->mesh) : std::move(mesh);
}

Error PartFilter::no_part_fits(const Pattern& pattern) const {
  const std::string place =
      fmt::format("{} {}: ", pattern.only ? "--only" : "--ignore", printable(pattern.text));
  if (names_.empty()) {
    return {ErrorKind::usage, place + "no model has parts with names",
            "leave it out; soms info lists the parts of a model"};
  }
  constexpr std::size_t kMostNamed = 5;
  std::vector<std::string> known(names_.begin(), names_.end());
  const std::string near = nearest_words(pattern.text, known);
  if (!near.empty()) {
    return {ErrorKind::usage, place + "no part fits", "did you mean " + printable(near) + "?"};
  }
  const bool more = known.size() > kMostNamed;
  known.resize(std::min(known.size(), kMostNamed));
  return {ErrorKind::usage, place + "no part fits",
          fmt::format("names, ids and types of parts are such as {}{}; * stands for any letters",
                      printable(fmt::format("{}", fmt::join(known, ", "))), more ? ", ..." : "")};
}

void PartFilter::finish(const Console& console) const {
  for (const Pattern& pattern : patterns_) {
    if (!pattern.used) {
      throw no_part_fits(pattern);
    }
  }
  if (!is_given()) {
    return;
  }
  const std::string verb = options().find(' ') == std::string::npos ? "leaves" : "leave";
  if (left_ == 0) {
    throw Error(ErrorKind::usage, fmt::format("{} {} nothing", options(), verb),
                "give other patterns");
  }
  console.note(fmt::format("{} {} {} of {}", options(), verb, with_commas(left_),
                           counted(triangles_, "triangle")));
}

void drop_empty_parts(Mesh& mesh) {
  std::vector<bool> stays(mesh.parts.size(), false);
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < mesh.parts.size(); ++k) {
    if (mesh.parts[k].count > 0) {
      staying.push_back(k);
    }
  }
  while (!staying.empty()) {
    const std::uint32_t part = staying.back();
    staying.pop_back();
    if (part != Part::kNoParent && !stays[part]) {
      stays[part] = true;
      staying.insert(staying.end(), {mesh.parts[part].parent, mesh.parts[part].continues});
    }
  }
  std::vector<std::uint32_t> number(mesh.parts.size(), Part::kNoParent);
  std::vector<Part> parts;
  for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
    if (stays[k]) {
      number[k] = static_cast<std::uint32_t>(parts.size());
      parts.push_back(std::move(mesh.parts[k]));
    }
  }
  for (Part& part : parts) {
    for (std::uint32_t* const other : {&part.parent, &part.continues}) {
      *other = *other == Part::kNoParent ? *other : number[*other];
    }
  }
  mesh.parts = std::move(parts);
}

void add_part_filter(Parser& parser, std::shared_ptr<PartFilter>& filter,
                     const std::string& whose) {
  filter = std::make_shared<PartFilter>();
  Option* const only = parser.add_each_time(
      "--only", [filter](const std::string& pattern) { filter->keep_only(pattern); },
      "use only parts of " + whose + " whose name, id, type or path fits; may be repeated");
  only->option_text("PATTERN")->group("Models");
  parser
      .add_each_time(
          "--ignore", [filter](const std::string& pattern) { filter->ignore(pattern); },
          "leave out parts of " + whose + " that fit; may be repeated")
      ->option_text("PATTERN")
      ->group("Models")
      ->shown_with(only, "use only, or leave out, parts of " + whose +
                             " whose name, id, type or\npath fits; may be repeated");
}

}  // namespace soms::command
