#include "soms/io/write_mesh.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/file_extension.h"
#include "soms/io/detail/gltf/glb_writer.h"
#include "soms/io/detail/mesh_writer.h"
#include "soms/io/detail/output.h"
#include "soms/io/detail/simple/obj_groups.h"
#include "soms/io/detail/simple/three_ds_writer.h"
#include "soms/io/formats.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

namespace soms {

namespace {

/// STL and 3DS have no place for vertices that no triangle uses.
std::vector<bool> written_vertices(const MeshView& mesh, MeshFormat format) {
  const bool all = format != MeshFormat::stl && format != MeshFormat::three_ds;
  std::vector<bool> written(mesh.vertices.size(), all);
  if (!all) {
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) {
        written[v] = true;
      }
    }
  }
  return written;
}

}  // namespace

MeshFormat format_for(const std::filesystem::path& path) {
  const std::string extension = detail::extension_of(path.string());
  for (const WritableFormat& row : writable_formats()) {
    if (!extension.empty() && row.extension == extension) {
      return row.format;
    }
  }
  throw Error(ErrorKind::unsupported,
              path.string() + ": the extension is not that of a format that can be written",
              "use " + writable_extensions());
}

void write_mesh(const std::filesystem::path& path, const MeshView& mesh, MeshFormat format,
                const Limits& limits) {
  const PlainArithmetic plain;
  detail::OutputFile file(path);
  detail::Output output([&](std::string_view bytes) { file.write(bytes); });
  detail::write_mesh(output, path.string(), mesh, format, limits);
  file.commit();
}

void write_mesh(std::ostream& out, const std::string& name, const MeshView& mesh, MeshFormat format,
                const Limits& limits) {
  const PlainArithmetic plain;
  const auto check_stream = [&] {
    if (!out) {
      throw Error(ErrorKind::cannot_write, name + ": cannot write to the stream",
                  "check that it is open and that there is free space");
    }
  };
  detail::Output output([&](std::string_view bytes) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    check_stream();
  });
  check_stream();
  detail::write_mesh(output, name, mesh, format, limits);
  out.flush();
  check_stream();
}

Rounding rounding(const MeshView& mesh, MeshFormat format) {
  const PlainArithmetic plain;
  Rounding result;
  if (entry(format).doubles) {
    return result;
  }
  const Vec3 origin = format == MeshFormat::glb ? detail::glb_origin(mesh) : Vec3{};
  const std::vector<bool> written = written_vertices(mesh, format);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!written[i]) {
      continue;
    }
    const Vec3& v = mesh.vertices[i];
    const Vec3 moved = detail::glb_read_back(v, origin) - v;
    if (moved != Vec3{}) {
      ++result.count;
      result.most =
          std::max({result.most, std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)});
    }
  }
  return result;
}

std::uint64_t count_rounded(const MeshView& mesh, MeshFormat format) {
  return rounding(mesh, format).count;
}

std::uint64_t count_renamed(const MeshView& mesh, MeshFormat format) {
  return format == MeshFormat::three_ds ? detail::renamed_in_three_ds(mesh)
         : format == MeshFormat::obj    ? detail::obj_groups(mesh).renamed
                                        : 0;
}

}  // namespace soms
