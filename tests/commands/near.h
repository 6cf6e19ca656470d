/// \file
/// What tests of the verbs `distance` and `within` share.
#pragma once

#include "tests/commands/run.h"

#include <string>
#include <vector>

namespace soms::test {

/// Answers of `verb` about two boxes [-1, 1]^3, each a JSON object. The verb must succeed and
/// have nothing to remark.
[[nodiscard]] inline std::vector<Json> near_answers(const std::string& verb,
                                                    std::vector<std::string> words) {
  words.insert(words.begin(), {verb, box(), box(), "--json"});
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return json_lines(result.out);
}

/// Two walls beside each other: A's part `far` is triangle 0, its part `near` triangle 1, 1 below
/// the triangle of B.
struct TwoWalls {
  TemporaryFolder folder;
  std::string a = (folder.path() / "a.obj").string();
  std::string b = (folder.path() / "b.off").string();

  TwoWalls() {
    write_text(a,
               "o far\nv 0 0 -9\nv 1 0 -9\nv 0 1 -9\nf 1 2 3\n"
               "o near\nv 0 0 0\nv 4 0 0\nv 0 4 0\nf 4 5 6\n");
    write_text(b, triangle_off("1 1 1", "1 1 5", "2 1 5"));
  }
};

/// A file of `text` in a folder.
[[nodiscard]] inline std::string file_of(const TemporaryFolder& folder, const std::string& name,
                                         const std::string& text) {
  const std::string path = (folder.path() / name).string();
  write_text(path, text);
  return path;
}

}  // namespace soms::test
