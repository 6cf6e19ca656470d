#include "soms/io/write_mesh.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/ending.h"
#include "soms/io/detail/glb_writer.h"
#include "soms/io/detail/mesh_writer.h"
#include "soms/io/detail/output.h"

#include <algorithm>
#include <ostream>

namespace soms {

MeshFormat format_for(const std::filesystem::path& path) {
  const std::string ending = detail::ending_of(path.string());
  if (ending == ".ply") {
    return MeshFormat::ply;
  }
  if (ending == ".obj") {
    return MeshFormat::obj;
  }
  if (ending == ".stl") {
    return MeshFormat::stl;
  }
  if (ending == ".off") {
    return MeshFormat::off;
  }
  if (ending == ".3ds") {
    return MeshFormat::three_ds;
  }
  if (ending == ".glb") {
    return MeshFormat::glb;
  }
  throw Error(ErrorKind::unsupported,
              path.string() + ": the name does not end with a format that is written",
              "end it with .ply, .3ds, .stl, .off, .obj or .glb");
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

std::uint64_t count_rounded(const Mesh& mesh, MeshFormat format) {
  if (format != MeshFormat::stl && format != MeshFormat::three_ds && format != MeshFormat::glb) {
    return 0;
  }
  const Vec3 origin = format == MeshFormat::glb ? detail::glb_origin(mesh) : Vec3{};
  return static_cast<std::uint64_t>(
      std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                    [&](const Vec3& v) { return detail::glb_read_back(v, origin) != v; }));
}

}  // namespace soms
