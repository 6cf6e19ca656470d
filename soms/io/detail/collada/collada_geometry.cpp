#include "soms/io/detail/collada/collada_geometry.h"

#include "soms/geometry/detail/counts.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::uint64_t kGreatestCount = std::numeric_limits<std::uint64_t>::max();

/// Where x, y and z of each vertex lie in an array of numbers.
struct Accessor {
  std::uint64_t count = 0;
  std::uint64_t offset = 0;
  std::uint64_t stride = 1;
  std::array<std::uint64_t, 3> columns{};
};

/// How the numbers of <p> make corners.
struct Layout {
  std::uint64_t stride = 0;            ///< numbers a corner; 0 without inputs
  std::uint64_t vertex = 0;            ///< which of them is the vertex
  std::optional<std::uint64_t> count;  ///< faces, strips or fans, where stated
};

class GeometryReader {
 public:
  explicit GeometryReader(ColladaDocument& document)
      : document_(document), builder_(document.source()) {}

  ColladaGeometry read(pugi::xml_node geometry);

 private:
  void read_mesh(pugi::xml_node mesh);
  void leave_out_unknown(pugi::xml_node element);
  void read_faces(pugi::xml_node element, std::string_view name);
  void find_vertices(pugi::xml_node input);
  void read_vertices();
  [[nodiscard]] Accessor read_accessor(pugi::xml_node source, pugi::xml_node element);
  void read_positions(const Accessor& accessor, pugi::xml_node array);
  void note_surplus(const Accessor& accessor, pugi::xml_node array, std::uint64_t numbers);
  [[nodiscard]] Layout read_layout(pugi::xml_node element);
  void read_corners(pugi::xml_node p, const Layout& layout);
  void read_triangles(pugi::xml_node element, const Layout& layout);
  void read_polylist(pugi::xml_node element, const Layout& layout);
  void read_each_p(pugi::xml_node element, const Layout& layout, std::string_view name);
  void expect_count(pugi::xml_node element, const Layout& layout, std::uint64_t found) const;

  ColladaDocument& document_;
  MeshBuilder builder_;
  ColladaGeometry geometry_;
  pugi::xml_node mesh_;
  pugi::xml_node vertices_;  ///< of the mesh, once its positions are read
  std::string_view vertices_id_;
  std::vector<std::uint32_t> corners_;
};

/// The columns of x, y and z: by their names, or the three that have one.
Accessor GeometryReader::read_accessor(pugi::xml_node source, pugi::xml_node element) {
  Accessor accessor;
  accessor.count = document_.whole_number(element, "count", 0);
  accessor.offset = document_.whole_number(element, "offset", 0);
  accessor.stride = document_.whole_number(element, "stride", 1);
  std::array<std::uint64_t, 3> by_name = {kGreatestCount, kGreatestCount, kGreatestCount};
  std::uint64_t named = 0;
  std::uint64_t column = 0;
  for (const pugi::xml_node param : element.children("param")) {
    const std::string_view name = param.attribute("name").value();
    if (name == "X" || name == "Y" || name == "Z") {
      std::uint64_t& known = by_name[static_cast<std::size_t>(name[0] - 'X')];
      if (known != kGreatestCount) {
        document_.fail(param, "the positions in " + describe(source) + " have two columns " +
                                  std::string(name));
      }
      known = column;
    }
    if (!name.empty()) {
      if (named < 3) {
        accessor.columns[named] = column;
      }
      ++named;
    }
    ++column;
  }
  if (std::count(by_name.begin(), by_name.end(), kGreatestCount) == 0) {
    accessor.columns = by_name;
  } else if (named != 3) {
    document_.fail(element, "the positions in " + describe(source) + " have " +
                                std::to_string(named) + " named coordinates, not X, Y and Z");
  }
  if (accessor.stride < column) {
    document_.fail(element, "the positions in " + describe(source) + " have " +
                                std::to_string(column) + " columns and a stride of " +
                                std::to_string(accessor.stride));
  }
  return accessor;
}

