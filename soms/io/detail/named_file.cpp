#include "soms/io/detail/named_file.h"

#include <algorithm>
#include <system_error>

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
             "name the file that holds the data");
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

}  // namespace

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view kData = "data:";
  return std::equal(kData.begin(), kData.end(), uri.begin(),
                    uri.begin() + static_cast<std::ptrdiff_t>(std::min(kData.size(), uri.size())),
                    [](char d, char c) { return d == c || (c >= 'A' && c <= 'Z' && d == c + 32); });
}

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

NamedFile open_named(const Source& source, const JsonValue& uri) {
  if (scheme_of(uri.text()) > 0) {
    uri.fail(
        ErrorKind::unsupported,
        in_quotes(uri.text()) + " is not a file in the folder of the model; nothing else is opened",
        kBeside);
  }
  if (!source.folder) {
    uri.fail(
        ErrorKind::cannot_open,
        in_quotes(uri.text()) + " is another file, which cannot be found for a model from memory",
        "read the model from its path, or embed the data");
  }
  check(source.limits);
  std::filesystem::path path = file_within(*source.folder, uri);
  return at_place(uri, [&] { return NamedFile{path, RegularFile(path)}; });
}

FileBytes read_named(Source& source, const NamedFile& named, const JsonValue& uri,
                     bool read_before) {
  if (!read_before) {
    source.budget.give_back(source.memory_per_byte * named.file.size());
  }
  if (!source.budget.take(named.file.size())) {
    source.fail_memory(named.file.size());
  }
  return at_place(uri, [&] { return named.file.read(); });
}

}  // namespace soms::detail
