#include "soms/io/detail/mesh_writer.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/geometry/part_runs.h"
#include "soms/io/detail/gltf/glb_writer.h"
#include "soms/io/detail/simple/obj_groups.h"
#include "soms/io/detail/simple/three_ds_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

namespace {

class MeshWriter {
 public:
  MeshWriter(Output& output, const std::string& name, const MeshView& mesh, const Limits& limits)
      : output_(output), name_(name), mesh_(mesh), limits_(limits) {}

  void ply_binary();
  void ply_text();
  void obj();
  void off();
  void stl_binary();
  void stl_text();

 private:
  /// Calls `use` for numbers 0 to count-1, with progress from `from` to `to`.
  template <class Use>
  void each(std::size_t count, double from, double to, const Use& use) const;
  void ply_header(std::string_view format);
  void put_vertex(const Vec3& v);
  void put_vertices(std::string_view before);
  void put_indices(const std::array<std::uint32_t, 3>& triangle, std::uint64_t base);
  void check_vertex(std::size_t i) const;
  void put_float(double value, std::size_t triangle);
  void put_facet(std::size_t triangle);

  Output& output_;
  const std::string& name_;
  MeshView mesh_;
  const Limits& limits_;
};

template <class Use>
void MeshWriter::each(std::size_t count, double from, double to, const Use& use) const {
  constexpr std::size_t kPiecesPerTick = 1 << 16;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kPiecesPerTick == 0) {
      check(limits_);
      if (limits_.progress) {
        limits_.progress(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
      }
    }
    use(i);
  }
}

/// Vertices that no triangle uses are written too, so they must be numbers as well.
void MeshWriter::check_vertex(std::size_t i) const {
  const Vec3& v = mesh_.vertices[i];
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    throw Error(ErrorKind::not_finite, name_ + ": vertex " + std::to_string(i) + " is not finite",
                "repair the vertex");
  }
}

void MeshWriter::ply_header(std::string_view format) {
  output_.put("ply\nformat ");
  output_.put(format);
  output_.put(" 1.0\nelement vertex ");
  output_.put_number(std::uint64_t{mesh_.vertices.size()});
  output_.put("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  output_.put_number(std::uint64_t{mesh_.triangles.size()});
  output_.put("\nproperty list uchar int vertex_indices\nend_header\n");
}

void MeshWriter::put_vertex(const Vec3& v) {
  output_.put_number(v.x);
  output_.put(' ');
  output_.put_number(v.y);
  output_.put(' ');
  output_.put_number(v.z);
  output_.put('\n');
}

void MeshWriter::put_vertices(std::string_view before) {
  each(mesh_.vertices.size(), 0, 0.5, [&](std::size_t i) {
    check_vertex(i);
    output_.put(before);
    put_vertex(mesh_.vertices[i]);
  });
}

void MeshWriter::put_indices(const std::array<std::uint32_t, 3>& triangle, std::uint64_t base) {
  for (const std::uint32_t v : triangle) {
    output_.put(' ');
    output_.put_number(base + v);
  }
  output_.put('\n');
}

void MeshWriter::ply_binary() {
  ply_header("binary_little_endian");
  each(mesh_.vertices.size(), 0, 0.5, [&](std::size_t i) {
    check_vertex(i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      output_.put_bits(bit_cast<std::uint64_t>(mesh_.vertices[i][axis]), 8);
    }
  });
  each(mesh_.triangles.size(), 0.5, 1, [&](std::size_t i) {
    output_.put_bits(3, 1);
    for (const std::uint32_t v : mesh_.triangles[i]) {
      output_.put_bits(v, 4);
    }
  });
}

void MeshWriter::ply_text() {
  ply_header("ascii");
  put_vertices("");
  each(mesh_.triangles.size(), 0.5, 1, [&](std::size_t i) {
    output_.put('3');
    put_indices(mesh_.triangles[i], 0);
  });
}

void MeshWriter::off() {
  output_.put("OFF\n");
  output_.put_number(std::uint64_t{mesh_.vertices.size()});
  output_.put(' ');
  output_.put_number(std::uint64_t{mesh_.triangles.size()});
  output_.put(" 0\n");
  put_vertices("");
  each(mesh_.triangles.size(), 0.5, 1, [&](std::size_t i) {
    output_.put('3');
    put_indices(mesh_.triangles[i], 0);
  });
}

void MeshWriter::obj() {
  // Else nothing would be written, and a file without bytes is no model.
  if (mesh_.vertices.empty()) {
    output_.put("# no vertices and no faces\ng\n");
  }
  put_vertices("v ");
  const std::vector<ObjGroupLines> groups = obj_groups(mesh_).lines;
  auto group = groups.begin();
  each(mesh_.triangles.size(), 0.5, 1, [&](std::size_t i) {
    if (group != groups.end() && group->triangle == i) {
      output_.put(group->lines);
      ++group;
    }
    output_.put('f');
    put_indices(mesh_.triangles[i], 1);
  });
}

/// The right-handed unit normal, zero for a triangle without area; edges are scaled first, so that
/// nothing overflows.
Vec3 unit_normal(const Triangle& t) {
  const auto largest = [](const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  };
  Vec3 e = t.b - t.a;
  Vec3 f = t.c - t.a;
  const double reach = std::max(largest(e), largest(f));
  if (reach == 0) {
    return {};
  }
  const int exponent = -std::ilogb(reach);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    e[axis] = std::ldexp(e[axis], exponent);
    f[axis] = std::ldexp(f[axis], exponent);
  }
  const Vec3 normal = cross(e, f);
  const double length = std::sqrt(dot(normal, normal));
  return length > 0 ? Vec3{normal.x / length, normal.y / length, normal.z / length} : Vec3{};
}

