#include "tests/tree/models.h"

#include "soms/generate/urban.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace soms::test {

Mesh read_plain_ply(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) {
    throw std::runtime_error("cannot open " + path.string());
  }
  std::size_t vertices = 0;
  std::size_t faces = 0;
  for (std::string line; std::getline(in, line) && line.substr(0, 10) != "end_header";) {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (first == "element") {
      words >> (second == "vertex" ? vertices : faces);
    }
  }
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    std::string line;
    std::getline(in, line);
    std::istringstream words(line);
    float x = 0;
    float y = 0;
    float z = 0;
    words >> x >> y >> z;
    mesh.vertices.push_back({x, y, z});
  }
  for (std::size_t i = 0; i < faces; ++i) {
    std::uint32_t n = 0;
    std::array<std::uint32_t, 3> t{};
    in >> n >> t[0] >> t[1] >> t[2];
    if (n != 3) {
      throw std::runtime_error(path.string() + " has a face that is no triangle");
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

std::optional<Mesh> golden_mesh(const GoldenModel& model) {
  const std::string name = model.name;
  if (name == "u_boxes") {
    return generate_urban(UrbanScene::boxes);
  }
  if (name == "u_mixed") {
    return generate_urban(UrbanScene::mixed);
  }
  if (name == "u_plain") {
    return generate_urban(UrbanScene::plain);
  }
  const auto path = outside_data(model.file);
  return path ? std::optional(read_plain_ply(*path)) : std::nullopt;
}

}  // namespace soms::test