/// The positions of the mesh: <vertices> names a source, its accessor an array beside it.
void GeometryReader::read_vertices() {
  const pugi::xml_node input = vertices_.find_child_by_attribute("input", "semantic", "POSITION");
  if (!input) {
    document_.fail(vertices_, describe(vertices_) + " names no POSITION");
  }
  const pugi::xml_node source = document_.referred_child(input, "source", mesh_);
  const pugi::xml_node element = source.child("technique_common").child("accessor");
  if (!element) {
    document_.fail(source, describe(source) + " has no accessor");
  }
  const Accessor accessor = read_accessor(source, element);
  const pugi::xml_node array = document_.referred_child(element, "source", source);
  read_positions(accessor, array);
}

void GeometryReader::read_positions(const Accessor& accessor, pugi::xml_node array) {
  ColladaTokens tokens(document_, array);
  const std::uint64_t stated = document_.whole_number(array, "count", kGreatestCount);
  const std::uint64_t last = *std::max_element(accessor.columns.begin(), accessor.columns.end());
  if (accessor.count > tokens.most_left()) {
    document_.fail(array, std::to_string(accessor.count) + " vertices are stated, " +
                              describe(array) + " has room for fewer numbers");
  }
  builder_.reserve_vertices(accessor.count);
  Vec3 vertex;
  std::uint64_t index = 0;
  std::uint64_t column = 0;
  for (; !tokens.at_end(); ++index) {
    if (index % kRowsPerTick == 0) {
      document_.tick(array);
    }
    const double value = tokens.number();
    if (index < accessor.offset || builder_.vertices().size() == accessor.count) {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (column == accessor.columns[axis]) {
        vertex[axis] = value;
      }
    }
    if (column == last) {
      if (!fit_for_mesh(vertex)) {
        const CoordinateFault fault = describe_fault(vertex);
        tokens.fail(fault.kind, fault.what, fault.remedy);
      }
      builder_.add_vertex(vertex);
    }
    column = column + 1 == accessor.stride ? 0 : column + 1;
  }
  if (stated != kGreatestCount && stated != index) {
    document_.fail(array, describe(array) + " states " + std::to_string(stated) + " numbers and " +
                              "holds " + std::to_string(index));
  }
  if (builder_.vertices().size() != accessor.count) {
    document_.fail(array, std::to_string(accessor.count) + " vertices are stated, " +
                              describe(array) + " holds " +
                              std::to_string(builder_.vertices().size()));
  }
  note_surplus(accessor, array, index);
}

/// Of `numbers` in the array, those behind the last vertex and what may fill its row.
void GeometryReader::note_surplus(const Accessor& accessor, pugi::xml_node array,
                                  std::uint64_t numbers) {
  std::uint64_t used = 0;
  std::uint64_t filling = 0;
  if (accessor.count > 0) {
    const std::uint64_t last = *std::max_element(accessor.columns.begin(), accessor.columns.end());
    used = accessor.offset + (accessor.count - 1) * accessor.stride + last + 1;
    filling = accessor.stride - 1 - last;
  }
  const std::uint64_t left = numbers - std::min(numbers, used);
  geometry_.surplus.add(array, left - std::min(left, filling));
}

/// \errors ErrorKind::bad_file: no VERTEX, two of them, or one that is not of this mesh.
Layout GeometryReader::read_layout(pugi::xml_node element) {
  Layout layout;
  if (element.attribute("count")) {
    layout.count = document_.whole_number(element, "count", 0);
  }
  pugi::xml_node vertex;
  for (const pugi::xml_node input : element.children("input")) {
    if (!input.attribute("offset")) {
      document_.fail(input, "an <input> of " + describe(element) + " has no offset");
    }
    const std::uint64_t offset = document_.whole_number(input, "offset", 0);
    if (offset == kGreatestCount) {
      document_.fail(input, "an <input> of " + describe(element) + " has too large an offset");
    }
    layout.stride = std::max(layout.stride, offset + 1);
    if (std::string_view(input.attribute("semantic").value()) == "VERTEX") {
      if (vertex) {
        document_.fail(input, describe(element) + " has two inputs VERTEX");
      }
      vertex = input;
      layout.vertex = offset;
    }
  }
  // A list of no faces needs no inputs.
  if (!vertex) {
    if (element.child("p") || layout.count.value_or(0) > 0) {
      document_.fail(element, describe(element) + " has no input VERTEX");
    }
    return layout;
  }
  find_vertices(vertex);
  return layout;
}

