#include "apps/shards/receipt.h"

#include "soms/base/error.h"

#include "apps/output/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace soms::command {

namespace {

constexpr std::streamoff kEnd = 65536;  // bytes of each end of a file of poses

/// The first and the last bytes of a file, or all of them.
std::string ends_of(const std::string& path, std::streamoff size) {
  std::ifstream in(path, std::ios::binary);
  const std::streamoff each = std::min(size, kEnd);
  std::string bytes(static_cast<std::size_t>(2 * each), '\0');
  in.read(bytes.data(), each);
  in.seekg(size - each);
  in.read(bytes.data() + each, each);
  return bytes;
}

/// Whether a value has the form of a receipt.
bool has_form(const Json& value) {
  if (!value.is_object() || value.value("schema", Json()) != Json(kShardSchema) ||
      !value.contains("rows") || !value.contains("of") || !value.contains("files") ||
      !value["rows"].is_array() || value["rows"].size() != 2 || !value["files"].is_object()) {
    return false;
  }
  return value["rows"][0].is_number_unsigned() && value["rows"][1].is_number_unsigned() &&
         value["of"].is_number_unsigned();
}

bool is_of_the_shard_alone(std::string_view key) {
  return key == "rows" || key == "files";
}

}  // namespace

RowRange Receipt::rows() const {
  return {value["rows"][0].get<std::uint64_t>(), value["rows"][1].get<std::uint64_t>()};
}

std::uint64_t Receipt::of() const {
  return value["of"].get<std::uint64_t>();
}

std::vector<std::string> Receipt::kinds() const {
  std::vector<std::string> kinds;
  for (const auto& [kind, entry] : value["files"].items()) {
    kinds.push_back(kind);
  }
  return kinds;
}

std::filesystem::path Receipt::file(const std::string& kind) const {
  std::filesystem::path file = path;
  return file.replace_extension("." + kind);
}

bool Receipt::is_whole(const std::string& kind) const {
  std::error_code missing;
  const std::filesystem::path file = this->file(kind);
  return value["files"].contains(kind) && std::filesystem::is_regular_file(file, missing) &&
         file_entry(file) == value["files"][kind];
}

Receipt read_receipt(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw Error(ErrorKind::cannot_open, path.string() + ": cannot be read",
                "give a folder that can be read");
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Receipt receipt{path, parse_json(text, kDeepestReceipt).value};
  if (!has_form(receipt.value)) {
    throw Error(ErrorKind::bad_file, path.string() + ": no receipt of a shard",
                "give a folder of its own to the shards, or remove this file");
  }
  return receipt;
}

Json file_entry(const std::filesystem::path& path) {
  std::error_code unknown;
  return {{"bytes", std::uint64_t{std::filesystem::file_size(path, unknown)}},
          {"sha256", sha256_of_file(path)}};
}

Json model_entry(const MeshView& mesh) {
  return {{"triangles", std::uint64_t{mesh.triangles.size()}},
          {"hash", fmt::format("{:016x}", corner_hash(mesh))}};
}

Json model_entry(const TileSet& tiles) {
  return {{"triangles", tiles.triangles()}, {"hash", fmt::format("{:016x}", tiles.hash())}};
}

Json poses_entry(const std::optional<std::string>& text, const std::optional<std::uint64_t>& rows) {
  std::error_code none;
  if (!text) {
    return nullptr;
  }
  if (!std::filesystem::is_regular_file(*text, none)) {
    return *text;
  }
  const std::uint64_t size = std::filesystem::file_size(*text, none);
  return {{"rows", rows.value_or(1)},
          {"bytes", size},
          {"ends", sha256(ends_of(*text, static_cast<std::streamoff>(size)))}};
}

std::optional<std::string> difference(const Json& a, const Json& b) {
  if (!a.is_object() || !b.is_object()) {
    return a == b ? std::nullopt : std::optional(std::string());
  }
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& [key, value] : one->items()) {
      if (is_of_the_shard_alone(key)) {
        continue;
      }
      if (!other->contains(key)) {
        return key;
      }
      if (const auto inner = difference(value, other->at(key))) {
        return inner->empty() ? key : key + "." + *inner;
      }
    }
  }
  return std::nullopt;
}

}  // namespace soms::command
