#include "soms/io/read_mesh.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/crs.h"
#include "soms/io/detail/file.h"
#include "soms/io/detail/format.h"
#include "soms/io/detail/import/import.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/source.h"

#include <algorithm>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms {

namespace {

constexpr std::uint64_t kAllowance = std::uint64_t{64} << 20;
constexpr std::uint64_t kFactor = 64;

std::uint64_t memory_limit(const ReadOptions& options, std::uint64_t size) {
  if (options.max_memory > 0) {
    return options.max_memory;
  }
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return size > (kMost - kAllowance) / kFactor ? kMost : kFactor * size + kAllowance;
}

/// Where to look for files that a model names: a pipe or a device has no folder of its own, nor has
/// a file that is named by its descriptor (/dev/stdin, /dev/fd/3, /proc/self/fd/3).
std::optional<std::filesystem::path> references_folder(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) {
    return std::nullopt;
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::string inside = std::filesystem::canonical(folder, unknown).string();
  if (inside == "/dev" || inside.starts_with("/proc/")) {
    return std::nullopt;
  }
  return folder;
}

/// Fails where a mesh has notes: the error has their texts. Those of an imported mesh never end, so
/// that no repair helps.
void refuse_notes(const detail::Source& source, const Mesh& mesh, bool imported) {
  if (mesh.notes.empty()) {
    return;
  }
  source.fail(ErrorKind::bad_file, detail::joined(mesh.notes),
              imported ? "convert the model first (soms convert IN OUT.glb), or read it without "
                         "`strict`"
                       : "repair the model, or read it without `strict`");
}

/// Longer names of reference systems are not kept: every row of an answer would repeat them.
constexpr std::size_t kLongestName = 1000;

/// What the reader of a georeference should know.
void judge_georeference(Mesh& mesh) {
  Georeference& place = mesh.georeference;
  const std::size_t longest = std::max(place.crs.size(), place.vertical_datum.size());
  if (longest > kLongestName) {
    place = {};
    mesh.notes.push_back("a reference system with a name of " + std::to_string(longest) +
                         " bytes, not read");
  }
  if (!place.map_conversion && crs_axes(place.crs).angles) {
    mesh.notes.push_back(angles_note(place.crs));
  }
}

/// Whose memory the bytes of a file are.
enum class Owner { caller, us };

Mesh read_bytes(std::string_view bytes, const std::string& name, Owner owner,
                std::optional<std::filesystem::path> folder, const ReadOptions& options,
                const Limits& limits) {
  const PlainArithmetic plain;
  detail::Source source{.bytes = bytes,
                        .name = name,
                        .allow_empty = options.allow_empty,
                        .folder = std::move(folder),
                        .import_seconds = options.import_seconds,
                        .lod = options.lod,
                        .surfaces = options.surfaces,
                        .budget = detail::Budget(memory_limit(options, bytes.size())),
                        .memory_per_byte = options.max_memory > 0 ? 0 : kFactor,
                        .limits = limits,
                        .forgettable = owner == Owner::us};
  const std::uint64_t taken = owner == Owner::us ? bytes.size() : 0;
  if (!source.budget.take(taken)) {
    source.fail_memory(taken);
  }
  detail::skip_byte_order_mark(source);
  const detail::ReadFormat& format = detail::identify(source);
  Mesh mesh = format.read(source);
  source.tick(source.bytes.size());
  if ((options.lod || options.surfaces) && !source.is_city) {
    source.fail(ErrorKind::usage,
                "it is no CityJSON, so it has no levels of detail and no semantic surfaces",
                "leave lod and surfaces out for it");
  }
  judge_georeference(mesh);
  if (options.strict) {
    refuse_notes(source, mesh, format.read == detail::read_import);
  }
  return mesh;
}

[[noreturn]] void fail_machine(const std::string& name) {
  throw Error(ErrorKind::out_of_memory, name + ": not enough free memory on this machine",
              "free some memory, or use a smaller model");
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& path, const ReadOptions& options,
               const Limits& limits) {
  try {
    check(limits);
    const detail::FileBytes bytes = detail::read_file(path, options.max_memory, limits);
    return read_bytes(bytes.view(), path.string(), Owner::us, references_folder(path), options,
                      limits);
  } catch (const std::bad_alloc&) {
    fail_machine(path.string());
  }
}

Mesh read_mesh(std::span<const std::byte> bytes, const std::string& name,
               const ReadOptions& options, const Limits& limits) {
  try {
    check(limits);
    const auto* data = reinterpret_cast<const char*>(bytes.data());
    return read_bytes({data, bytes.size()}, name, Owner::caller, std::nullopt, options, limits);
  } catch (const std::bad_alloc&) {
    fail_machine(name);
  }
}

}  // namespace soms
