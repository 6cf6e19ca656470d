#include "tests/io/files.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <fstream>
#include <span>
#include <sstream>

namespace soms::test {

Mesh read_text(std::string_view content, const std::string& name, const ReadOptions& options) {
  return read_mesh(std::as_bytes(std::span(content.data(), content.size())), name, options);
}

std::optional<Refusal> refusal_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return Refusal{error.kind(), error.what()};
  }
  return std::nullopt;
}

void expect_refused(const std::function<void()>& action, ErrorKind kind, const std::string& words) {
  const std::optional<Refusal> refusal = refusal_of(action);
  ASSERT_TRUE(refusal) << "nothing was refused; expected: " << words;
  EXPECT_EQ(name(refusal->kind), name(kind)) << refusal->words;
  EXPECT_NE(refusal->words.find(words), std::string::npos)
      << "\"" << refusal->words << "\" does not hold \"" << words << "\"";
}

void expect_refused(std::string_view content, const std::string& name, ErrorKind kind,
                    const std::string& words) {
  SCOPED_TRACE(name);
  expect_refused([&] { static_cast<void>(read_text(content, name)); }, kind, words);
}

std::string damaged(std::string content, Rng& rng) {
  const std::uint64_t changes = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < changes && !content.empty(); ++i) {
    const std::size_t at = rng.below(content.size());
    switch (rng.below(3)) {
      case 0:
        content[at] = static_cast<char>(rng.below(256));
        break;
      case 1:
        content.erase(at, 1 + rng.below(8));
        break;
      default:
        content.insert(at, content.substr(rng.below(content.size()), 1 + rng.below(16)));
    }
  }
  return content;
}

void expect_typed_or_sound(const std::function<Mesh()>& read) {
  const auto refusal = refusal_of([&] { check(read()); });
  if (refusal) {
    EXPECT_NE(refusal->kind, ErrorKind::usage) << refusal->words;
  }
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream content;
  content << in.rdbuf();
  return content.str();
}

void write_content(const std::filesystem::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::vector<std::vector<std::string>> rows_of(std::string_view file, std::size_t columns) {
  std::vector<std::vector<std::string>> rows = read_csv(test::data(file));
  rows.erase(rows.begin());
  for (std::vector<std::string>& row : rows) {
    row.resize(columns);
  }
  return rows;
}

bool is_read(const std::string& file) {
  constexpr std::array<std::string_view, 14> kExtensions = {
      ".ply", ".3ds",  ".3DS", ".stl",  ".STL",   ".off",  ".obj",
      ".glb", ".gltf", ".dae", ".json", ".jsonl", ".b3dm", ".cmpt"};
  return std::any_of(kExtensions.begin(), kExtensions.end(),
                     [&](std::string_view extension) { return file.ends_with(extension); });
}

std::string bytes_of(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    bytes += i < sizeof(value) ? static_cast<char>(value >> (8 * i) & 0xff) : '\0';
  }
  return bytes;
}

std::string bytes_of(float value) {
  return bytes_of(std::bit_cast<std::uint32_t>(value), sizeof(value));
}

std::string bytes_of(double value) {
  return bytes_of(std::bit_cast<std::uint64_t>(value), sizeof(value));
}

}  // namespace soms::test
