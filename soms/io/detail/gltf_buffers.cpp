#include "soms/io/detail/gltf_buffers.h"

#include "soms/base/portable.h"
#include "soms/io/detail/base64.h"
#include "soms/io/detail/file.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace soms::detail {

namespace {

constexpr const char* kBeside =
    "put the file into the folder of the model, and use its relative name";

/// Characters of a scheme ("https:") before its colon; 0 if the text begins with none.
std::size_t scheme_of(std::string_view uri) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::size_t length = 0;
  while (length < uri.size() &&
         (is_letter(uri[length]) ||
          (length > 0 && std::string_view("0123456789+-.").find(uri[length]) != uri.npos))) {
    ++length;
  }
  return length < uri.size() && uri[length] == ':' ? length : 0;
}

bool is_data(std::string_view uri) {
  constexpr std::string_view kData = "data:";
  return std::equal(kData.begin(), kData.end(), uri.begin(),
                    uri.begin() + static_cast<std::ptrdiff_t>(std::min(kData.size(), uri.size())),
                    [](char d, char c) { return d == c || (c >= 'A' && c <= 'Z' && d == c + 32); });
}

/// The text with each %41 made the byte that it stands for; a % without two digits stays.
std::string without_escapes(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      text += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The file that a URI names within the folder, links resolved; a folder or a device is refused
/// before it is opened. \errors ErrorKind::bad_file, cannot_open.
std::filesystem::path file_within(const std::filesystem::path& folder, const JsonValue& uri) {
  const std::string name = without_escapes(uri.text());
  const std::filesystem::path relative(name);
  if (name.empty() || name.find('\0') != name.npos || relative.has_root_path() ||
      std::find(relative.begin(), relative.end(), "..") != relative.end()) {
    uri.fail(ErrorKind::bad_file,
             in_quotes(name) + " is outside the folder of the model; such files are not opened",
             kBeside);
  }
  std::error_code code;
  const std::filesystem::path inside = std::filesystem::canonical(folder, code);
  std::filesystem::path file =
      code ? std::filesystem::path() : std::filesystem::canonical(folder / relative, code);
  if (code) {
    uri.fail(ErrorKind::cannot_open, in_quotes(name) + ": " + code.message(),
             "get all files that belong to the model");
  }
  const auto ends = std::mismatch(inside.begin(), inside.end(), file.begin(), file.end());
  if (ends.first != inside.end()) {
    uri.fail(ErrorKind::bad_file, in_quotes(name) + " is a link out of the folder of the model",
             "put the file itself there");
  }
  if (!std::filesystem::is_regular_file(file, code)) {
    uri.fail(ErrorKind::cannot_open, in_quotes(name) + " is not a regular file",
             "name the file that holds the buffer");
  }
  return file;
}

/// What `action` gives; its errors tell the place in the document, too.
template <class Action>
auto at_place(const JsonValue& uri, const Action& action) {
  try {
    return action();
  } catch (const Error& error) {
    uri.fail(error.kind(), error.place(), error.remedy());
  }
}

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
             "the extension " + in_quotes(extension) + " is required, but is not supported",
             "save the model without it (uncompressed, instances as nodes)");
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
  const auto size = decode_base64(letters, to, source_.parallel);
  if (!size) {
    uri.fail("the data after \";base64,\" is not base64");
  }
  return {to, *size};
}

std::string_view GltfBuffers::open(const JsonValue& uri) {
  if (scheme_of(uri.text()) > 0) {
    uri.fail(
        ErrorKind::unsupported,
        in_quotes(uri.text()) + " is not a file in the folder of the model; nothing else is opened",
        kBeside);
  }
  if (!source_.folder) {
    uri.fail(
        ErrorKind::cannot_open,
        in_quotes(uri.text()) + " is another file, which cannot be found for a model from memory",
        "read the model from its path, or embed the buffer");
  }
  check_stop(source_.parallel);
  const std::filesystem::path path = file_within(*source_.folder, uri);
  const RegularFile file = at_place(uri, [&] { return RegularFile(path); });
  const auto [known, is_new] = files_.try_emplace(file.id());
  if (is_new) {
    known->second = read(file, uri);
  }
  return known->second;
}

/// The file counts toward the memory that reading may take, as the model's own file does.
std::string_view GltfBuffers::read(const RegularFile& file, const JsonValue& uri) {
  source_.budget.give_back(source_.memory_per_byte * file.size());
  if (!source_.budget.take(file.size())) {
    source_.fail_memory(file.size());
  }
  FileBytes bytes = at_place(uri, [&] { return file.read(); });
  memory_.push_back(std::move(bytes.data));
  return {memory_.back().get(), bytes.size};
}

std::string_view GltfBuffers::load(const JsonValue& buffer, bool is_first) {
  const std::uint64_t length = buffer.at("byteLength").whole();
  const std::optional<JsonValue> uri = buffer.find("uri");
  std::string_view bytes;
  if (uri) {
    bytes = is_data(uri->text()) ? decode(*uri) : open(*uri);
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
  if (bytes.size() - length > kMostPadding && (!uri || is_data(uri->text()))) {
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
