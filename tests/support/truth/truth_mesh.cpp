#include "soms/io/read_mesh.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace soms::test {

namespace {

constexpr std::string_view kOutside = "../";

std::vector<std::vector<std::string>> mesh_rows() {
  return read_csv(test::data("truth/meshes.csv"));
}

std::set<std::string> outside_meshes() {
  std::set<std::string> names;
  for (const auto& row : mesh_rows()) {
    if (row.at(1).starts_with(kOutside)) {
      names.insert(row.at(0));
    }
  }
  return names;
}

std::optional<std::filesystem::path> mesh_file(std::string_view name) {
  for (const auto& row : mesh_rows()) {
    if (row.at(0) == name) {
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

std::vector<TruthCase> truth_cases(Models models, std::size_t stride) {
  std::vector<TruthCase> cases;
  if (models == Models::of_others && !outside_data("")) {
    return cases;
  }
  const std::set<std::string> outside = outside_meshes();
  std::size_t seen = 0;
  for (const TruthCase& c : truth_cases()) {
    const bool of_others = outside.contains(c.mesh_a) || outside.contains(c.mesh_b);
    if (of_others == (models == Models::of_others) && seen++ % stride == 0) {
      cases.push_back(c);
    }
  }
  return cases;
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

std::map<std::string, bool> truth_closed() {
  std::map<std::string, bool> closed;
  for (const auto& row : mesh_rows()) {
    if (row.at(1).starts_with("meshes/")) {
      closed[row.at(0)] = row.at(4) == "1";
    }
  }
  return closed;
}

}  // namespace soms::test
