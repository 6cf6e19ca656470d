#include "soms/io/detail/ply/ply.h"

#include "soms/io/detail/ply/ply_binary.h"
#include "soms/io/detail/ply/ply_text.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

const PlyElement* find_element(const Source& source, const PlyHeader& header,
                               std::string_view name) {
  const PlyElement* found = nullptr;
  for (const PlyElement& element : header.elements) {
    if (element.name == name) {
      if (found != nullptr) {
        source.fail(ErrorKind::bad_file, "element " + in_quotes(name) + " is declared twice",
                    "repair the header");
      }
      found = &element;
    }
  }
  return found;
}

VertexColumns vertex_columns(const Source& source, const PlyElement& vertices) {
  VertexColumns columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view name = std::string_view("xyz").substr(axis, 1);
    const auto found = vertices.find(source, name);
    if (!found) {
      source.fail(ErrorKind::bad_file, "vertices have no property " + in_quotes(name),
                  "give x, y and z");
    }
    if (vertices.properties[*found].is_list) {
      source.fail(ErrorKind::bad_file, "the vertices' property " + in_quotes(name) + " is a list",
                  "give one number");
    }
    columns[axis] = *found;
  }
  return columns;
}

/// The list of corners, under either of its usual names.
std::size_t corner_column(const Source& source, const PlyElement& element) {
  auto found = element.find(source, "vertex_indices");
  const auto other = element.find(source, "vertex_index");
  if (found && other) {
    source.fail(ErrorKind::bad_file,
                "element " + in_quotes(element.name) + " has both vertex_indices and vertex_index",
                "keep one of them");
  }
  found = found ? found : other;
  if (!found || !element.properties[*found].is_list) {
    source.fail(
        ErrorKind::bad_file,
        "element " + in_quotes(element.name) + " has no list vertex_indices or vertex_index",
        "add the corners of the faces");
  }
  return *found;
}

void read_corners(const Source& source, PlyBody& body, const PlyElement& element) {
  const std::size_t column = corner_column(source, element);
  if (element.name == "face") {
    body.read_faces(element, column);
  } else {
    body.read_strips(element, column);
  }
}

/// True if the rows of an element that is passed may stand for something that is seen: edges, say.
bool may_be_seen(const PlyElement& element) {
  return element.name != "camera" && element.name != "material" && !element.properties.empty();
}

}  // namespace

void PlyBody::read_strips(const PlyElement& element, std::size_t column) {
  begin_element(element);
  LeftOut thin;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    source_.tick(position());
    read_row(element, column, -1);
    PlyStrip strip(builder_);
    for (const std::int64_t corner : corners_) {
      strip.add(corner);
    }
    strip.end();
    thin.add(
        [&] { return "in row " + std::to_string(row) + " of element " + in_quotes(element.name); },
        strip.thin());
  }
  builder_.note(thin, "strips with fewer than three corners, not read");
}

Mesh read_ply(Source& source) {
  const PlyHeader header = read_ply_header(source);
  source.kept = header.body;  // names of elements and properties lie there
  const PlyElement* vertices = find_element(source, header, "vertex");
  const PlyElement* faces = find_element(source, header, "face");
  const PlyElement* strips = find_element(source, header, "tristrips");
  if (vertices == nullptr) {
    source.fail(ErrorKind::bad_file, "the header names no element vertex", "add the vertices");
  }
  const VertexColumns columns = vertex_columns(source, *vertices);
  MeshBuilder builder(source);
  const std::unique_ptr<PlyBody> body = header.format == PlyFormat::ascii
                                            ? make_ply_text(source, builder, header)
                                            : make_ply_binary(source, builder, header);
  bool have_vertices = false;
  LeftOut others;
  // Faces before the vertices are passed, and read in order once the vertices are known.
  std::vector<std::pair<const PlyElement*, std::size_t>> early;
  for (const PlyElement& element : header.elements) {
    if (&element == vertices) {
      body->read_vertices(element, columns);
      have_vertices = true;
    } else if ((&element != faces && &element != strips) || element.count == 0) {
      body->skip(element);
      if (may_be_seen(element)) {
        others.add([&] { return "of element " + in_quotes(element.name); }, element.count);
      }
    } else if (have_vertices && early.empty()) {
      read_corners(source, *body, element);
    } else {
      source.forgettable = false;
      early.emplace_back(&element, body->position());
      body->skip(element);
    }
  }
  body->finish();
  builder.note(others, "rows of elements other than vertex, face and tristrips, not read");
  for (const auto& [element, position] : early) {
    body->go_to(position);
    read_corners(source, *body, *element);
  }
  return builder.finish();
}

}  // namespace soms::detail
