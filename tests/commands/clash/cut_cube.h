/// \file
/// A cube cut into parts, as the files of several formats have it.
#pragma once

#include "soms/geometry/mesh.h"

#include "tests/commands/run.h"
#include "tests/support/cut_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace soms::test {

/// Corners of the cube [-1, 1]^3, and its faces, seen from outside.
inline constexpr std::array<std::array<int, 3>, 8> kCorners{{{-1, -1, -1},
                                                             {1, -1, -1},
                                                             {1, 1, -1},
                                                             {-1, 1, -1},
                                                             {-1, -1, 1},
                                                             {1, -1, 1},
                                                             {1, 1, 1},
                                                             {-1, 1, 1}}};
inline constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// The number of the part that each face is in, from 0 on.
using Cut = std::array<int, 6>;

[[nodiscard]] inline int parts_of(const Cut& cut) {
  return 1 + *std::max_element(cut.begin(), cut.end());
}

[[nodiscard]] inline std::string obj_corners() {
  std::string text;
  for (const auto& v : kCorners) {
    text += "v";
    for (const int x : v) {
      text += " " + std::to_string(x);
    }
    text += "\n";
  }
  return text;
}

[[nodiscard]] inline std::string obj_face(int face) {
  std::string text = "f";
  for (const int v : kFaces[static_cast<std::size_t>(face)]) {
    text += " " + std::to_string(v + 1);
  }
  return text + "\n";
}

/// Faces by parts, each behind `head` of its number.
[[nodiscard]] inline std::string by_part(const Cut& cut,
                                         const std::function<std::string(int)>& head,
                                         const std::function<std::string(int)>& face,
                                         const std::function<std::string(int)>& tail) {
  std::string text;
  for (int part = 0; part < parts_of(cut); ++part) {
    text += head(part);
    for (int k = 0; k < 6; ++k) {
      text += cut[static_cast<std::size_t>(k)] == part ? face(k) : "";
    }
    text += tail(part);
  }
  return text;
}

[[nodiscard]] inline std::string obj_of(const Cut& cut, const std::string& keyword) {
  return obj_corners() + by_part(
                             cut,
                             [&](int part) { return keyword + " p" + std::to_string(part) + "\n"; },
                             obj_face, [](int) { return std::string(); });
}

/// Each face behind the name of its group, so that names come again.
[[nodiscard]] inline std::string obj_with_names_again(const Cut& cut) {
  std::string text = obj_corners();
  for (int k = 0; k < 6; ++k) {
    text += "g p" + std::to_string(cut[static_cast<std::size_t>(k)]) + "\n" + obj_face(k);
  }
  return text;
}

/// The two triangles of a face, by corners.
[[nodiscard]] inline std::vector<int> triangles_of(int face) {
  const auto& f = kFaces[static_cast<std::size_t>(face)];
  return {f[0], f[1], f[2], f[0], f[2], f[3]};
}

[[nodiscard]] inline std::string stl_face(int face) {
  std::string text;
  const std::vector<int> corners = triangles_of(face);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    text += k % 3 == 0 ? "facet normal 0 0 0\nouter loop\n" : "";
    text += "vertex";
    for (const int x : kCorners[static_cast<std::size_t>(corners[k])]) {
      text += " " + std::to_string(x);
    }
    text += k % 3 == 2 ? "\nendloop\nendfacet\n" : "\n";
  }
  return text;
}

[[nodiscard]] inline std::string stl_of(const Cut& cut) {
  return by_part(
      cut, [](int part) { return "solid p" + std::to_string(part) + "\n"; }, stl_face,
      [](int part) { return "endsolid p" + std::to_string(part) + "\n"; });
}

[[nodiscard]] inline std::string dae_faces(const Cut& cut, int part) {
  std::string numbers;
  int count = 0;
  for (int k = 0; k < 6; ++k) {
    if (cut[static_cast<std::size_t>(k)] == part) {
      for (const int v : triangles_of(k)) {
        numbers += std::to_string(v) + " ";
      }
      count += 2;
    }
  }
  return "<triangles material=\"m" + std::to_string(part) + "\" count=\"" + std::to_string(count) +
         "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + numbers +
         "</p></triangles>";
}

[[nodiscard]] inline std::string dae_geometry(const std::string& faces, int number) {
  std::string points;
  for (const auto& v : kCorners) {
    for (const int x : v) {
      points += std::to_string(x) + " ";
    }
  }
  const std::string id = std::to_string(number);
  std::string text =
      "<geometry id=\"g#\" name=\"g#\"><mesh><source id=\"p#\"><float_array "
      "id=\"a#\" count=\"24\">" +
      points +
      "</float_array><technique_common><accessor source=\"#a#\" count=\"8\" "
      "stride=\"3\"><param name=\"X\"/><param name=\"Y\"/><param name=\"Z\"/>"
      "</accessor></technique_common></source><vertices id=\"v#\"><input "
      "semantic=\"POSITION\" source=\"#p#\"/></vertices>" +
      faces + "</mesh></geometry>";
  std::string numbered;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool ends = text[k] == '#' && k + 1 < text.size() && text[k + 1] == '"';
    numbered += ends ? id : std::string(1, text[k]);
  }
  const std::string vertices = "source=\"#v\"";
  for (std::size_t at = numbered.find(vertices); at != std::string::npos;
       at = numbered.find(vertices, at + 1)) {
    numbered.replace(at, vertices.size(), "source=\"#v" + id + "\"");
  }
  return numbered;
}

