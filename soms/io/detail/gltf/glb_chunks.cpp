#include "soms/io/detail/gltf/glb_chunks.h"

#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/numbers/little_endian.h"

#include <cstdint>
#include <string>

namespace soms::detail {

namespace {

/// Where the last chunk ends, by the header.
std::size_t stated_end(const Source& source, std::size_t begin, std::size_t end) {
  const std::string_view bytes = source.bytes.substr(begin, end - begin);
  const std::string remedy = "get the complete file, or repair it";
  if (bytes.size() < glb::kHeader || !is_glb(bytes)) {
    source.fail_byte(begin, ErrorKind::bad_file, "the GLB header is missing", remedy);
  }
  const auto version = little_endian<std::uint32_t>(bytes, 4);
  if (version != glb::kVersion) {
    source.fail_byte(begin + 4, ErrorKind::unsupported,
                     "version " + std::to_string(version) + " of GLB is not read, only 2",
                     "save the model as glTF 2.0");
  }
  const std::size_t size = little_endian<std::uint32_t>(bytes, 8);
  if (size < glb::kHeader || size > bytes.size()) {
    source.fail_byte(begin + 8, ErrorKind::bad_file,
                     "the header states " + std::to_string(size) + " bytes, but the file has " +
                         std::to_string(bytes.size()) + (begin > 0 ? " from there" : ""),
                     remedy);
  }
  return begin + size;
}

}  // namespace

GlbChunks glb_chunks(const Source& source, std::size_t begin, std::size_t end) {
  const std::size_t stated = stated_end(source, begin, end);
  const auto fail = [&](std::size_t at, const std::string& what) {
    source.fail_byte(at, ErrorKind::bad_file, what, "get the complete file, or repair it");
  };
  const auto value_at = [&](std::size_t at) {
    return little_endian<std::uint32_t>(source.bytes, at);
  };
  GlbChunks chunks;
  for (std::size_t at = begin + glb::kHeader; at < stated || chunks.json_at == 0;) {
    if (stated - at < glb::kChunkHeader || value_at(at) > stated - at - glb::kChunkHeader) {
      fail(at, "a chunk is cut off");
    }
    const std::uint32_t type = value_at(at + 4);
    const std::string_view inside = source.bytes.substr(at + glb::kChunkHeader, value_at(at));
    if (chunks.json_at == 0) {
      if (type != glb::kJson) {
        fail(at, "the first chunk is not JSON");
      }
      chunks.json = inside;
      chunks.json_at = at + glb::kChunkHeader;
    } else if (type == glb::kBinary && !chunks.binary) {
      chunks.binary = inside;
    } else {
      chunks.others.add([&] { return "at " + source.byte_of(at); });
    }
    at += glb::kChunkHeader + inside.size();
  }
  chunks.surplus.add([&] { return "at " + source.byte_of(stated); }, end - stated);
  // Blanks should fill the chunk; some programs write zeros.
  chunks.json = chunks.json.substr(0, chunks.json.find_last_not_of('\0') + 1);
  return chunks;
}

}  // namespace soms::detail
