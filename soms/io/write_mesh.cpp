#include "soms/io/write_mesh.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/ending.h"
#include "soms/io/detail/glb_writer.h"
#include "soms/io/detail/mesh_writer.h"
#include "soms/io/detail/output.h"
#include "soms/io/formats.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace soms {

MeshFormat format_for(const std::filesystem::path& path) {
  const std::string ending = detail::ending_of(path.string());
  for (const WritableFormat& row : writable_formats()) {
    if (!ending.empty() && row.ending == ending) {
      return row.format;
    }
  }
  throw Error(ErrorKind::unsupported,
              path.string() + ": the name does not end with a format that is written",
              "end it with " + writable_endings());
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, MeshFormat format,
                const Parallel& parallel) {
  const PlainArithmetic plain;
  detail::OutputFile file(path);
  detail::Output output([&](std::string_view bytes) { file.write(bytes); });
  detail::write_mesh(output, path.string(), mesh, format, parallel);
  file.commit();
}

void write_mesh(std::ostream& out, const std::string& name, const Mesh& mesh, MeshFormat format,
                const Parallel& parallel) {
  const PlainArithmetic plain;
  const auto check_stream = [&] {
    if (!out) {
      throw Error(ErrorKind::cannot_write, name + ": the stream takes no more",
                  "check that it is open and has room");
    }
  };
  detail::Output output([&](std::string_view bytes) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    check_stream();
  });
  check_stream();
  detail::write_mesh(output, name, mesh, format, parallel);
  out.flush();
  check_stream();
}

Rounding rounding(const Mesh& mesh, MeshFormat format) {
  const PlainArithmetic plain;
  Rounding result;
  if (entry(format).doubles) {
    return result;
  }
  const Vec3 origin = format == MeshFormat::glb ? detail::glb_origin(mesh) : Vec3{};
  for (const Vec3& v : mesh.vertices) {
    const Vec3 moved = detail::glb_read_back(v, origin) - v;
    if (moved != Vec3{}) {
      ++result.count;
      result.most =
          std::max({result.most, std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)});
    }
  }
  return result;
}

std::uint64_t count_rounded(const Mesh& mesh, MeshFormat format) {
  return rounding(mesh, format).count;
}

}  // namespace soms