[[nodiscard]] inline std::string dae_of(const std::string& geometries, const std::string& nodes) {
  return "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_geometries>" + geometries +
         "</library_geometries><library_visual_scenes><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/>"
         "</scene></COLLADA>";
}

[[nodiscard]] inline std::string dae_with_materials(const Cut& cut) {
  std::string faces;
  for (int part = 0; part < parts_of(cut); ++part) {
    faces += dae_faces(cut, part);
  }
  return dae_of(dae_geometry(faces, 0), "<node name=\"n\"><instance_geometry url=\"#g0\"/></node>");
}

[[nodiscard]] inline std::string dae_with_nodes(const Cut& cut) {
  std::string geometries;
  std::string nodes;
  for (int part = 0; part < parts_of(cut); ++part) {
    geometries += dae_geometry(dae_faces(cut, part), part);
    nodes += "<node name=\"n" + std::to_string(part) + "\"><instance_geometry url=\"#g" +
             std::to_string(part) + "\"/></node>";
  }
  return dae_of(geometries, nodes);
}

[[nodiscard]] inline std::string city_of(const Cut& cut) {
  std::string vertices;
  for (const auto& v : kCorners) {
    vertices += (vertices.empty() ? "[" : ",[") + std::to_string(v[0]) + "," +
                std::to_string(v[1]) + "," + std::to_string(v[2]) + "]";
  }
  std::string objects;
  for (int part = 0; part < parts_of(cut); ++part) {
    std::string faces;
    for (int k = 0; k < 6; ++k) {
      if (cut[static_cast<std::size_t>(k)] == part) {
        const auto& f = kFaces[static_cast<std::size_t>(k)];
        faces += (faces.empty() ? "[[" : ",[[") + std::to_string(f[0]) + "," +
                 std::to_string(f[1]) + "," + std::to_string(f[2]) + "," + std::to_string(f[3]) +
                 "]]";
      }
    }
    objects +=
        (objects.empty() ? "\"p" : ",\"p") + std::to_string(part) +
        R"(":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"1","boundaries":[)" +
        faces + "]}]}";
  }
  return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
         R"("CityObjects":{)" +
         objects + R"(},"vertices":[)" + vertices + "]}";
}

/// A glTF file, and cube.bin beside it: primitives of one mesh, or a node for each part.
[[nodiscard]] inline std::string gltf_of(const Cut& cut, bool nodes,
                                         const std::filesystem::path& folder) {
  std::string bytes;
  for (const auto& v : kCorners) {
    for (const int x : v) {
      const auto value = static_cast<float>(x);
      std::array<char, 4> raw{};
      std::memcpy(raw.data(), &value, raw.size());
      bytes.append(raw.data(), raw.size());
    }
  }
  std::string accessors = R"({"bufferView":0,"componentType":5126,"count":8,"type":"VEC3",)"
                          R"("min":[-1,-1,-1],"max":[1,1,1]})";
  std::string views = R"({"buffer":0,"byteOffset":0,"byteLength":96})";
  std::vector<std::string> primitives;
  for (int part = 0; part < parts_of(cut); ++part) {
    const std::size_t begin = bytes.size();
    for (int k = 0; k < 6; ++k) {
      if (cut[static_cast<std::size_t>(k)] == part) {
        for (const int v : triangles_of(k)) {
          bytes.push_back(static_cast<char>(v));
          bytes.push_back('\0');
        }
      }
    }
    const std::size_t size = bytes.size() - begin;
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(begin) + R"(,"byteLength":)" +
             std::to_string(size) + "}";
    accessors += R"(,{"bufferView":)" + std::to_string(part + 1) +
                 R"(,"componentType":5123,"count":)" + std::to_string(size / 2) +
                 R"(,"type":"SCALAR"})";
    primitives.push_back(R"({"attributes":{"POSITION":0},"indices":)" + std::to_string(part + 1) +
                         "}");
  }
  std::string meshes;
  std::string node_list;
  std::string roots;
  for (std::size_t k = 0; k < primitives.size(); ++k) {
    const std::string comma = k == 0 ? "" : ",";
    if (nodes) {
      meshes += comma + R"({"primitives":[)" + primitives[k] + "]}";
    } else {
      meshes += comma + primitives[k];
    }
    if (nodes || k == 0) {
      node_list +=
          comma + R"({"mesh":)" + std::to_string(k) + R"(,"name":"n)" + std::to_string(k) + "\"}";
      roots += comma + std::to_string(k);
    }
  }
  meshes = nodes ? meshes : R"({"primitives":[)" + meshes + "]}";
  write_text((folder / "cube.bin").string(), bytes);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots +
         R"(]}],"nodes":[)" + node_list + R"(],"meshes":[)" + meshes + R"(],"accessors":[)" +
         accessors + R"(],"bufferViews":[)" + views + R"(],"buffers":[{"uri":"cube.bin",)" +
         R"("byteLength":)" + std::to_string(bytes.size()) + "}]}";
}

/// The cube as a mesh whose parts are those of the cut.
[[nodiscard]] inline Mesh mesh_of(const Cut& cut) {
  Mesh mesh;
  std::vector<std::uint32_t> label;
  for (const auto& v : kCorners) {
    mesh.vertices.push_back(
        {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  }
  for (int k = 0; k < 6; ++k) {
    const std::vector<int> corners = triangles_of(k);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                                static_cast<std::uint32_t>(corners[i + 1]),
                                static_cast<std::uint32_t>(corners[i + 2])});
      label.push_back(static_cast<std::uint32_t>(cut[static_cast<std::size_t>(k)]));
    }
  }
  return cut_by(mesh, label, static_cast<std::uint32_t>(parts_of(cut)));
}

}  // namespace soms::test