/// The <vertices> that an input VERTEX names, and its positions where they are not read yet. A mesh
/// may have very many lists of faces: they are searched for it once.
void GeometryReader::find_vertices(pugi::xml_node input) {
  const std::string_view named = input.attribute("source").value();
  if (vertices_ && named.starts_with('#') && named.substr(1) == vertices_id_) {
    return;
  }
  const pugi::xml_node vertices = document_.referred_child(input, "source", mesh_);
  if (std::string_view(vertices.name()) != "vertices") {
    document_.fail(input, "VERTEX refers to " + describe(vertices) + ", not to <vertices>");
  }
  if (vertices_) {
    document_.fail(vertices, "a second <vertices> in one mesh");
  }
  vertices_ = vertices;
  vertices_id_ = vertices.attribute("id").value();
  read_vertices();
}

/// The corners in one <p>; the other numbers of a corner are checked to be numbers.
void GeometryReader::read_corners(pugi::xml_node p, const Layout& layout) {
  ColladaTokens tokens(document_, p);
  corners_.clear();
  const std::uint64_t room = tokens.most_left() / layout.stride + 1;
  if (room > corners_.capacity()) {
    document_.take((room - corners_.capacity()) * sizeof(corners_[0]));
    corners_.reserve(room);
  }
  const std::uint64_t vertices = builder_.vertices().size();
  std::uint64_t column = 0;
  for (std::size_t i = 0; !tokens.at_end(); ++i) {
    if (i % kRowsPerTick == kRowsPerTick - 1) {
      document_.tick(p);
    }
    const std::uint64_t value = tokens.whole_number();
    if (column == layout.vertex) {
      if (value >= vertices) {
        tokens.fail(ErrorKind::bad_file,
                    index_fault("vertex " + std::to_string(value), "vertices", vertices),
                    kRepairFile);
      }
      corners_.push_back(static_cast<std::uint32_t>(value));
    }
    column = column + 1 == layout.stride ? 0 : column + 1;
  }
  if (column != 0) {
    document_.fail(p, "<p> ends amid a corner of " + std::to_string(layout.stride) + " numbers");
  }
}

void GeometryReader::expect_count(pugi::xml_node element, const Layout& layout,
                                  std::uint64_t found) const {
  if (layout.count && *layout.count != found) {
    document_.fail(element, describe(element) + " states " + std::to_string(*layout.count) +
                                " and holds " + std::to_string(found));
  }
}

void GeometryReader::read_triangles(pugi::xml_node element, const Layout& layout) {
  std::uint64_t found = 0;
  for (const pugi::xml_node p : element.children("p")) {
    read_corners(p, layout);
    if (corners_.size() % 3 != 0) {
      document_.fail(p, std::to_string(corners_.size()) + " corners are not a multiple of three");
    }
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      builder_.add_triangle(corners_[i], corners_[i + 1], corners_[i + 2]);
    }
    found += corners_.size() / 3;
  }
  expect_count(element, layout, found);
}

void GeometryReader::read_polylist(pugi::xml_node element, const Layout& layout) {
  for (const char* const single : {"p", "vcount"}) {
    if (const pugi::xml_node second = element.child(single).next_sibling(single)) {
      document_.fail(second, "a second " + describe(second) + " in " + describe(element));
    }
  }
  const pugi::xml_node p = element.child("p");
  corners_.clear();
  if (p) {
    read_corners(p, layout);
  }
  ColladaTokens sizes(document_, element.child("vcount"));
  std::size_t begin = 0;
  std::uint64_t found = 0;
  for (; !sizes.at_end(); ++found) {
    if (found % kRowsPerTick == kRowsPerTick - 1) {
      document_.tick(element);
    }
    const std::uint64_t size = sizes.whole_number();
    if (size > corners_.size() - begin) {
      sizes.fail(ErrorKind::bad_file,
                 "polygon " + std::to_string(found) + " has " + std::to_string(size) +
                     " corners where <p> has " + std::to_string(corners_.size() - begin) + " left",
                 kRepairFile);
    }
    builder_.add_face(std::span(corners_).subspan(begin, static_cast<std::size_t>(size)));
    begin += static_cast<std::size_t>(size);
  }
  if (begin != corners_.size()) {
    document_.fail(p, "<p> has " + std::to_string(corners_.size() - begin) +
                          " corners more than <vcount> states");
  }
  expect_count(element, layout, found);
}

