#include "soms/io/detail/mesh_builder.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

/// Bytes a corner of a polygon that the triangulator and the copy of its corners take for a while.
constexpr std::uint64_t kBytesPerCorner = 80;
/// Smaller polygons' memory is lost in the allowance.
constexpr std::size_t kLargePolygon = 4096;

}  // namespace

/// Makes the map triangle -> face of what was the identity so far.
void MeshBuilder::map_faces() {
  mapped_ = true;
  reserve(mesh_.faces, mesh_.triangles.size());
  for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
    push(mesh_.faces, i);
  }
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) {
    add_triangle(corners[0], corners[1], corners[2]);
    return;
  }
  if (!mapped_) {
    map_faces();
  }
  if (corners.size() < 3) {
    // Triangles are bounded by their number, these by nothing else.
    if (face_ >= kMaxPrimitives) {
      source_.fail(ErrorKind::out_of_range, "more than 2^31 - 1 faces", "split the model");
    }
    thin_faces_.add([&] { return "at face " + std::to_string(face_); });
    ++face_;
    return;
  }
  const std::uint64_t extra =
      corners.size() > kLargePolygon ? kBytesPerCorner * corners.size() : std::uint64_t{0};
  take(extra);
  corners_.clear();
  for (const std::uint32_t v : corners) {
    corners_.push_back(mesh_.vertices[v]);
  }
  for (const auto& [a, b, c] : triangulator_.triangulate(corners_, source_.limits)) {
    push(mesh_.triangles, {corners[a], corners[b], corners[c]});
    push(mesh_.faces, face_);
  }
  ++face_;
  source_.budget.give_back(extra);
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners,
                           std::span<const std::size_t> ends) {
  if (ends.size() < 2) {
    add_face(corners);
    return;
  }
  const std::uint64_t extra = kBytesPerCorner * corners.size();
  take(extra);
  corners_.clear();
  for (const std::uint32_t v : corners) {
    corners_.push_back(mesh_.vertices[v]);
  }
  joined_.clear();
  for (const std::uint32_t i : hole_joiner_.join(corners_, ends, source_.limits)) {
    joined_.push_back(corners[i]);
  }
  lost_holes_.add([&] { return "at face " + std::to_string(face_); }, hole_joiner_.left_out());
  add_face(joined_);
  source_.budget.give_back(extra);
}

void MeshBuilder::add_instance(const MeshView& mesh, std::uint32_t first, std::uint32_t faces,
                               bool turned) {
  if (face_ + std::uint64_t{faces} > kMaxPrimitives) {
    source_.fail(ErrorKind::out_of_range, "more than 2^31 - 1 faces", "split the model");
  }
  if (!mapped_ && (!mesh.faces.empty() || faces != mesh.triangles.size())) {
    map_faces();
  }
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    push(mesh_.triangles, {first + a, first + (turned ? c : b), first + (turned ? b : c)});
    if (mapped_) {
      push(mesh_.faces, face_ + (mesh.faces.empty() ? i : mesh.faces[i]));
    }
  }
  face_ += faces;
}

void MeshBuilder::take(std::uint64_t bytes) {
  if (!source_.budget.take(bytes)) {
    source_.fail_memory(bytes);
  }
}

void MeshBuilder::note(std::string text) {
  // A list that doubles has three places for each of its texts while it grows.
  take(3 * sizeof(std::string) + text.capacity());
  mesh_.notes.push_back(std::move(text));
}

void MeshBuilder::note(const LeftOut& left_out, std::string_view what) {
  if (left_out.count() > 0) {
    note(left_out.note(what));
  }
}

void MeshBuilder::open_part(std::string_view name) {
  // A file may name a part once and show it a million times. What the names of parts without
  // triangles took is not given back: copying them takes time, which the memory's limit bounds.
  take(name.size());
  const std::uint32_t parent = open_parts_.empty() ? Part::kNoParent : open_parts_.back();
  const auto first = static_cast<std::uint32_t>(mesh_.triangles.size());
  push(open_parts_, static_cast<std::uint32_t>(mesh_.parts.size()));
  push(mesh_.parts, {std::string(name), parent, first, 0});
}

