/// \file
/// Files for tests of readers: made on the spot, read from memory, compared.
#pragma once

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// Reads a model from memory; `name` ends with the format.
[[nodiscard]] Mesh read_text(std::string_view content, const std::string& name,
                             const ReadOptions& options = {});

/// Kind and words of the error that an action throws; nothing if it throws none.
struct Refusal {
  ErrorKind kind = ErrorKind::usage;
  std::string words;
};

[[nodiscard]] std::optional<Refusal> refusal_of(const std::function<void()>& action);

/// Expects an error of this kind whose message holds `words`.
void expect_refused(const std::function<void()>& action, ErrorKind kind, const std::string& words);

/// The same for a model in memory.
void expect_refused(std::string_view content, const std::string& name, ErrorKind kind,
                    const std::string& words);

/// `content` with up to four bytes changed, taken out or doubled.
[[nodiscard]] std::string damaged(std::string content, Rng& rng);

/// Expects a typed error, which is no misuse, or a sound mesh.
void expect_typed_or_sound(const std::function<Mesh()>& read);

[[nodiscard]] std::string content_of(const std::filesystem::path& path);

void write_content(const std::filesystem::path& path, std::string_view content);

/// Rows of a CSV file of which the last column may hold commas in quotes: the first `columns`.
[[nodiscard]] std::vector<std::vector<std::string>> rows_of(std::string_view file,
                                                            std::size_t columns);

/// True for the extensions of the formats that are read.
[[nodiscard]] bool is_read(const std::string& file);

/// Little-endian bytes, for binary files made in tests.
[[nodiscard]] std::string bytes_of(std::uint64_t value, std::size_t count);
[[nodiscard]] std::string bytes_of(float value);
[[nodiscard]] std::string bytes_of(double value);

}  // namespace soms::test
