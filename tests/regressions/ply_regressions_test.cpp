// Faults that other libraries had with PLY files; numbers as in the list of regressions. The files
// are made here, byte by byte.
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/regressions/cube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

enum class Order { text, little, big };

constexpr std::array kOrders = {Order::text, Order::little, Order::big};

/// Writes values of PLY's types in one of its three ways.
class PlyValues {
 public:
  explicit PlyValues(Order order) : order_(order) {}

  void add(const std::string& type, double value) {
    if (order_ == Order::text) {
      std::ostringstream out;
      out.precision(17);
      out << value;
      text_ += out.str() + " ";
      return;
    }
    std::string bytes;
    if (type == "float" || type == "float32") {
      bytes = bytes_of(static_cast<float>(value));
    } else if (type == "double" || type == "float64") {
      bytes = bytes_of(value);
    } else {
      const bool is_byte = type == "char" || type == "uchar" || type == "int8" || type == "uint8";
      const bool is_short =
          type == "short" || type == "ushort" || type == "int16" || type == "uint16";
      bytes =
          bytes_of(static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), is_byte    ? 1
                                                                                 : is_short ? 2
                                                                                            : 4);
    }
    if (order_ == Order::big) {
      std::reverse(bytes.begin(), bytes.end());
    }
    text_ += bytes;
  }

  void end_row() {
    if (order_ == Order::text) {
      text_ += "\n";
    }
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Order order_;
  std::string text_;
};

/// The first lines of a PLY file and its last, with the given line ends.
std::string ply_header(Order order, const std::vector<std::string>& lines,
                       const std::string& end = "\n") {
  const std::string format = order == Order::text     ? "ascii"
                             : order == Order::little ? "binary_little_endian"
                                                      : "binary_big_endian";
  std::string header = "ply" + end + "format " + format + " 1.0" + end;
  for (const std::string& line : lines) {
    header += line + end;
  }
  return header + "end_header" + end;
}

TEST(PlyRegressions, R89BinaryPlyWhoseHeaderAndDataMeetInLineEnds) {
  // The first byte of the data is a line feed, a carriage return or a blank.
  for (const std::uint32_t first : {0x0aU, 0x0dU, 0x20U}) {
    for (const Order order : {Order::little, Order::big}) {
      const std::uint32_t bits =
          order == Order::little ? 0x3f800000U | first : first << 24 | 0x1234;
      const double x = static_cast<double>(std::bit_cast<float>(bits));
      for (const std::string end : {"\n", "\r\n", "\r"}) {
        PlyValues values(order);
        for (int k = 0; k < 8; ++k) {
          const Vec3 p = cube_corner(k);
          values.add("float", p.x == 0 ? x : 2);
          values.add("float", p.y);
          values.add("float", p.z);
        }
        for (const auto& side : kSides) {
          values.add("uchar", 4);
          for (const int k : side) {
            values.add("int", k);
          }
        }
        ASSERT_EQ(static_cast<unsigned char>(values.text()[0]), first);
        const Mesh mesh =
            read_text(ply_header(order,
                                 {"element vertex 8", "property float x", "property float y",
                                  "property float z", "element face 6",
                                  "property list uchar int vertex_indices"},
                                 end) +
                          values.text(),
                      "cube.ply");
        EXPECT_EQ(mesh.triangles, cube().triangles);
        for (int k = 0; k < 8; ++k) {
          const Vec3 p = cube_corner(k);
          EXPECT_EQ(mesh.vertices[static_cast<std::size_t>(k)], (Vec3{p.x == 0 ? x : 2, p.y, p.z}));
        }
      }
    }
  }
}

TEST(PlyRegressions, R89BinaryPlyWhoseFirstListHasTenCorners) {
  for (const Order order : {Order::little, Order::big}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      PlyValues values(order);
      values.add("uchar", 10);
      for (int k = 0; k < 10; ++k) {
        values.add("uchar", k);
      }
      for (int k = 0; k < 10; ++k) {
        values.add("double", k);
        values.add("double", k * k);
        values.add("double", 0);
      }
      const Mesh mesh =
          read_text(ply_header(order,
                               {"element face 1", "property list uchar uchar vertex_index",
                                "element vertex 10", "property double x", "property double y",
                                "property double z"},
                               end) +
                        values.text(),
                    "face_first.ply");
      ASSERT_EQ(mesh.triangles.size(), 8U);
      EXPECT_EQ(mesh.vertices[9], (Vec3{9, 81, 0}));
      EXPECT_EQ(mesh.triangles[7], (std::array<std::uint32_t, 3>{0, 8, 9}));
    }
  }
}

