#include "soms/io/detail/import_program.h"

#include "soms/io/detail/text.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <system_error>

namespace soms::detail {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
/// Of an executable and its libraries, and of Node.js with its compiled modules.
constexpr std::uint64_t kProgramMemory = 256 * kMebibyte;
constexpr std::uint64_t kNodeMemory = 512 * kMebibyte;
constexpr std::string_view kIfcScript = "soms-import-ifc.mjs";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool runs(const fs::path& program) {
  return is_file(program) && access(program.c_str(), X_OK) == 0;
}

/// The value of an environment variable; nothing if it is not set or empty.
std::optional<std::string> variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

/// Where this program and the library with this code lie, as far as that is known.
std::vector<fs::path> folders() {
  std::error_code unknown;
  const auto program = fs::read_symlink("/proc/self/exe", unknown);
  Dl_info library{};
  const bool found = dladdr(reinterpret_cast<const void*>(&find_import_program), &library) != 0 &&
                     library.dli_fname != nullptr;
  return import_folders(program, found ? library.dli_fname : "");
}

/// A file that lies where programs of soms may; nothing if there is none.
std::optional<fs::path> beside_us(std::string_view name) {
  for (const fs::path& folder : folders()) {
    if (is_file(folder / name)) {
      return folder / name;
    }
  }
  return std::nullopt;
}

std::optional<fs::path> find_node(const Source& source) {
  if (const auto named = variable("SOMS_NODE")) {
    if (!runs(*named)) {
      source.fail(ErrorKind::unsupported, "SOMS_NODE does not name a program: " + *named,
                  "set it to the path of node, or unset it");
    }
    return *named;
  }
  for (const char* const node : {"/usr/local/bin/node", "/usr/bin/node"}) {
    if (runs(node)) {
      return node;
    }
  }
  return std::nullopt;
}

bool holds_web_ifc(const fs::path& folder) {
  return is_file(folder / "package.json") && is_file(folder / "web-ifc-api-node.js");
}

/// The folder of the npm package.
std::optional<fs::path> find_web_ifc(const Source& source) {
  if (const auto named = variable("SOMS_WEB_IFC")) {
    if (!holds_web_ifc(*named)) {
      source.fail(ErrorKind::unsupported,
                  "SOMS_WEB_IFC does not name the npm package web-ifc: " + *named,
                  "set it to the folder node_modules/web-ifc, or unset it");
    }
    return fs::absolute(*named);
  }
  std::vector<fs::path> places = folders();
  for (fs::path& place : places) {
    place /= "node_modules";
  }
  places.insert(places.end(), {"/usr/local/lib/node_modules", "/usr/lib/node_modules"});
  for (const fs::path& place : places) {
    if (holds_web_ifc(place / "web-ifc")) {
      return place / "web-ifc";
    }
  }
  return std::nullopt;
}

/// web-ifc, if all that it takes is there.
std::optional<ImportProgram> web_ifc(const Source& source) {
  const auto package = find_web_ifc(source);
  if (!package) {
    return std::nullopt;
  }
  const auto node = find_node(source);
  const auto script = beside_us(kIfcScript);
  if (!node || !script) {
    return std::nullopt;
  }
  return ImportProgram{"web-ifc", *node, {script->string(), package->string()}, kNodeMemory, true};
}

}  // namespace

std::vector<fs::path> import_folders(const fs::path& program, const fs::path& library) {
  std::vector<fs::path> all;
  if (program.is_absolute()) {
    const fs::path beside = program.parent_path();
    all = {beside, beside.parent_path() / "libexec/soms"};
  }
  if (library.is_absolute()) {
    fs::path folder = library.parent_path();
    // From lib, or from lib/<architecture>.
    if (folder.parent_path().filename() == "lib") {
      folder = folder.parent_path();
    }
    all.push_back(folder.parent_path() / "libexec/soms");
  }
  return all;
}

ImportProgram find_import_program(const Source& source, std::string_view extension) {
  const auto named = variable("SOMS_IMPORT");
  const bool is_ifc = extension == ".ifc" && (!named || variable("SOMS_WEB_IFC"));
  if (is_ifc) {
    if (auto program = web_ifc(source)) {
      return *std::move(program);
    }
  }
  if (named) {
    if (!runs(*named)) {
      source.fail(ErrorKind::unsupported, "SOMS_IMPORT does not name a program: " + *named,
                  "set it to the path of soms-import, or unset it");
    }
    return {"soms-import", *named, {}, kProgramMemory};
  }
  const auto program = beside_us("soms-import");
  if (program && runs(*program)) {
    return {"soms-import", *program, {}, kProgramMemory};
  }
  source.fail(
      ErrorKind::unsupported,
      "format " + in_quotes(extension) +
          " is read by the program soms-import, which is not installed",
      std::string("build soms where Assimp is found (Debian: libassimp-dev), set SOMS_IMPORT to "
                  "the path of the program, ") +
          (is_ifc ? "install Node.js and, by npm, web-ifc, " : "") + "or convert the model");
}

}  // namespace soms::detail
