#include "apps/soms/models/info_defects.h"

#include "soms/base/error.h"
#include "soms/geometry/parts_of.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace soms::command {

namespace {

/// One defect: a triangle, an edge of one, or a vertex. What a kind does not have stays empty.
struct DefectPlace {
  const ExaminedMesh* mesh;
  bool of_vertex = false;
  std::uint32_t number = 0;  ///< of the triangle or vertex
  /// The triangle or vertex that this one repeats, or the edge's second triangle.
  std::uint32_t other = 0;
  bool has_original = false;
  std::uint32_t uses = 0;               ///< of an edge
  std::vector<std::uint32_t> vertices;  ///< corners, or ends

  /// The number that a triangle or vertex, whichever this is, has in the file.
  [[nodiscard]] std::uint32_t in_file(std::uint32_t own) const {
    return of_vertex ? mesh->vertex_numbers(own) : mesh->triangle_numbers(own);
  }

  [[nodiscard]] std::vector<std::uint32_t> vertices_in_file() const {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t vertex : vertices) {
      numbers.push_back(mesh->vertex_numbers(vertex));
    }
    return numbers;
  }
};

DefectPlace place_of(const ExaminedMesh& mesh, TriangleId triangle) {
  const auto& t = mesh.triangles[triangle];
  return {&mesh, false, triangle, triangle, false, 0, {t.begin(), t.end()}};
}

DefectPlace place_of(const ExaminedMesh& mesh, const TriangleCopy& copy) {
  DefectPlace place = place_of(mesh, copy.triangle);
  place.other = copy.original;
  place.has_original = true;
  return place;
}

DefectPlace place_of(const ExaminedMesh& mesh, const EdgePlace& edge) {
  const auto& t = mesh.triangles[edge.triangle];
  const std::uint32_t from = t[edge.corner];
  return {
      &mesh, false, edge.triangle, edge.other, false, edge.uses, {from, t[(edge.corner + 1) % 3]}};
}

DefectPlace place_of(const ExaminedMesh& mesh, const VertexCopy& copy) {
  return {&mesh, true, copy.vertex, copy.original, true, 0, {copy.vertex}};
}

/// Calls `tell(key, title, count, list, place)` for each kind of defect; `place(entry)` says where.
template <class Tell>
void for_each_kind(const ExaminedMesh& mesh, const Defects& d, const Tell& tell) {
  const DefectPlaces& p = d.places;
  const auto place = [&mesh](const auto& entry) { return place_of(mesh, entry); };
  const auto vertex = [&mesh](std::uint32_t v) {
    return DefectPlace{&mesh, true, v, v, false, 0, {v}};
  };
  tell("repeated_corner", "triangles with a repeated corner", d.repeated_corner, p.repeated_corner,
       place);
  tell("collinear", "triangles with collinear corners", d.collinear(), p.collinear, place);
  tell("duplicate", "duplicate triangles", d.duplicate, p.duplicate, place);
  tell("doubled", "duplicate triangles with reversed orientation", d.doubled, p.doubled, place);
  tell("open_edges", "open edges", d.open_edges, p.open_edges, place);
  tell("non_manifold_edges", "non-manifold edges", d.non_manifold_edges, p.non_manifold_edges,
       place);
  tell("flipped_edges", "flipped edges", d.flipped_edges, p.flipped_edges, place);
  tell("unused_vertices", "unused vertices", d.unused_vertices, p.unused_vertices, vertex);
  tell("repeated_vertices", "repeated vertices", d.repeated_vertices, p.repeated_vertices, place);
}

Json to_json(const DefectPlace& place, const PartsOf& part_of) {
  const ExaminedMesh& mesh = *place.mesh;
  Json json;
  json[place.of_vertex ? "vertex" : "triangle"] = place.in_file(place.number);
  if (place.has_original) {
    json["original"] = place.in_file(place.other);
  }
  if (place.uses > 0) {
    json["other"] = place.uses > 1 ? Json(place.in_file(place.other)) : Json();
    json["uses"] = place.uses;
  }
  if (!place.of_vertex) {
    const std::uint32_t part = part_of(place.number);
    json["face"] = mesh.faces.empty() ? place.in_file(place.number) : mesh.faces[place.number];
    json["part"] = part == Part::kNoParent ? Json() : Json(part);
    json["vertices"] = place.vertices_in_file();
  }
  Json points = Json::array();
  for (const std::uint32_t v : place.vertices) {
    const Vec3& p = mesh.vertices[v];
    points.push_back({p.x, p.y, p.z});
  }
  json["points"] = points;
  return json;
}

std::string to_text(const DefectPlace& place, const PartsOf& part_of) {
  const ExaminedMesh& mesh = *place.mesh;
  std::string text;
  if (!place.of_vertex) {
    text = fmt::format("triangle {}:", place.in_file(place.number));
  }
  for (std::size_t i = 0; i < place.vertices.size(); ++i) {
    const Vec3& p = mesh.vertices[place.vertices[i]];
    const char* const link = i == 0 ? "" : place.uses > 0 ? " to" : ",";
    text += fmt::format("{}{}vertex {} {}", link, text.empty() ? "" : " ",
                        mesh.vertex_numbers(place.vertices[i]), point_in_text(p));
  }
  if (place.has_original) {
    text += fmt::format("; as {} {}", place.of_vertex ? "vertex" : "triangle",
                        place.in_file(place.other));
  }
  if (place.uses > 1) {
    text += place.uses == 2 ? fmt::format("; with triangle {}", place.in_file(place.other))
                            : fmt::format("; {} triangles", with_commas(place.uses));
  }
  const std::uint32_t part = place.of_vertex ? Part::kNoParent : part_of(place.number);
  if (part != Part::kNoParent) {
    text += fmt::format("; part {}", name_or_number(mesh, part));
  }
  return text;
}

