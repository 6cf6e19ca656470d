#include "soms/io/read_mesh.h"

#include "tests/support/support.h"
#include "tests/support/truth.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace soms::test {

namespace {

std::optional<std::filesystem::path> mesh_file(std::string_view name) {
  for (const auto& row : read_csv(test::data("truth/meshes.csv"))) {
    if (row.at(0) == name) {
      constexpr std::string_view kOutside = "../";
      return row.at(1).starts_with(kOutside) ? outside_data(row.at(1).substr(kOutside.size()))
                                             : test::data("truth/" + row.at(1));
    }
  }
  throw std::runtime_error("truth set: no mesh is named " + std::string(name));
}

}  // namespace

const Mesh* truth_mesh(std::string_view name) {
  static std::map<std::string, std::unique_ptr<const Mesh>, std::less<>> meshes;
  const auto known = meshes.find(name);
  if (known != meshes.end()) {
    return known->second.get();
  }
  const auto file = mesh_file(name);
  auto mesh = file ? std::make_unique<const Mesh>(read_mesh(*file)) : nullptr;
  return meshes.emplace(name, std::move(mesh)).first->second.get();
}

RunnableCases runnable_truth_cases(std::size_t stride) {
  RunnableCases runnable;
  for (std::size_t i = 0; i < truth_cases().size(); i += stride) {
    const TruthCase& c = truth_cases()[i];
    if (truth_mesh(c.mesh_a) != nullptr && truth_mesh(c.mesh_b) != nullptr) {
      runnable.cases.push_back(c);
    } else {
      ++runnable.skipped;
    }
  }
  return runnable;
}

}  // namespace soms::test