/// The cube with coordinates, counts and indices of these types, and elements that nobody requested
/// before, between and after its own.
std::string ply_cube(Order order, const std::string& coordinate, const std::string& count,
                     const std::string& index, bool extra) {
  std::vector<std::string> lines;
  PlyValues values(order);
  const auto add_extra = [&](const std::string& name) {
    if (!extra) {
      return;
    }
    for (const char* line : {"property short a", "property list ushort double b",
                             "property double c", "property list uchar char d"}) {
      if (std::string(line) == "property short a") {
        lines.push_back("element " + name + " 2");
      }
      lines.emplace_back(line);
    }
    for (int row = 0; row < 2; ++row) {
      values.add("short", -7);
      values.add("ushort", 3 * row);
      for (int i = 0; i < 3 * row; ++i) {
        values.add("double", 1e300);
      }
      values.add("double", -0.5);
      values.add("uchar", 1);
      values.add("char", -1);
      values.end_row();
    }
  };
  add_extra("before");
  lines.emplace_back("element vertex 8");
  for (const char* name : {"x", "y", "z"}) {
    lines.push_back("property " + coordinate + " " + name);
    if (extra) {
      lines.push_back(std::string("property uchar u") + name);
    }
  }
  for (int k = 0; k < 8; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values.add(coordinate, cube_corner(k)[axis]);
      if (extra) {
        values.add("uchar", 255);
      }
    }
    values.end_row();
  }
  add_extra("between");
  lines.emplace_back("element face 6");
  lines.push_back("property list " + count + " " + index + " vertex_indices");
  for (const auto& side : kSides) {
    values.add(count, 4);
    for (const int k : side) {
      values.add(index, k);
    }
    values.end_row();
  }
  add_extra("after");
  return ply_header(order, lines) + values.text();
}

TEST(PlyRegressions, R90OneCubeInAllTypesAndBothByteOrders) {
  const std::vector<std::string> whole = {"char", "uchar",  "short", "ushort", "int",   "uint",
                                          "int8", "uint16", "int32", "uint8",  "int16", "uint32"};
  std::vector<std::string> all = whole;
  all.insert(all.end(), {"float", "double", "float32", "float64"});
  const Mesh expected = cube();
  for (const Order order : kOrders) {
    for (const bool extra : {false, true}) {
      for (const std::string& coordinate : all) {
        const Mesh mesh = read_text(ply_cube(order, coordinate, "uchar", "int", extra), "cube.ply");
        ASSERT_EQ(mesh.vertices, expected.vertices) << coordinate;
        ASSERT_EQ(mesh.triangles, expected.triangles) << coordinate;
      }
      for (const std::string& count : whole) {
        for (const std::string& index : whole) {
          const Mesh mesh = read_text(ply_cube(order, "float", count, index, extra), "cube.ply");
          ASSERT_EQ(mesh.vertices, expected.vertices) << count << " " << index;
          ASSERT_EQ(mesh.triangles, expected.triangles) << count << " " << index;
        }
      }
    }
  }
}

TEST(PlyRegressions, R91DoublesVerticesWithoutFacesAndCountsBeyondTheFile) {
  const auto file = [](Order order, const std::string& vertices, const std::string& faces) {
    const std::string cube = ply_cube(order, "double", "uchar", "int", false);
    std::string changed = cube;
    changed.replace(changed.find("vertex 8") + 7, 1, vertices);
    changed.replace(changed.find("face 6") + 5, 1, faces);
    return changed;
  };
  for (const Order order : kOrders) {
    const std::string whole = file(order, "8", "6");
    EXPECT_EQ(read_text(whole, "cube.ply").vertices.size(), 8U);  // as the header says
    std::string vertices = file(order, "8", "0");
    const std::size_t faces = order == Order::text ? vertices.find("4 0 2 3 1")
                                                   : vertices.size() - std::size_t{6} * (1 + 4 * 4);
    vertices.resize(faces);
    expect_refused(vertices, "cube.ply", ErrorKind::empty_mesh, "no triangles");
    const Mesh points = read_text(vertices, "cube.ply", {.allow_empty = true});
    EXPECT_EQ(points.vertices, cube().vertices);
    for (const char* many : {"9", "4294967295", "768614336404564651", "18446744073709551615"}) {
      for (const bool of_faces : {false, true}) {
        const std::string lie = file(order, of_faces ? "8" : many, of_faces ? many : "6");
        const auto refusal = refusal_of([&] { static_cast<void>(read_text(lie, "lie.ply")); });
        ASSERT_TRUE(refusal) << many;
        EXPECT_TRUE(refusal->kind == ErrorKind::bad_file ||
                    refusal->kind == ErrorKind::out_of_range)
            << refusal->words;
        EXPECT_NE(refusal->words.find("lie.ply, "), std::string::npos) << refusal->words;
      }
    }
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const auto refusal = refusal_of(
          [&] { EXPECT_EQ(read_text(whole.substr(0, size), "cut.ply").triangles.size(), 12U); });
      // A text may end without its last blank and line end.
      EXPECT_TRUE(refusal || (order == Order::text && size + 2 >= whole.size())) << size;
      if (refusal && size > whole.find("end_header") + 11 && order != Order::text) {
        EXPECT_NE(refusal->words.find("byte "), std::string::npos) << refusal->words;
      }
    }
  }
}

}  // namespace
}  // namespace soms::test
