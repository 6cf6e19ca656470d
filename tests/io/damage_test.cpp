// Files that were cut or changed anywhere end in typed errors or in meshes that pass check().
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// Reads what may be damaged: only a typed error or a sound mesh may come of it. True if it loads.
bool loads(const std::string& content, const std::string& name, std::size_t* triangles = nullptr) {
  const auto refusal = refusal_of([&] {
    const Mesh mesh = read_text(content, name, {.allow_empty = true});
    check(mesh);
    EXPECT_LE(mesh.triangles.size(), content.size());
    if (triangles != nullptr) {
      *triangles = mesh.triangles.size();
    }
  });
  if (refusal) {
    EXPECT_NE(refusal->kind, ErrorKind::usage) << refusal->words;
    EXPECT_NE(refusal->words.find(name), std::string::npos) << refusal->words;
  }
  return !refusal;
}

/// Files of tests/data in the formats that are read, small enough to be read often.
std::vector<std::string> small_files() {
  std::vector<std::string> files;
  for (const auto& row : rows_of("formats/FORMATS.csv", 1)) {
    if (is_read(row[0])) {
      files.push_back("formats/" + row[0]);
    }
  }
  return files;
}

/// Cut at each offset: `end` is where nothing but line ends and comments is left. Before it, a file
/// that states its counts does not load; at most its last number may have been cut unseen.
void expect_cuts_refused(const std::string& file, std::size_t last_number) {
  SCOPED_TRACE(file);
  const std::string whole = content_of(test::data(file));
  std::size_t loaded = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::size_t triangles = 0;
    if (loads(whole.substr(0, size), file, &triangles)) {
      ++loaded;
      EXPECT_EQ(triangles, 114U) << "cut at " << size;
      EXPECT_GE(size + last_number, whole.size()) << "cut at " << size;
    }
  }
  EXPECT_LE(loaded, last_number);
  EXPECT_TRUE(loads(whole, file));
}

TEST(Damage, CutFilesAreRefusedWhereverTheyAreCut) {
  expect_cuts_refused("formats/le_float.ply", 0);
  expect_cuts_refused("formats/be_double.ply", 0);
  expect_cuts_refused("formats/extra_le.ply", 200);  // an element stands behind the faces
  expect_cuts_refused("formats/tristrips_be.ply", 0);
  expect_cuts_refused("formats/ascii.ply", 3);
  expect_cuts_refused("formats/binary.stl", 0);
  expect_cuts_refused("formats/binary_solid_text.stl", 0);
  expect_cuts_refused("formats/ascii.stl", 12);  // behind "endsolid"
  expect_cuts_refused("formats/plain.off", 3);
  expect_cuts_refused("formats/plain.3ds", 0);
  expect_cuts_refused("formats/z_up_polylist.dae", 1);  // the last line end
  expect_cuts_refused("formats/interleaved.glb", 0);
  expect_cuts_refused("formats/sparse.gltf", 0);
  expect_cuts_refused("formats/batched.b3dm", 0);
  expect_cuts_refused("formats/composite.cmpt", 0);
}

TEST(Damage, CutObjFilesGiveTypedErrorsOrSoundMeshes) {
  // OBJ states no counts: what is missing cannot be seen.
  const std::string whole = content_of(test::data("formats/v_vt_vn.obj"));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    loads(whole.substr(0, size), "cut.obj");
  }
}

TEST(Damage, ChangedBytesGiveTypedErrorsOrSoundMeshes) {
  const std::vector<std::string> files = small_files();
  ASSERT_EQ(files.size(), 100U);
  int sound = 0;
  for (const std::string& file : files) {
    const std::string whole = content_of(test::data(file));
    for_each_case("damage/" + file, 150, [&](Rng& rng) {
      std::string changed = whole;
      const std::uint64_t changes = 1 + rng.below(4);
      for (std::uint64_t i = 0; i < changes; ++i) {
        // Headers hold what matters most: half of the changes go there.
        const std::size_t reach =
            rng.below(2) == 0 ? std::min<std::size_t>(300, changed.size()) : changed.size();
        const std::size_t at = rng.below(reach);
        switch (rng.below(4)) {
          case 0:
            changed[at] = static_cast<char>(rng.below(256));
            break;
          case 1:
            changed[at] = static_cast<char>(changed[at] ^ (1 << rng.below(8)));
            break;
          case 2:
            changed.erase(at, 1 + rng.below(8));
            break;
          default:
            changed.insert(at, changed.substr(rng.below(changed.size()), 1 + rng.below(16)));
        }
        if (changed.empty()) {
          changed = whole;
        }
      }
      sound += loads(changed, file) ? 1 : 0;
    });
  }
  EXPECT_GT(sound, 0);
}

TEST(Damage, HostileNumbersGiveTypedErrorsOrSoundMeshes) {
  const std::vector<std::string> words = {
      "-1",     "0", "4294967295", "2147483648", "1e999", "nan", "-inf", "18446744073709551617",
      "1e-999", "+", "1.5",        "\\",         "\r",    "#",   "/",    "0x10"};
  for (const std::string& file : small_files()) {
    const std::string whole = content_of(test::data(file));
    for_each_case("damage/words/" + file, 60, [&](Rng& rng) {
      std::string changed = whole;
      const std::size_t begin = changed.find_first_of("0123456789", rng.below(changed.size()));
      if (begin != std::string::npos) {
        const std::size_t end = changed.find_first_not_of("0123456789.-", begin);
        changed.replace(begin, end - begin, words[rng.below(words.size())]);
      }
      loads(changed, file);
    });
  }
}

}  // namespace
}  // namespace soms::test