/// Prints places below a line with their title; nothing where there is none.
template <class List, class Place>
void print_list(const PartsOf& parts, std::string_view title, const List& list, std::uint64_t count,
                const Place& place, Console& console) {
  if (list.empty()) {
    return;
  }
  console.print(list.size() < count ? fmt::format("  {}, the first {} of {}\n", title,
                                                  with_commas(list.size()), with_commas(count))
                                    : fmt::format("  {}, all {}\n", title, with_commas(count)));
  for (const auto& entry : list) {
    check_stop(console.limits());
    console.print(fmt::format("    {}\n", to_text(place(entry), parts)));
  }
}

}  // namespace

std::string name_or_number(const ExaminedMesh& mesh, std::size_t part) {
  const std::string& name = mesh.parts[part].name;
  return name.empty() ? fmt::format("number {}", part) : printable(name);
}

Json defect_counts(const Defects& d) {
  return {{"degenerate", d.degenerate},
          {"duplicate", d.duplicate},
          {"open_edges", d.open_edges},
          {"non_manifold_edges", d.non_manifold_edges},
          {"flipped_edges", d.flipped_edges},
          {"unused_vertices", d.unused_vertices},
          {"closed", d.closed()},
          {"repeated_corner", d.repeated_corner},
          {"collinear", d.collinear()},
          {"doubled", d.doubled},
          {"repeated_vertices", d.repeated_vertices},
          {"closed_by_index", d.by_index.closed()}};
}

Json defect_places(const ExaminedMesh& mesh, const Defects& defects) {
  const PartsOf parts(mesh);
  Json json = Json::object();
  for_each_kind(
      mesh, defects,
      [&](const char* key, std::string_view, std::uint64_t, const auto& list, const auto& place) {
        Json& entries = json[key] = Json::array();
        for (const auto& entry : list) {
          entries.push_back(to_json(place(entry), parts));
        }
      });
  return json;
}

Json edge_places(const ExaminedMesh& mesh, std::span<const EdgePlace> edges) {
  const PartsOf parts(mesh);
  Json entries = Json::array();
  for (const EdgePlace& edge : edges) {
    entries.push_back(to_json(place_of(mesh, edge), parts));
  }
  return entries;
}

std::string describe_defects(const Defects& d) {
  std::string text;
  const auto add = [&](std::uint64_t number, const char* noun, const std::string& more = {}) {
    if (number != 0) {
      text += (text.empty() ? "" : ", ") + counted(number, noun) + more;
    }
  };
  const auto of_these = [](std::uint64_t number, const char* words) {
    return number == 0 ? std::string() : fmt::format(" ({} {})", with_commas(number), words);
  };
  add(d.degenerate, "triangle", " without area" + of_these(d.repeated_corner, "repeat a corner"));
  add(d.duplicate, "duplicate triangle", of_these(d.doubled, "reversed"));
  add(d.open_edges, "open edge");
  add(d.non_manifold_edges, "non-manifold edge");
  add(d.flipped_edges, "flipped edge");
  if (d.unused_vertices != 0) {
    text += fmt::format("{}{} unused vert{}", text.empty() ? "" : ", ",
                        with_commas(d.unused_vertices), d.unused_vertices == 1 ? "ex" : "ices");
  }
  const char* const closed = d.closed() ? "closed" : "not closed";
  return text.empty() ? fmt::format("none; {}", closed) : fmt::format("{}; {}", text, closed);
}

std::string describe_joining(const ExaminedMesh& mesh, const Defects& d) {
  if (d.repeated_vertices == 0) {
    return {};
  }
  return fmt::format("by position: {} of {} vertices repeat an earlier one; by number {}",
                     with_commas(d.repeated_vertices), with_commas(mesh.vertices.size()),
                     d.by_index.closed() ? "closed" : "not closed");
}

std::string describe_part(const ExaminedMesh& mesh, const Defects& defects, std::size_t part) {
  if (part >= defects.parts.size() || mesh.parts[part].count == 0) {
    return {};
  }
  const EdgeCounts& edges = defects.parts[part];
  return edges.none ? "without area" : edges.closed() ? "closed" : "open";
}

void print_edges(const ExaminedMesh& mesh, std::string_view title, std::span<const EdgePlace> edges,
                 std::uint64_t count, Console& console) {
  print_list(
      PartsOf(mesh), title, edges, count,
      [&](const EdgePlace& edge) { return place_of(mesh, edge); }, console);
}

void print_places(const ExaminedMesh& mesh, const Defects& defects, Console& console) {
  const PartsOf parts(mesh);
  for_each_kind(mesh, defects,
                [&](std::string_view key, std::string_view title, std::uint64_t count,
                    const auto& list, const auto& place) {
                  // Vertices that are joined are most of those of an STL file: JSON names them.
                  if (key != "repeated_vertices") {
                    print_list(parts, title, list, count, place, console);
                  }
                });
}

}  // namespace soms::command
