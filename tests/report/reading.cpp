#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace soms::test {

std::string element(std::string_view page, std::string_view id) {
  const std::string mark = "id=\"soms-" + std::string(id) + "\">";
  const std::size_t at = page.find(mark);
  EXPECT_NE(at, std::string_view::npos) << id;
  if (at == std::string_view::npos) {
    return "";
  }
  EXPECT_EQ(page.find(mark, at + 1), std::string_view::npos) << id;
  const std::size_t begin = at + mark.size();
  return std::string(page.substr(begin, page.find("</script", begin) - begin));
}

std::vector<std::uint8_t> bytes_of(std::string_view base64) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_EQ(base64.size() % 4, 0U);
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) {
      EXPECT_EQ(c, '=');
      continue;
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::uint8_t>((bits >> held) & 0xffU));
    }
  }
  return bytes;
}

std::vector<std::uint32_t> words_of(std::string_view base64) {
  const std::vector<std::uint8_t> bytes = bytes_of(base64);
  EXPECT_EQ(bytes.size() % 4, 0U);
  std::vector<std::uint32_t> words(bytes.size() / 4, 0);
  for (std::size_t k = 0; k < 4 * words.size(); ++k) {
    words[k / 4] |= std::uint32_t{bytes[k]} << (8 * (k % 4));
  }
  return words;
}

std::vector<float> floats_of(std::string_view base64) {
  std::vector<float> floats;
  for (const std::uint32_t word : words_of(base64)) {
    floats.push_back(std::bit_cast<float>(word));
  }
  return floats;
}

namespace {

/// Numbers of as few bytes as they need.
class PackedReader {
 public:
  explicit PackedReader(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] bool done() const { return at_ == bytes_.size(); }

  std::uint64_t next() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; at_ < bytes_.size(); shift += 7) {
      const std::uint8_t byte = bytes_[at_++];
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80U) {
        return value;
      }
    }
    ADD_FAILURE() << "the numbers are cut off";
    return value;
  }

  std::int64_t next_signed() {
    const std::uint64_t value = next();
    return static_cast<std::int64_t>(value >> 1U) ^ -static_cast<std::int64_t>(value & 1U);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace

PageMesh mesh_of(std::string_view page, std::string_view id, double step, std::uint64_t triangles) {
  PackedReader numbers(bytes_of(element(page, id)));
  PageMesh mesh;
  std::array<std::int64_t, 3> at{};
  while (!numbers.done() && mesh.indices.size() / 3 < triangles) {
    const std::uint64_t back = numbers.next();
    if (back == 0) {
      for (std::int64_t& part : at) {
        part += numbers.next_signed();
      }
      mesh.vertices.push_back({static_cast<double>(at[0]) * step, static_cast<double>(at[1]) * step,
                               static_cast<double>(at[2]) * step});
    }
    EXPECT_LE(back, mesh.vertices.size());
    mesh.indices.push_back(
        static_cast<std::uint32_t>(mesh.vertices.size() - std::max<std::uint64_t>(back, 1)));
  }
  while (!numbers.done()) {
    const std::uint64_t length = numbers.next();
    mesh.parts.push_back({length, numbers.next()});
  }
  return mesh;
}

std::vector<std::array<double, 7>> poses_of(std::string_view page) {
  const nlohmann::json scene = scene_of(page);
  const std::size_t kept = scene["steps"]["kept"].size();
  PackedReader numbers(bytes_of(element(page, "poses")));
  std::vector<std::array<double, 7>> poses;
  while (!numbers.done()) {
    std::array<std::int64_t, 7> now{};
    std::array<std::int64_t, 7> change{};
    for (std::size_t k = 0; k < kept; ++k) {
      std::array<double, 7> pose{};
      for (std::size_t n = 0; n < 7; ++n) {
        const std::int64_t by = numbers.next_signed() + change[n];
        now[n] += by;
        change[n] = k == 0 ? 0 : by;
        pose[n] = static_cast<double>(now[n]) *
                  (n < 3 ? scene["place_step"].get<double>() : 1 / scene["turns"].get<double>());
      }
      poses.push_back(pose);
    }
  }
  return poses;
}

std::vector<PagePair> pairs_of(std::string_view page) {
  const double step = scene_of(page)["place_step"];
  PackedReader numbers(bytes_of(element(page, "pairs")));
  std::vector<PagePair> pairs;
  while (!numbers.done()) {
    PagePair pair;
    pair.i = numbers.next();
    pair.j = numbers.next();
    std::array<std::int64_t, 3> at{};
    for (auto& point : pair.points) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at[axis] += numbers.next_signed();
        point[axis] = static_cast<double>(at[axis]) * step;
      }
    }
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<std::array<std::int64_t, 6>> lines_of(std::string_view page,
                                                  const std::vector<std::uint32_t>& counts) {
  PackedReader numbers(bytes_of(element(page, "lines")));
  std::vector<std::array<std::int64_t, 6>> lines;
  for (const std::uint32_t count : counts) {
    std::array<std::int64_t, 3> start{};
    for (std::uint32_t k = 0; k < count; ++k) {
      std::array<std::int64_t, 6> line{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        line[axis] = start[axis] += numbers.next_signed();
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        line[3 + axis] = start[axis] + numbers.next_signed();
      }
      lines.push_back(line);
    }
  }
  EXPECT_TRUE(numbers.done());
  return lines;
}

nlohmann::json scene_of(std::string_view page) {
  return nlohmann::json::parse(element(page, "scene"));
}

}  // namespace soms::test
