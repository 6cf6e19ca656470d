// Arrays of NumPy in and out: `.npy` files of rows, and the columns that -o writes.
#include "tests/commands/near.h"
#include "tests/support/pipe.h"

#include <array>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// A value of a little-endian file.
std::uint64_t value_at(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(bytes.at(at + i))} << (8 * i);
  }
  return value;
}

/// CRC-32 bit by bit, as its definition has it.
std::uint32_t checksum_of(const std::string& bytes) {
  std::uint32_t state = 0xffffffffU;
  for (const char c : bytes) {
    state ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) {
      state = (state >> 1) ^ ((state & 1U) * 0xedb88320U);
    }
  }
  return ~state;
}

/// An array of a file: how its header describes it, and its numbers.
struct NpyArray {
  std::string header;
  std::string data;

  [[nodiscard]] std::vector<double> numbers() const {
    std::vector<double> values;
    for (std::size_t at = 0; at < data.size(); at += 8) {
      values.push_back(std::bit_cast<double>(value_at(data, at, 8)));
    }
    return values;
  }

  [[nodiscard]] std::vector<std::int64_t> counts() const {
    std::vector<std::int64_t> values;
    for (std::size_t at = 0; at < data.size(); at += 8) {
      values.push_back(std::bit_cast<std::int64_t>(value_at(data, at, 8)));
    }
    return values;
  }

  /// Flags and codes, a digit each.
  [[nodiscard]] std::string digits() const {
    std::string text;
    for (const char c : data) {
      text += static_cast<char>('0' + c);
    }
    return text;
  }
};

std::string described(const std::string& type, const std::string& shape) {
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
}

NpyArray array_of(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  const std::size_t size = value_at(bytes, 8, 2);
  EXPECT_EQ((10 + size) % 64, 0U);
  std::string header = bytes.substr(10, size);
  EXPECT_EQ(header.back(), '\n');
  header.resize(header.find('}') + 1);
  return {header, bytes.substr(10 + size)};
}

/// The arrays of a file, by name, read by the list of members at its end.
std::map<std::string, NpyArray> arrays_of(const std::filesystem::path& path) {
  const std::string file = read_text(path);
  const std::size_t locator = file.size() - 22 - 20;
  EXPECT_EQ(value_at(file, file.size() - 22, 4), 0x06054b50U);
  EXPECT_EQ(value_at(file, locator, 4), 0x07064b50U);
  const std::size_t end = value_at(file, locator + 8, 8);
  EXPECT_EQ(value_at(file, end, 4), 0x06064b50U);
  EXPECT_EQ(end + 56, locator);
  std::size_t at = value_at(file, end + 48, 8);
  std::map<std::string, NpyArray> arrays;
  for (std::uint64_t left = value_at(file, end + 32, 8); left > 0; --left) {
    EXPECT_EQ(value_at(file, at, 4), 0x02014b50U);
    const std::string name = file.substr(at + 46, value_at(file, at + 28, 2));
    const std::size_t extra = at + 46 + name.size() + 4;
    const std::size_t size = value_at(file, extra, 8);
    const std::size_t local = value_at(file, extra + 16, 8);
    EXPECT_EQ(value_at(file, local, 4), 0x04034b50U);
    EXPECT_EQ(file.substr(local + 30, name.size()), name);
    EXPECT_EQ(value_at(file, local + 30 + name.size() + 4, 8), size);
    const std::string content = file.substr(local + 30 + name.size() + 20, size);
    EXPECT_EQ(value_at(file, at + 16, 4), checksum_of(content)) << name;
    EXPECT_EQ(value_at(file, local + 14, 4), checksum_of(content)) << name;
    arrays[name] = array_of(content);
    at = extra + 24;
  }
  EXPECT_EQ(at, end);
  return arrays;
}

/// The words of "<name>_names.npy".
std::vector<std::string> names_of_codes(const NpyArray& array) {
  const std::size_t longest = std::stoul(array.header.substr(array.header.find("<U") + 2));
  std::vector<std::string> words;
  for (std::size_t at = 0; at < array.data.size(); at += 4 * longest) {
    std::string word;
    for (std::size_t i = 0; i < longest && array.data[at + 4 * i] != '\0'; ++i) {
      word += array.data[at + 4 * i];
    }
    words.push_back(word);
  }
  return words;
}