void MeshBuilder::continue_part(std::uint32_t first) {
  const std::string name = mesh_.parts[first].name;
  open_part(name);
  mesh_.parts.back().continues = first;
}

void MeshBuilder::describe_part(std::string_view id, std::string_view type,
                                std::vector<Attribute> attributes) {
  std::uint64_t bytes = id.size() + type.size() + attributes.capacity() * sizeof(Attribute);
  for (const Attribute& attribute : attributes) {
    bytes += attribute.name.size() + attribute.value.size();
  }
  take(bytes);
  Part& part = mesh_.parts[open_parts_.back()];
  part.id = id;
  part.type = type;
  part.attributes = std::move(attributes);
}

void MeshBuilder::close_part() {
  Part& part = mesh_.parts[open_parts_.back()];
  part.count = static_cast<std::uint32_t>(mesh_.triangles.size()) - part.first;
  // Parts within it have no triangles either, so they are gone and this is the last.
  if (part.count == 0) {
    mesh_.parts.pop_back();
  }
  open_parts_.pop_back();
}

void MeshBuilder::begin_part(std::string_view name) {
  if (!open_parts_.empty()) {
    close_part();
  }
  name_triangles_before_parts();
  open_part(name);
}

/// Triangles before the first name are a part without one.
void MeshBuilder::name_triangles_before_parts() {
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  if (mesh_.parts.empty() && count > 0) {
    push(mesh_.parts, {"", Part::kNoParent, 0, count});
  }
}

void MeshBuilder::begin_object(std::string_view name) {
  close_group();
  groups_.clear();
  source_.budget.give_back(std::exchange(group_bytes_, 0));
  begin_part(name);
  in_object_ = true;
}

void MeshBuilder::begin_group(std::string_view name) {
  const std::size_t around = in_object_ ? 1 : 0;
  const bool is_open = open_parts_.size() > around;
  if (in_object_ && name.empty()) {
    close_group();
    return;
  }
  if (is_open && mesh_.parts[open_parts_.back()].name == name) {
    return;
  }
  close_group();
  name_triangles_before_parts();
  if (groups_.empty() && !in_object_ && !mesh_.parts.empty()) {
    groups_.emplace("", 0);  // the triangles before the first name
  }
  const auto known = groups_.find(name);
  if (known == groups_.end()) {
    open_part(name);
  } else {
    continue_part(known->second);
  }
}

/// Closes the group that is open, if one is, and keeps its name if it has triangles.
void MeshBuilder::close_group() {
  if (open_parts_.size() == (in_object_ ? 1U : 0U)) {
    return;
  }
  const std::uint32_t group = open_parts_.back();
  close_part();
  if (group < mesh_.parts.size() && mesh_.parts[group].continues == Part::kNoParent) {
    constexpr std::uint64_t kBytesPerGroup = 128;  // a node of a tree, and the name behind it
    const std::uint64_t bytes = kBytesPerGroup + mesh_.parts[group].name.size();
    take(bytes);
    group_bytes_ += bytes;
    groups_.emplace(mesh_.parts[group].name, group);
  }
}

Mesh MeshBuilder::finish() {
  while (!open_parts_.empty()) {
    close_part();
  }
  note(thin_faces_, kThinFaces);
  note(lost_holes_, "holes that cross their outline or lie outside of it, not cut out");
  if (mesh_.triangles.empty() && !source_.allow_empty) {
    source_.fail(ErrorKind::empty_mesh,
                 "no triangles (" + std::to_string(mesh_.vertices.size()) + " vertices" +
                     (mesh_.notes.empty() ? "" : "; " + joined(mesh_.notes)) + ")",
                 "give a model with faces, or allow an empty one (allow_empty)");
  }
  mesh_.source = source_.name;
  return std::move(mesh_);
}

}  // namespace soms::detail
