// A reader on any bytes: a typed error or a sound mesh, in bounded memory; and what was read is the
// same when it is written as PLY and read again. One program for each format (read_format.cpp).
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "tests/fuzz/read_format.h"
#include "tests/fuzz/require.h"
#include "tests/support/allocation.h"

#include <cstdint>
#include <span>
#include <sstream>
#include <string>

namespace soms {
namespace {

using fuzz::require;

constexpr std::uint64_t kMemory = std::uint64_t{16} << 20;
/// Beyond the reader's budget: what a parser of JSON or XML makes of the file itself, and words.
constexpr std::uint64_t kFactor = 64;
constexpr std::uint64_t kMore = std::uint64_t{1} << 20;

/// The folder does not exist, so that no file beside the input is found.
std::string file_name() {
  return std::string("/nonexistent/input.") + fuzz::kFormat;
}

Mesh read(std::span<const std::byte> bytes, const std::string& name) {
  return read_mesh(bytes, name, {.allow_empty = true, .max_memory = kMemory});
}

void check_refusal(const Error& error) {
  require(error.kind() != ErrorKind::usage, "a bad file is no misuse");
  require(!error.place().empty() && !error.remedy().empty(), "an error without words");
  require(error.place().find(file_name()) != std::string::npos, "an error without the file");
}

void check_written(const Mesh& mesh) {
  std::ostringstream out;
  write_mesh(out, "out.ply", mesh, MeshFormat::ply);
  const std::string bytes = out.str();
  const Mesh again = read_mesh(std::as_bytes(std::span(bytes)), "out.ply", {.allow_empty = true});
  require(again.vertices == mesh.vertices, "vertices after writing");
  require(again.triangles == mesh.triangles, "triangles after writing");
}

void check_input(std::span<const std::byte> bytes) {
  Mesh mesh;
  const test::AllocationWatch watch;
  try {
    mesh = read(bytes, file_name());
  } catch (const Error& error) {
    check_refusal(error);
    require(watch.peak() <= kMemory + kMore + kFactor * bytes.size(), "memory of a refused file");
    return;
  }
  require(watch.peak() <= kMemory + kMore + kFactor * bytes.size(), "memory of a mesh");
  check(mesh);
  check_written(mesh);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soms::check_input(std::as_bytes(std::span(data, size)));
  return 0;
}