void MeshWriter::put_float(double value, std::size_t triangle) {
  const auto narrow = static_cast<float>(value);
  if (!std::isfinite(narrow)) {
    throw Error(ErrorKind::out_of_range,
                name_ + ": triangle " + std::to_string(triangle) +
                    " has a coordinate that a float cannot hold",
                "write PLY, OBJ or OFF, or text STL");
  }
  output_.put_bits(bit_cast<std::uint32_t>(narrow), 4);
}

void MeshWriter::stl_binary() {
  // The header must not begin with "solid", which would look like text.
  std::string header = "binary STL by soms";
  header.resize(80, ' ');
  output_.put(header);
  output_.put_bits(mesh_.triangles.size(), 4);
  each(mesh_.triangles.size(), 0, 1, [&](std::size_t i) {
    const Triangle t = mesh_.triangle(static_cast<TriangleId>(i));
    for (const Vec3& v : {unit_normal(t), t.a, t.b, t.c}) {
      put_float(v.x, i);
      put_float(v.y, i);
      put_float(v.z, i);
    }
    output_.put_bits(0, 2);
  });
}

void MeshWriter::put_facet(std::size_t triangle) {
  const Triangle t = mesh_.triangle(static_cast<TriangleId>(triangle));
  output_.put("facet normal ");
  put_vertex(unit_normal(t));
  output_.put("outer loop\n");
  for (const Vec3& v : {t.a, t.b, t.c}) {
    output_.put("vertex ");
    put_vertex(v);
  }
  output_.put("endloop\nendfacet\n");
}

void MeshWriter::stl_text() {
  std::vector<PartRun> runs = part_runs(mesh_);
  if (runs.empty()) {
    runs.push_back({});
  }
  const auto line = [&](std::string_view token, const PartRun& run) {
    const std::string name =
        run.part == Part::kNoParent ? std::string() : line_name(mesh_.parts[run.part].name);
    output_.put(token);
    output_.put(name.empty() ? "" : " ");
    output_.put(name);
    output_.put('\n');
  };
  auto run = runs.begin();
  line("solid", *run);
  each(mesh_.triangles.size(), 0, 1, [&](std::size_t i) {
    const auto next = run + 1;
    if (next != runs.end() && next->first == i) {
      line("endsolid", *run);
      run = next;
      line("solid", *run);
    }
    put_facet(i);
  });
  line("endsolid", *run);
}

}  // namespace

void write_mesh(Output& output, const std::string& name, const MeshView& mesh, MeshFormat format,
                const Limits& limits) {
  check(mesh);
  MeshWriter writer(output, name, mesh, limits);
  switch (format) {
    case MeshFormat::ply:
      writer.ply_binary();
      break;
    case MeshFormat::ply_ascii:
      writer.ply_text();
      break;
    case MeshFormat::obj:
      writer.obj();
      break;
    case MeshFormat::stl:
      writer.stl_binary();
      break;
    case MeshFormat::stl_ascii:
      writer.stl_text();
      break;
    case MeshFormat::off:
      writer.off();
      break;
    case MeshFormat::three_ds:
      write_three_ds(output, name, mesh, limits);
      break;
    case MeshFormat::glb:
      write_glb(output, name, mesh, limits);
      break;
  }
  output.flush();
  if (limits.progress) {
    limits.progress(1);
  }
}

}  // namespace soms::detail
