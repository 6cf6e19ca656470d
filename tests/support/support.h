/// \file
/// What all tests share: seeded cases that are reproduced by name, and the test data.
#pragma once

#include "soms/base/random.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::test {

/// Runs `body` for cases 0 to n-1. Each is seeded by tag and number, both are traced, and the first
/// failure ends the loop, so a failure is reproduced by name. SOMS_TEST_FACTOR multiplies n.
void for_each_case(std::string_view tag, int n, const std::function<void(Rng&)>& body);

/// A file of tests/data; files kept as .xz are requested by the name without it and unpacked once.
[[nodiscard]] std::filesystem::path data(std::string_view name);

/// A file of the folder SOMS_DATA (models and cities of others), or nothing where it is unset.
[[nodiscard]] std::optional<std::filesystem::path> outside_data(std::string_view name);

/// The built command.
[[nodiscard]] std::filesystem::path command();

/// Lines of a CSV file, split at commas outside of quotes; no field holds a line break.
[[nodiscard]] std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& file);

/// A fresh folder that is removed when the object ends.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// What a program that was run left behind.
struct RunResult {
  int status = 0;  ///< exit status; 128 + n when signal n ended it
  std::string out;
  std::string err;
};

/// Runs a program with arguments and no shell; `input` goes to its standard input.
[[nodiscard]] RunResult run_program(const std::vector<std::string>& arguments,
                                    const std::string& input = {});

}  // namespace soms::test

/// Skips a test aloud where SOMS_DATA is unset; `what` names what goes untested, with its count.
#define SOMS_NEEDS_OUTSIDE_DATA(what)                         \
  if (!::soms::test::outside_data("")) {                      \
    GTEST_SKIP() << "SOMS_DATA is unset: skipped " << (what); \
  }                                                           \
  static_assert(true)