/// Polygons, strips or fans: one for each <p>.
void GeometryReader::read_each_p(pugi::xml_node element, const Layout& layout,
                                 std::string_view name) {
  std::uint64_t found = 0;
  for (const pugi::xml_node p : element.children("p")) {
    if (++found % kRowsPerTick == 0) {
      document_.tick(p);
    }
    read_corners(p, layout);
    if (name == "polygons" || corners_.size() < 3) {
      builder_.add_face(corners_);
      continue;
    }
    for (std::size_t i = 2; i < corners_.size(); ++i) {
      if (name == "trifans") {
        builder_.add_triangle(corners_[0], corners_[i - 1], corners_[i]);
      } else if (i % 2 == 0) {
        builder_.add_triangle(corners_[i - 2], corners_[i - 1], corners_[i]);
      } else {
        builder_.add_triangle(corners_[i - 1], corners_[i - 2], corners_[i]);
      }
    }
  }
  expect_count(element, layout, found);
}

void GeometryReader::read_faces(pugi::xml_node element, std::string_view name) {
  document_.tick(element);
  for (const pugi::xml_node child : element.children()) {
    const std::string_view part = child.name();
    if (part == "ph") {
      document_.fail(child, "a polygon with holes is not read", "export it with triangles only",
                     ErrorKind::unsupported);
    }
    if (part == "vcount" && name != "polylist") {
      document_.fail(child, describe(element) + " has a <vcount>, which only <polylist> has");
    }
    if (part != "p" && part != "input" && part != "vcount") {
      leave_out_unknown(child);
    }
  }
  const Layout layout = read_layout(element);
  if (name == "triangles") {
    read_triangles(element, layout);
  } else if (name == "polylist") {
    read_polylist(element, layout);
  } else {
    read_each_p(element, layout, name);
  }
}

/// An element that may be what faces are called elsewhere; none that says what a file is about.
void GeometryReader::leave_out_unknown(pugi::xml_node element) {
  const std::string_view name = element.name();
  if (element.type() == pugi::node_element && name != "asset" && name != "extra") {
    geometry_.unknown.add(element);
  }
}

void GeometryReader::read_mesh(pugi::xml_node mesh) {
  mesh_ = mesh;
  for (const pugi::xml_node child : mesh.children()) {
    const std::string_view name = child.name();
    if (name == "lines" || name == "linestrips") {
      geometry_.lines.add(child,
                          std::min(document_.whole_number(child, "count", 1), kMaxPrimitives));
    } else if (name == "triangles" || name == "polylist" || name == "polygons" ||
               name == "tristrips" || name == "trifans") {
      read_faces(child, name);
    } else if (name != "source" && name != "vertices") {
      leave_out_unknown(child);
    }
  }
}

ColladaGeometry GeometryReader::read(pugi::xml_node geometry) {
  for (const pugi::xml_node child : geometry.children()) {
    const std::string_view name = child.name();
    if (name == "mesh" || (name == "convex_mesh" && !child.attribute("convex_hull_of"))) {
      if (mesh_) {
        document_.fail(child, "a second mesh in " + describe(geometry));
      }
      read_mesh(child);
    } else if (name == "spline" || name == "brep" || name == "convex_mesh") {
      geometry_.curved.add(child);
    } else {
      leave_out_unknown(child);
    }
  }
  geometry_.faces = builder_.face_count();
  geometry_.mesh = builder_.finish();
  return std::move(geometry_);
}

}  // namespace

ColladaGeometry read_geometry(ColladaDocument& document, pugi::xml_node geometry) {
  return GeometryReader(document).read(geometry);
}

}  // namespace soms::detail
