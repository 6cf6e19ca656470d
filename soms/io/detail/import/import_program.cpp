#include "soms/io/detail/import/import_program.h"

#include "soms/io/detail/text.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
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

/// The folders of a variable like PATH. One that is not named from the root on is left out: it
/// would be another one in each current folder.
std::vector<fs::path> listed(const char* name) {
  std::vector<fs::path> all;
  std::istringstream list(variable(name).value_or(""));
  for (std::string folder; std::getline(list, folder, ':');) {
    if (fs::path(folder).is_absolute()) {
      all.emplace_back(folder);
    }
  }
  return all;
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
  std::vector<fs::path> places = listed("PATH");
  places.insert(places.end(), {"/usr/local/bin", "/usr/bin"});
  for (const fs::path& place : places) {
    if (runs(place / "node")) {
      return place / "node";
    }
  }
  return std::nullopt;
}

bool holds_web_ifc(const fs::path& folder) {
  return is_file(folder / "package.json") && is_file(folder / "web-ifc-api-node.js");
}

/// Where npm puts global packages, as npm itself says; nothing without npm.
std::optional<fs::path> npm_root() {
  std::FILE* const answer = popen("npm root -g </dev/null 2>/dev/null", "r");
  if (answer == nullptr) {
    return std::nullopt;
  }
  std::string line;
  for (int c = std::fgetc(answer); c != EOF; c = std::fgetc(answer)) {
    line += static_cast<char>(c);
  }
  // Its status is unknown where SIGCHLD is ignored; whether the folder is right is seen below.
  pclose(answer);
  const fs::path folder = line.substr(0, line.find('\n'));
  return folder.is_absolute() ? std::optional(folder) : std::nullopt;
}

/// The folder of the npm package, for this Node.js.
std::optional<fs::path> find_web_ifc(const Source& source, const fs::path& node) {
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
  const auto by_variable = listed("NODE_PATH");
  places.insert(places.end(), by_variable.begin(), by_variable.end());
  std::error_code unknown;
  if (const auto current = fs::current_path(unknown); !unknown) {
    places.push_back(current / "node_modules");
  }
  // npm's global packages lie beside its Node.js, unless it is configured otherwise.
  places.push_back(node.parent_path().parent_path() / "lib/node_modules");
  places.insert(places.end(), {"/usr/local/lib/node_modules", "/usr/lib/node_modules"});
  for (const fs::path& place : places) {
    if (holds_web_ifc(place / "web-ifc")) {
      return place / "web-ifc";
    }
  }
  // Last, as npm takes longer to start than a model to read.
  if (const auto place = npm_root(); place && holds_web_ifc(*place / "web-ifc")) {
    return *place / "web-ifc";
  }
  return std::nullopt;
}

/// web-ifc, if all that it takes is there.
std::optional<ImportProgram> web_ifc(const Source& source) {
  const auto node = find_node(source);
  const auto script = beside_us(kIfcScript);
  // What a variable names wrongly is an error even where the rest is missing.
  if (!script || (!node && !variable("SOMS_WEB_IFC"))) {
    return std::nullopt;
  }
  const auto package = find_web_ifc(source, node.value_or(""));
  if (!node || !package) {
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
          (is_ifc ? "install Node.js and web-ifc (npm install -g web-ifc), " : "") +
          "or convert the model");
}

}  // namespace soms::detail