/// A cube of side 2 from `x` on as an object of an OBJ file, after `before` vertices.
std::string cube_obj(const std::string& name, int x, int before) {
  std::string text = "o " + name + "\n";
  for (int i = 0; i < 8; ++i) {
    text += "v " + std::to_string(x + 2 * (i & 1)) + " " + std::to_string(i & 2) + " " +
            std::to_string((i & 4) / 2) + "\n";
  }
  for (const auto& face : {std::array{1, 3, 4, 2},
                           {5, 6, 8, 7},
                           {1, 2, 6, 5},
                           {3, 7, 8, 4},
                           {1, 5, 7, 3},
                           {2, 4, 8, 6}}) {
    text += "f";
    for (const int corner : face) {
      text += " " + std::to_string(corner + before);
    }
    text += "\n";
  }
  return text;
}

/// Little-endian bytes.
std::string bytes_of(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    bytes += static_cast<char>(value >> (8 * i) & 0xffU);
  }
  return bytes;
}

/// A .npy file of doubles.
std::string npy_file(const std::string& shape, const std::vector<double>& values) {
  const std::string text = described("<f8", shape) + "\n";
  std::string file = std::string("\x93NUMPY\x01\0", 8) + bytes_of(text.size(), 2) + text;
  for (const double value : values) {
    file += bytes_of(std::bit_cast<std::uint64_t>(value), 8);
  }
  return file;
}

class BinaryColumns : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::string written(const std::string& name, const std::string& content) const {
    write_text(at(name), content);
    return at(name);
  }

  TemporaryFolder folder_;
};

TEST_F(BinaryColumns, OfClosest) {
  const std::string points = written("points.npy", npy_file("(2, 3)", {0.25, 0.5, 3, 0, 0, 9}));
  ASSERT_EQ(soms_run({"closest", box(), "--points", points, "--signed", "--at-most", "4", "-o",
                      at("near.npz")})
                .status,
            0);
  auto arrays = arrays_of(at("near.npz"));
  ASSERT_EQ(arrays.size(), 11U);
  EXPECT_EQ(arrays["lower.npy"].header, described("<f8", "(2,)"));
  EXPECT_EQ(arrays["lower.npy"].numbers(), (std::vector<double>{2, 4}));
  EXPECT_EQ(arrays["upper.npy"].numbers(),
            (std::vector<double>{2, std::numeric_limits<double>::infinity()}));
  EXPECT_EQ(arrays["triangle.npy"].header, described("<i8", "(2,)"));
  EXPECT_EQ(arrays["triangle.npy"].counts().at(1), -1);
  EXPECT_EQ(arrays["point.npy"].header, described("<f8", "(2, 3)"));
  EXPECT_EQ(arrays["point.npy"].numbers()[2], 1);
  EXPECT_TRUE(std::isnan(arrays["point.npy"].numbers()[3]));
  EXPECT_EQ(arrays["feature.npy"].header, described("|u1", "(2,)"));
  EXPECT_EQ(names_of_codes(arrays["feature_names.npy"]),
            (std::vector<std::string>{"vertex", "edge", "face"}));
  EXPECT_EQ(arrays["feature.npy"].digits()[0], '2');
  EXPECT_EQ(arrays["farther.npy"].header, described("|b1", "(2,)"));
  EXPECT_EQ(arrays["farther.npy"].digits(), "01");
  EXPECT_EQ(arrays["side.npy"].digits(), "00");
  EXPECT_EQ(names_of_codes(arrays["side_names.npy"])[1], "inside");
  EXPECT_EQ(arrays["coverage.npy"].digits(), "00");
}

TEST_F(BinaryColumns, OfListsOfTriangles) {
  const std::string points = written("points.csv", "x,y,z\n0,0,3\n0,0,9\n");
  ASSERT_EQ(
      soms_run({"closest", box(), "--points", points, "--nearest", "3", "-o", at("lists.npz")})
          .status,
      0);
  auto arrays = arrays_of(at("lists.npz"));
  ASSERT_EQ(arrays.size(), 6U);
  EXPECT_EQ(arrays["offsets.npy"].counts(), (std::vector<std::int64_t>{0, 3, 6}));
  EXPECT_EQ(arrays["lower.npy"].numbers()[3], 8);
  EXPECT_EQ(arrays["triangle.npy"].counts().size(), 6U);
}

TEST_F(BinaryColumns, OfContains) {
  const std::string points = written("points.npy", npy_file("(3, 3)", {0, 0, 0, 0, 0, 1, 0, 0, 3}));
  ASSERT_EQ(soms_run({"contains", box(), "--points", points, "-o", at("sides.npz")}).status, 0);
  auto arrays = arrays_of(at("sides.npz"));
  ASSERT_EQ(arrays.size(), 4U);
  EXPECT_EQ(arrays["coverage.npy"].digits(), "000");
  EXPECT_EQ(arrays["side.npy"].digits(), "120");
  EXPECT_EQ(names_of_codes(arrays["side_names.npy"]),
            (std::vector<std::string>{"outside", "inside", "on", "undecided"}));
}

