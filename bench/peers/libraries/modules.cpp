#include "bench/peers/libraries/modules.h"

#include "soms/geometry/triangle_overlap.h"

#include <dlfcn.h>

#include <algorithm>
#include <system_error>

namespace soms::bench {

namespace {

using AddPeer = void (*)(Roster&, const Loan&);

constexpr Loan kLoan{
    [](const Triangle& s, const Triangle& t) { return triangles_overlap(s, t); },
};

std::vector<std::filesystem::path> modules_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(folder, absent)) {
    if (entry.path().extension() == ".so") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> add_modules(Roster& roster, const std::filesystem::path& folder) {
  std::vector<std::string> faults;
  for (const auto& file : modules_in(folder)) {
    // Never closed: the libraries' code lies in it.
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* add = module == nullptr ? nullptr : dlsym(module, "soms_bench_peer");
    if (add == nullptr) {
      faults.emplace_back(dlerror());
      continue;
    }
    reinterpret_cast<AddPeer>(add)(roster, kLoan);
  }
  return faults;
}

std::filesystem::path module_folder() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "soms-peers";
}

}  // namespace soms::bench
