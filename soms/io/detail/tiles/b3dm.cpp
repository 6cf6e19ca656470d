#include "soms/io/detail/tiles/b3dm.h"

#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/json_numbers.h"
#include "soms/io/detail/numbers/little_endian.h"
#include "soms/io/detail/tiles/batch_table.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::size_t kBatchedHeader = 28;

/// Where the sections of a batched model stand.
struct Sections {
  FileSection feature_json;
  FileSection feature_numbers;
  FileSection batch_json;
  FileSection batch_numbers;
  std::size_t glb = 0;
  std::size_t end = 0;  ///< stated
};

Sections sections_of(const Source& source, std::size_t begin, std::size_t end) {
  Sections sections;
  const std::size_t size = tile_size(source, begin, end, kBatchedHeader);
  sections.end = begin + size;
  std::size_t at = begin + kBatchedHeader;
  constexpr std::size_t kFirstLength = 12;
  std::size_t length_at = begin + kFirstLength;
  for (const auto& [section, name] :
       {std::pair{&sections.feature_json, "feature table's JSON"},
        std::pair{&sections.feature_numbers, "feature table's numbers"},
        std::pair{&sections.batch_json, "batch table's JSON"},
        std::pair{&sections.batch_numbers, "batch table's numbers"}}) {
    const std::size_t length = little_endian<std::uint32_t>(source.bytes, length_at);
    if (length > sections.end - at) {
      source.fail_byte(length_at, ErrorKind::bad_file,
                       "the " + std::string(name) + " states " + std::to_string(length) +
                           " bytes, but " + std::to_string(sections.end - at) + " are left",
                       kRepairTile);
    }
    *section = {source.bytes.substr(at, length), at};
    at += length;
    length_at += sizeof(std::uint32_t);
  }
  sections.glb = at;
  if (sections.glb == sections.end) {
    source.fail_byte(at, ErrorKind::bad_file, "the glTF of the tile is missing", kRepairTile);
  }
  if (!is_glb(source.bytes.substr(at))) {
    source.fail_byte(at, ErrorKind::bad_file, "the glTF of the tile does not begin with \"glTF\"",
                     kRepairTile);
  }
  return sections;
}

/// The bytes of a value that stands among the numbers of the feature table.
std::string_view numbers_at(const JsonValue& value, std::string_view numbers, std::size_t size) {
  const std::uint64_t at = value.at("byteOffset").whole();
  if (at > numbers.size() || size > numbers.size() - at) {
    value.fail(std::to_string(size) + " bytes from byte " + std::to_string(at) +
               ", but the table's numbers have " + std::to_string(numbers.size()) + " bytes");
  }
  return numbers.substr(static_cast<std::size_t>(at), size);
}

std::uint64_t batch_length_of(const JsonValue& table, std::string_view numbers) {
  const JsonValue length = table.at("BATCH_LENGTH");
  return length.is_object()
             ? little_endian<std::uint32_t>(numbers_at(length, numbers, sizeof(std::uint32_t)), 0)
             : length.whole();
}

/// The center that coordinates are relative to: zeros where none is stated.
std::array<double, 3> rtc_center_of(const JsonValue& table, std::string_view numbers) {
  const std::optional<JsonValue> center = table.find("RTC_CENTER");
  if (!center) {
    return {0, 0, 0};
  }
  if (!center->is_object()) {
    return json_numbers<3>(*center);
  }
  const std::string_view bytes = numbers_at(*center, numbers, 3 * sizeof(float));
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = little_endian<float>(bytes, i * sizeof(float));
    values[i] = value;
  }
  return values;
}

}  // namespace

std::size_t tile_size(const Source& source, std::size_t begin, std::size_t end, std::size_t least) {
  const std::size_t left = end - begin;
  if (left < least) {
    source.fail_byte(begin, ErrorKind::bad_file,
                     "the header of the tile is cut off: " + std::to_string(left) + " of " +
                         std::to_string(least) + " bytes",
                     kRepairTile);
  }
  const auto version = little_endian<std::uint32_t>(source.bytes, begin + 4);
  if (version != 1) {
    source.fail_byte(begin + 4, ErrorKind::unsupported,
                     "version " + std::to_string(version) + " of this tile is not read, only 1",
                     "save the tiles as 3D Tiles 1.0 or 1.1");
  }
  const std::size_t size = little_endian<std::uint32_t>(source.bytes, begin + 8);
  if (size < least || size > left) {
    source.fail_byte(begin + 8, ErrorKind::bad_file,
                     "the header states " + std::to_string(size) + " bytes, but " +
                         std::to_string(left) + " are there",
                     kRepairTile);
  }
  return size;
}

Mesh read_b3dm(Source& source, std::size_t begin, std::size_t end, const TileFrame& frame) {
  const Sections sections = sections_of(source, begin, end);
  const FileSection& json = sections.feature_json;
  const std::size_t json_end = json.bytes.find_last_not_of(std::string_view("\0 ", 2)) + 1;
  const JsonDocument features(source, json.bytes.substr(0, json_end), json.at, true,
                              "feature table");
  const std::uint64_t length = batch_length_of(features.root(), sections.feature_numbers.bytes);
  const auto [x, y, z] = rtc_center_of(features.root(), sections.feature_numbers.bytes);
  const BatchTable batches(source, length, sections.batch_json, sections.batch_numbers.bytes);
  const GltfTile tile{.frame = frame.frame * Affine{{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z}},
                      .turned = frame.turned,
                      .batches = &batches};
  Mesh mesh = read_gltf_tile(source, sections.glb, sections.end, tile);
  batches.add_notes(mesh.notes);
  LeftOut surplus;
  surplus.add([&] { return "at " + source.byte_of(sections.end); }, end - sections.end);
  add_note(mesh.notes, surplus, "surplus bytes after the stated length of the tile");
  return mesh;
}

}  // namespace soms::detail