TEST_F(BinaryColumns, OfRays) {
  const std::string rays = written(
      "rays.npy", npy_file("(3, 7)", {0.25, 0.125, 3, 0, 0, -1, INFINITY, 9, 9, 9, 0, 0, 1, 5,  //
                                      0.25, 0.125, 3, 0, 0, -1, 1}));
  const auto answers = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"ray", box(), "--rays", rays, "-o", at("hits.npz")});
    EXPECT_EQ(soms_run(words).status, 0);
    return arrays_of(at("hits.npz"));
  };
  auto first = answers({});
  ASSERT_EQ(first.size(), 8U);
  EXPECT_EQ(first["hit.npy"].digits(), "100");
  EXPECT_EQ(first["lower.npy"].numbers()[0], 2);
  EXPECT_EQ(first["triangle.npy"].counts()[1], -1);
  EXPECT_EQ(first["point.npy"].header, described("<f8", "(3, 3)"));
  EXPECT_EQ(first["front.npy"].digits()[0], '1');
  auto any = answers({"--any"});
  ASSERT_EQ(any.size(), 3U);
  EXPECT_EQ(any["hit.npy"].digits(), "100");
  auto all = answers({"--all"});
  ASSERT_EQ(all.size(), 9U);
  EXPECT_EQ(all["offsets.npy"].counts(), (std::vector<std::int64_t>{0, 2, 2, 2}));
  EXPECT_EQ(all["lower.npy"].numbers(), (std::vector<double>{2, 4}));
  EXPECT_EQ(all["kind.npy"].digits(), "01");
  EXPECT_EQ(all["triangle_offsets.npy"].counts().back(),
            static_cast<std::int64_t>(all["triangle.npy"].counts().size()));
}

