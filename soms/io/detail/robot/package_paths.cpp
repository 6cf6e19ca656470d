#include "soms/io/detail/robot/package_paths.h"

#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/io/detail/file.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace soms::detail {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostOfManifest = std::uint64_t{1} << 20;

bool is_folder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

/// Whether the package.xml of a folder has this name.
bool declares(const fs::path& folder, std::string_view name) {
  const fs::path manifest = folder / "package.xml";
  std::error_code unknown;
  if (!fs::is_regular_file(manifest, unknown) ||
      fs::file_size(manifest, unknown) > kMostOfManifest || unknown) {
    return false;
  }
  try {
    const FileBytes bytes = read_file(manifest, kMostOfManifest);
    return bytes.view().find("<name>" + std::string(name) + "</name>") != std::string_view::npos;
  } catch (const Error&) {
    return false;  // it cannot be read, so it declares nothing
  }
}

/// The folder of a package: `folder` itself, or one in it.
std::optional<fs::path> package_at(const fs::path& folder, const std::string& name) {
  if (folder.filename() == name || declares(folder, name)) {
    return folder;
  }
  if (is_folder(folder / name)) {
    return folder / name;
  }
  return std::nullopt;
}

fs::path find_package(const std::string& name, const std::optional<fs::path>& folder,
                      const RobotReadOptions& options) {
  for (const auto& [known, place] : options.packages) {
    if (known == name) {
      return place;
    }
  }
  std::error_code unknown;
  const fs::path whole = folder ? fs::weakly_canonical(*folder, unknown) : fs::path();
  for (fs::path at = whole; !at.empty(); at = at.parent_path()) {
    if (const auto found = package_at(at, name)) {
      return *found;
    }
    if (at == at.parent_path()) {
      break;
    }
  }
  for (const fs::path& place : options.package_path) {
    if (const auto found = package_at(place, name)) {
      return *found;
    }
  }
  throw Error(ErrorKind::cannot_open, "package " + quoted_text(name) + " is not found",
              "name its folder by the option for packages, or put it in one above the URDF file");
}

bool take_prefix(std::string_view& text, std::string_view prefix) {
  const bool found = text.starts_with(prefix);
  text.remove_prefix(found ? prefix.size() : 0);
  return found;
}

}  // namespace

std::filesystem::path resolved_uri(std::string_view uri, const std::optional<fs::path>& folder,
                                   const RobotReadOptions& options) {
  std::string_view rest = uri;
  if (take_prefix(rest, "package://") || take_prefix(rest, "model://")) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string name(rest.substr(0, slash));
    rest.remove_prefix(std::min(slash + 1, rest.size()));
    while (rest.starts_with('/')) {
      rest.remove_prefix(1);  // else what is joined would be a whole path
    }
    if (name.empty() || name == "." || name == "..") {
      throw Error(ErrorKind::bad_file, quoted_text(uri) + " names no package",
                  "write package://NAME/PATH");
    }
    return find_package(name, folder, options) / rest;
  }
  if (!take_prefix(rest, "file://") && rest.find("://") != std::string_view::npos) {
    throw Error(ErrorKind::unsupported, quoted_text(uri) + " is on another protocol",
                "give the mesh as package://, file:// or a path");
  }
  const fs::path path(rest);
  if (path.is_absolute()) {
    return path;
  }
  if (!folder) {
    throw Error(ErrorKind::unsupported,
                quoted_text(uri) + " is relative to a folder, and bytes in memory have none",
                "read the robot from a file, or give whole paths");
  }
  return *folder / path;
}

}  // namespace soms::detail
