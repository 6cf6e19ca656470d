#include "soms/io/detail/gltf/gltf_buffers.h"

#include "soms/base/portable.h"
#include "soms/io/detail/base64.h"
#include "soms/io/detail/named_file.h"

#include <string>
#include <utility>

namespace soms::detail {

namespace {

constexpr const char* kWithoutExtension =
    "save the model without it (uncompressed, instances as nodes)";

/// A buffer without bytes may be what a compressed one would be unpacked to.
void refuse_compressed(const JsonValue& buffer) {
  const std::optional<JsonValue> extensions = buffer.find("extensions");
  for (const char* const name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    if (extensions && extensions->find(name)) {
      refuse_extension(buffer, name);
    }
  }
}

}  // namespace

void refuse_extension(const JsonValue& place, std::string_view extension) {
  place.fail(ErrorKind::unsupported,
             "the extension " + in_quotes(extension) +
                 " is used here and changes the geometry, but is not supported",
             kWithoutExtension);
}

void refuse_required_extension(const JsonValue& place, std::string_view extension) {
  place.fail(ErrorKind::unsupported,
             "the extension " + in_quotes(extension) + " is required, but is not supported",
             kWithoutExtension);
}

char* GltfBuffers::store(std::uint64_t size) {
  if (!source_.budget.take(size)) {
    source_.fail_memory(size);
  }
  memory_.push_back(make_array_for_overwrite<char>(static_cast<std::size_t>(size)));
  return memory_.back().get();
}

std::string_view GltfBuffers::decode(const JsonValue& uri) {
  const std::string_view text = uri.text();
  const std::size_t comma = text.find(',');
  if (comma == text.npos || !text.substr(0, comma).ends_with(";base64")) {
    uri.fail("a data URI without \";base64,\"");
  }
  const std::string_view letters = text.substr(comma + 1);
  char* const to = store(base64_size(letters.size()));
  const auto size = decode_base64(letters, to, source_.limits);
  if (!size) {
    uri.fail("the data after \";base64,\" is not base64");
  }
  return {to, *size};
}

std::string_view GltfBuffers::open(const JsonValue& uri) {
  const NamedFile named = open_named(source_, uri);
  const auto [known, is_new] = files_.try_emplace(named.file.id());
  if (is_new) {
    FileBytes bytes = read_named(source_, named, uri);
    memory_.push_back(std::move(bytes.data));
    known->second = {memory_.back().get(), bytes.size};
  }
  return known->second;
}

std::string_view GltfBuffers::load(const JsonValue& buffer, bool is_first) {
  const std::uint64_t length = buffer.at("byteLength").whole();
  const std::optional<JsonValue> uri = buffer.find("uri");
  std::string_view bytes;
  if (uri) {
    bytes = is_data_uri(uri->text()) ? decode(*uri) : open(*uri);
  } else if (is_first && chunk_) {
    bytes = *chunk_;
  } else {
    refuse_compressed(buffer);
    buffer.fail(is_first ? "the buffer has neither \"uri\" nor a BIN chunk" : "\"uri\" is missing");
  }
  if (length > bytes.size()) {
    buffer.at("byteLength")
        .fail(std::to_string(length) + " bytes are stated, but the buffer has " +
              std::to_string(bytes.size()));
  }
  // Up to three bytes fill a chunk; a file beside the model may hold the bytes of others, too.
  constexpr std::uint64_t kMostPadding = 3;
  if (bytes.size() - length > kMostPadding && (!uri || is_data_uri(uri->text()))) {
    surplus_.add([&] { return "in " + buffer.path(); }, bytes.size() - length);
  }
  return bytes.substr(0, static_cast<std::size_t>(length));
}

GltfView GltfBuffers::view(const JsonValue& reference) {
  const JsonValue view = reference.referred("bufferViews");
  const JsonValue number = view.at("buffer");
  const JsonValue buffer = number.referred("buffers");
  const auto [known, is_new] = loaded_.try_emplace(number.whole());
  if (is_new) {
    known->second = load(buffer, number.whole() == 0);
  }
  const std::string_view bytes = known->second;
  const std::optional<JsonValue> at = view.find("byteOffset");
  const std::uint64_t offset = at ? at->whole() : 0;
  const std::uint64_t length = view.at("byteLength").whole();
  if (offset > bytes.size() || length > bytes.size() - offset) {
    view.fail(std::to_string(length) + " bytes from byte " + std::to_string(offset) +
              ", but the buffer has " + std::to_string(bytes.size()) + " bytes");
  }
  const std::optional<JsonValue> stride = view.find("byteStride");
  return {bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)),
          stride ? stride->whole() : 0};
}

}  // namespace soms::detail