TEST_F(BinaryColumns, OfPairs) {
  const std::string poses = written(
      "poses.npy", npy_file("(2, 4, 4)", {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                                          1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  const auto answers = [&](std::vector<std::string> words) {
    words.insert(words.begin() + 1, {box(), box(), "--pose", poses, "-o", at("pairs.npz")});
    EXPECT_EQ(soms_run(words).status, 0);
    return arrays_of(at("pairs.npz"));
  };
  auto near = answers({"distance"});
  ASSERT_EQ(near.size(), 8U);
  EXPECT_EQ(near["lower.npy"].numbers(), (std::vector<double>{3, 0}));
  EXPECT_EQ(near["triangles.npy"].header, described("<i8", "(2, 2)"));
  EXPECT_EQ(near["point_a.npy"].header, described("<f8", "(2, 3)"));
  auto within = answers({"within", "--clearance", "1"});
  ASSERT_EQ(within.size(), 7U);
  EXPECT_EQ(within["within.npy"].digits(), "01");
  EXPECT_EQ(within["triangles.npy"].counts()[0], -1);
  auto solid = answers({"solid"});
  ASSERT_EQ(solid.size(), 7U);
  EXPECT_EQ(solid["relation.npy"].digits(), "02");
  EXPECT_EQ(names_of_codes(solid["relation_names.npy"])[2], "crossing");
  EXPECT_EQ(solid["surfaces_meet.npy"].digits(), "01");
}

// A pose apart and one at which two cubes in one file meet one of them.
TEST_F(BinaryColumns, OfPairsOfTrianglesAndOfParts) {
  const std::string poses = written("poses.csv", "x,y,z\n9,0,0\n0.5,0,0\n");
  const std::string cubes = written("cubes.obj", cube_obj("left", 0, 0) + cube_obj("right", 3, 8));
  const auto answers = [&](std::vector<std::string> words) {
    words.insert(words.begin() + 1, {cubes, cubes, "--pose", poses, "-o", at("pairs.npz")});
    EXPECT_EQ(soms_run(words).status, 0);
    return arrays_of(at("pairs.npz"));
  };
  auto all = answers({"overlap"});
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all["any.npy"].digits(), "01");
  EXPECT_EQ(all["coverage.npy"].digits(), "00");
  const std::vector<std::int64_t> offsets = all["offsets.npy"].counts();
  ASSERT_EQ(offsets.size(), 3U);
  EXPECT_EQ(offsets[1], 0);
  EXPECT_GT(offsets[2], 2);
  const auto pairs = static_cast<std::size_t>(offsets[2]);
  EXPECT_EQ(all["pairs.npy"].counts().size(), 2 * pairs);

  auto number = answers({"overlap", "--no-pairs"});
  ASSERT_EQ(number.size(), 4U);
  EXPECT_EQ(number["count.npy"].counts(), (std::vector<std::int64_t>{0, offsets[2]}));

  auto first = answers({"overlap", "--first"});
  EXPECT_EQ(first["offsets.npy"].counts(), (std::vector<std::int64_t>{0, 0, 1}));

  auto parts = answers({"overlap", "--by", "part"});
  ASSERT_EQ(parts.size(), 7U);
  EXPECT_EQ(parts["offsets.npy"].counts(), (std::vector<std::int64_t>{0, 0, 2}));
  EXPECT_EQ(parts["parts.npy"].counts(), (std::vector<std::int64_t>{0, 0, 1, 1}));
  EXPECT_EQ(parts["count.npy"].counts()[0] + parts["count.npy"].counts()[1], offsets[2]);
  EXPECT_EQ(parts["first.npy"].counts()[0], all["pairs.npy"].counts()[0]);

  auto solid = answers({"solid", "--by", "part"});
  ASSERT_EQ(solid.size(), 9U);  // names of codes, too
  EXPECT_EQ(solid["offsets.npy"].counts(), (std::vector<std::int64_t>{0, 0, 2}));
  EXPECT_EQ(solid["parts.npy"].counts(), (std::vector<std::int64_t>{0, 0, 1, 1}));
  EXPECT_EQ(solid["relation.npy"].digits(), "22");
  EXPECT_EQ(solid["surfaces_meet.npy"].digits(), "11");
  EXPECT_EQ(solid["coverage.npy"].digits(), "00");
}

TEST_F(BinaryColumns, OfOverlapWithinAreThoseOfWithin) {
  for (const std::string verb : {"overlap --clearance", "within --clearance"}) {
    std::vector<std::string> words{verb.substr(0, verb.find(' ')),
                                   box(),
                                   box(),
                                   verb.substr(verb.find(' ') + 1),
                                   "1",
                                   "--pose",
                                   "2.5 0 0",
                                   "-o",
                                   at(verb.substr(0, verb.find(' ')) + ".npz")};
    ASSERT_EQ(soms_run(words).status, 0) << verb;
  }
  EXPECT_EQ(read_text(at("overlap.npz")), read_text(at("within.npz")));
}

// Columns longer than what is kept in memory, by several threads.
TEST_F(BinaryColumns, AreTheSameInEveryRun) {
  std::vector<double> values;
  for (int i = 0; i < 12000; ++i) {
    values.insert(values.end(), {0.0625 * (i % 97), 0.125 * (i % 11), 2 + 0.25 * (i % 5)});
  }
  const std::string points = written("points.npy", npy_file("(12000, 3)", values));
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(soms_run({"closest", box(), "--points", points, "--threads", threads, "-o",
                        at(threads + ".npz")})
                  .status,
              0);
  }
  EXPECT_EQ(read_text(at("1.npz")), read_text(at("2.npz")));
  auto arrays = arrays_of(at("1.npz"));
  ASSERT_EQ(arrays["point.npy"].numbers().size(), 36000U);
  EXPECT_EQ(arrays["lower.npy"].numbers()[11640], 1);
}

TEST_F(BinaryColumns, AreWholeOrMissing) {
  const std::string bad = written("bad.csv", "x,y,z\n0,0,3\n0,0,nan\n");
  EXPECT_NE(soms_run({"closest", box(), "--points", bad, "-o", at("none.npz")}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(at("none.npz")));
  const std::string points = written("points.csv", "x,y,z\n0,0,3\n");
  const RunResult other = soms_run({"closest", box(), "--points", points, "-o", at("near.txt")});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find(".npz"), std::string::npos) << other.err;
  EXPECT_EQ(soms_run({"closest", box(), "--points", points, "-o", points}).status, 2);
}

TEST_F(BinaryColumns, AreFinishedByCtrlC) {
  Pipe pipe(at("points"), "x,y,z\n0,0,3\n");
  Child child({command().string(), "closest", box(), "--points", pipe.path(), "--json", "-o",
               at("near.npz")},
              folder_.path());
  ASSERT_TRUE(child.wait_for_lines(1));
  child.send(SIGINT);
  EXPECT_EQ(child.wait().status, 130);
  EXPECT_EQ(arrays_of(at("near.npz"))["lower.npy"].numbers(), std::vector<double>{2});
}

TEST_F(BinaryColumns, TakeRowsOfArraysFromStandardInput) {
  const RunResult result =
      soms_run({"closest", box(), "--points", "-", "--json"}, npy_file("(1, 3)", {0, 0, 3}));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json_lines(result.out).at(0).at("lower"), 2);
  const std::string integers = written(
      "i.npy", std::string("\x93NUMPY\x01\0", 8) + bytes_of(described("<i8", "(1, 3)").size(), 2) +
                   described("<i8", "(1, 3)") + std::string(24, '\0'));
  const RunResult refused = soms_run({"closest", box(), "--points", integers});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("save array.astype('<f8')"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace soms::test
