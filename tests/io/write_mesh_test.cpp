#include "soms/io/write_mesh.h"

#include "soms/base/error.h"
#include "soms/io/new_file.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::test {
namespace {

constexpr std::array<std::pair<MeshFormat, const char*>, 6> kFormats = {{
    {MeshFormat::ply, ".ply"},
    {MeshFormat::ply_ascii, ".ply"},
    {MeshFormat::obj, ".obj"},
    {MeshFormat::stl, ".stl"},
    {MeshFormat::stl_ascii, ".stl"},
    {MeshFormat::off, ".off"},
}};

bool is_stl(MeshFormat format) {
  return format == MeshFormat::stl || format == MeshFormat::stl_ascii;
}

std::string written(const Mesh& mesh, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, "out", mesh, format);
  return out.str();
}

/// A mesh whose coordinates are floats of all sizes, or doubles.
Mesh random_mesh(Rng& rng, bool floats) {
  Mesh mesh;
  const std::uint64_t count = 1 + rng.below(50);
  for (std::uint64_t i = 0; i < count; ++i) {
    Vec3 v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double large =
          std::ldexp(rng.uniform(-1, 1),
                     static_cast<int>(rng.below(floats ? 250 : 1300)) - (floats ? 140 : 1010));
      v[axis] = floats ? static_cast<double>(static_cast<float>(large)) : large;
    }
    mesh.vertices.push_back(v);
  }
  const std::uint64_t triangles = 1 + rng.below(100);
  for (std::uint64_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({static_cast<std::uint32_t>(rng.below(count)),
                              static_cast<std::uint32_t>(rng.below(count)),
                              static_cast<std::uint32_t>(rng.below(count))});
  }
  return mesh;
}

TEST(WriteMesh, IsReadBackEqual) {
  for_each_case("io/round-trip", 100, [](Rng& rng) {
    const bool floats = rng.below(2) == 0;
    const Mesh mesh = random_mesh(rng, floats);
    for (const auto& [format, extension] : kFormats) {
      if (format == MeshFormat::stl && !floats) {
        continue;
      }
      SCOPED_TRACE(static_cast<int>(format));
      const Mesh back = read_text(written(mesh, format), std::string("out") + extension);
      EXPECT_EQ(corner_hash(back), corner_hash(mesh));
      if (!is_stl(format)) {
        EXPECT_EQ(back.vertices, mesh.vertices);
        EXPECT_EQ(back.triangles, mesh.triangles);
      }
      EXPECT_TRUE(back.faces.empty());
    }
  });
}

TEST(WriteMesh, WritesTheSameBytesEveryTime) {
  Rng rng(7);
  const Mesh mesh = random_mesh(rng, true);
  for (const auto& [format, extension] : kFormats) {
    EXPECT_EQ(written(mesh, format), written(mesh, format));
  }
}

TEST(WriteMesh, WritesExactlyThis) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.1, -0.0, 0}, {0, 1e22, 1}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(written(mesh, MeshFormat::obj), "v 0 0 0\nv 0.1 -0 0\nv 0 1e+22 1\nf 1 2 3\n");
  EXPECT_EQ(written(mesh, MeshFormat::off), "OFF\n3 1 0\n0 0 0\n0.1 -0 0\n0 1e+22 1\n3 0 1 2\n");
  EXPECT_EQ(written(mesh, MeshFormat::ply_ascii),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
            "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n0.1 -0 0\n0 1e+22 1\n3 0 1 2\n");
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(written(mesh, MeshFormat::stl_ascii),
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\n"
            "endloop\nendfacet\nendsolid\n");
}

TEST(WriteMesh, KeepsPartsAsGroupsAndSolids) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(6, {0, 1, 2});
  mesh.parts = {{"whole car", Part::kNoParent, 1, 4},
                {"left\nwheel\\", 0, 2, 2},
                {"", Part::kNoParent, 0, 1}};
  const std::vector<Part> expected = {{"", Part::kNoParent, 0, 1},
                                      {"whole car", Part::kNoParent, 1, 1},
                                      {"left_wheel_", Part::kNoParent, 2, 2},
                                      {"whole car", Part::kNoParent, 4, 1},
                                      {"", Part::kNoParent, 5, 1}};
  EXPECT_EQ(read_text(written(mesh, MeshFormat::stl_ascii), "a.stl").parts, expected);
  const std::vector<Part> nested = {{"", Part::kNoParent, 0, 1},
                                    {"whole car", Part::kNoParent, 1, 4},
                                    {"left_wheel_", 1, 2, 2},
                                    {"", Part::kNoParent, 5, 1}};
  EXPECT_EQ(read_text(written(mesh, MeshFormat::obj), "a.obj").parts, nested);
}

TEST(WriteMesh, ChoosesTheInnermostPartAsPartOfDoes) {
  for_each_case("io/parts", 200, [](Rng& rng) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}};
    mesh.triangles.assign(12, {0, 0, 0});
    for (std::uint64_t i = rng.below(6); i > 0; --i) {
      const auto first = static_cast<std::uint32_t>(rng.below(12));
      const auto count = static_cast<std::uint32_t>(rng.below(13 - first));
      mesh.parts.push_back({std::to_string(i), Part::kNoParent, first, count});
    }
    const Mesh back = read_text(written(mesh, MeshFormat::obj), "a.obj");
    for (TriangleId i = 0; i < 12; ++i) {
      const std::uint32_t wanted = part_of(mesh, i);
      const std::uint32_t found = part_of(back, i);
      EXPECT_EQ(found == Part::kNoParent ? "" : back.parts[found].name,
                wanted == Part::kNoParent ? "" : mesh.parts[wanted].name);
    }
  });
}

TEST(WriteMesh, GivesNormalsThatAreRightHandedAndFinite) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e-30, 0, 0}, {0, 1e-30, 0}, {0x1p120, 0, 0}, {0, 0, 0x1p120}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {0, 1, 1}};
  const std::string bytes = written(mesh, MeshFormat::stl);
  const auto normal = [&](std::size_t i) { return bytes.substr(84 + 50 * i, 12); };
  EXPECT_EQ(normal(0), bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(1.0F));
  EXPECT_EQ(normal(1), bytes_of(0.0F) + bytes_of(-1.0F) + bytes_of(0.0F));
  EXPECT_EQ(normal(2), bytes_of(0.0F) + bytes_of(0.0F) + bytes_of(0.0F));
}

TEST(WriteMesh, RefusesWhatAFloatCannotHold) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e39, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 2, 2}, {0, 1, 2}};
  expect_refused([&] { static_cast<void>(written(mesh, MeshFormat::stl)); },
                 ErrorKind::out_of_range, "out: triangle 1 has a coordinate that a float cannot");
  EXPECT_NO_THROW(static_cast<void>(written(mesh, MeshFormat::stl_ascii)));
}

TEST(WriteMesh, RefusesMeshesThatCouldNotBeReadBack) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
  mesh.triangles = {{0, 0, 0}};
  expect_refused([&] { static_cast<void>(written(mesh, MeshFormat::off)); }, ErrorKind::not_finite,
                 "vertex 1 is not finite");
  mesh.triangles = {{0, 0, 2}};
  expect_refused([&] { static_cast<void>(written(mesh, MeshFormat::off)); }, ErrorKind::bad_file,
                 "vertex 2, but vertices are 0 to 1");
}

TEST(WriteMesh, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "out.ply";
  const auto files = [&] {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      ++count;
    }
    return count;
  };
  Rng rng(1);
  const Mesh mesh = random_mesh(rng, true);
  std::stop_source stop;
  stop.request_stop();
  expect_refused([&] { write_mesh(path, mesh, MeshFormat::ply, {.stop = stop.get_token()}); },
                 ErrorKind::cancelled, "stopped");
  EXPECT_EQ(files(), 0U);
  write_mesh(path, mesh, MeshFormat::ply);
  EXPECT_EQ(files(), 1U);
  const std::string first = content_of(path);
  expect_refused([&] { write_mesh(path, mesh, MeshFormat::ply, {.stop = stop.get_token()}); },
                 ErrorKind::cancelled, "stopped");
  EXPECT_EQ(content_of(path), first);
  write_mesh(path, mesh, MeshFormat::ply_ascii);
  EXPECT_NE(content_of(path), first);
  EXPECT_EQ(files(), 1U);
}

TEST(WriteMesh, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  Rng rng(1);
  const Mesh mesh = random_mesh(rng, true);
  const std::filesystem::path target = folder.path() / "target.ply";
  write_content(target, "old");
  ASSERT_EQ(chmod(target.c_str(), 0640), 0);
  std::filesystem::create_symlink("target.ply", folder.path() / "link.ply");
  write_mesh(folder.path() / "link.ply", mesh, MeshFormat::ply);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.ply"));
  EXPECT_EQ(read_mesh(target).triangles, mesh.triangles);
  EXPECT_EQ(static_cast<int>(std::filesystem::status(target).permissions()), 0640);
}

// A backup that shares its files by hard links must not change with them.
TEST(WriteMesh, LeavesOtherNamesOfTheOldFileAlone) {
  const TemporaryFolder folder;
  Rng rng(1);
  const Mesh mesh = random_mesh(rng, true);
  const std::filesystem::path target = folder.path() / "target.ply";
  const std::filesystem::path backup = folder.path() / "backup.ply";
  write_content(backup, "old");
  std::filesystem::create_hard_link(backup, target);
  write_mesh(target, mesh, MeshFormat::ply);
  EXPECT_EQ(content_of(backup), "old");
  EXPECT_EQ(read_mesh(target).triangles, mesh.triangles);
  EXPECT_EQ(std::filesystem::hard_link_count(target), 1U);
  NewFile file;
  ASSERT_EQ(file.open(target), 0);
  EXPECT_EQ(file.other_names(), 0U);
  std::filesystem::create_hard_link(backup, folder.path() / "third.ply");
  NewFile other;
  ASSERT_EQ(other.open(backup), 0);
  EXPECT_EQ(other.other_names(), 1U);
}

TEST(WriteMesh, FollowsLinksToFilesThatAreNotThereYet) {
  const TemporaryFolder folder;
  Rng rng(1);
  const Mesh mesh = random_mesh(rng, true);
  const std::filesystem::path target = folder.path() / "results" / "target.ply";
  std::filesystem::create_directory(folder.path() / "results");
  std::filesystem::create_symlink("results/next.ply", folder.path() / "first.ply");
  std::filesystem::create_symlink("target.ply", folder.path() / "results" / "next.ply");
  write_mesh(folder.path() / "first.ply", mesh, MeshFormat::ply);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "first.ply"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "results" / "next.ply"));
  EXPECT_EQ(read_mesh(target).triangles, mesh.triangles);

  std::filesystem::create_symlink(folder.path() / "absolute.ply", folder.path() / "far.ply");
  write_mesh(folder.path() / "far.ply", mesh, MeshFormat::ply);
  EXPECT_EQ(read_mesh(folder.path() / "absolute.ply").triangles, mesh.triangles);

  std::filesystem::create_symlink("circle.ply", folder.path() / "circle.ply");
  expect_refused([&] { write_mesh(folder.path() / "circle.ply", mesh, MeshFormat::ply); },
                 ErrorKind::cannot_write, "circle.ply: Too many levels of symbolic links");
}

TEST(WriteMesh, WritesEmptyModelsThatAreReadBack) {
  for (const MeshFormat format : {MeshFormat::ply, MeshFormat::obj, MeshFormat::off}) {
    std::ostringstream out;
    write_mesh(out, "out", Mesh{}, format);
    for (const std::string name : {"a.obj", "standard input"}) {
      if (format == MeshFormat::obj || name != "a.obj") {
        const Mesh back = read_text(out.str(), name, {.allow_empty = true});
        EXPECT_TRUE(back.vertices.empty() && back.triangles.empty() && back.parts.empty());
      }
    }
  }
}

TEST(Rounding, LeavesOutVerticesThatAreNotWritten) {
  Mesh mesh;
  mesh.vertices = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 1e9 + 0.1, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::three_ds}) {
    EXPECT_EQ(rounding(mesh, format).count, 1U);
    EXPECT_EQ(rounding(mesh, format).most, double{0.1F} - 0.1);
  }
  EXPECT_EQ(rounding(mesh, MeshFormat::glb).count, 2U);
}

TEST(WriteMesh, NamesWhatCannotBeWritten) {
  const TemporaryFolder folder;
  Rng rng(1);
  const Mesh mesh = random_mesh(rng, true);
  const auto refuse = [&](const std::filesystem::path& path, const std::string& words) {
    expect_refused([&] { write_mesh(path, mesh, MeshFormat::obj); }, ErrorKind::cannot_write,
                   words);
  };
  refuse(folder.path() / "missing" / "out.obj", "out.obj: No such file or directory");
  refuse(folder.path(), "Is a directory");
  if (std::filesystem::exists("/dev/full")) {
    refuse("/dev/full", "No space left on device");
  }
  std::ostringstream closed;
  closed.setstate(std::ios::badbit);
  expect_refused([&] { write_mesh(closed, "standard output", mesh, MeshFormat::obj); },
                 ErrorKind::cannot_write, "standard output: cannot write to the stream");
}

TEST(FormatFor, GoesByTheExtension) {
  EXPECT_EQ(format_for("a.ply"), MeshFormat::ply);
  EXPECT_EQ(format_for("a.b/c.OBJ"), MeshFormat::obj);
  EXPECT_EQ(format_for("a.Stl"), MeshFormat::stl);
  EXPECT_EQ(format_for("a.off"), MeshFormat::off);
  EXPECT_EQ(format_for("a.3DS"), MeshFormat::three_ds);
  EXPECT_EQ(format_for("a.glb"), MeshFormat::glb);
  for (const std::string name : {"a", "a.ply/b", "a.gltf", ""}) {
    expect_refused([&] { static_cast<void>(format_for(name)); }, ErrorKind::unsupported,
                   "use .ply, .3ds, .stl, .off, .obj or .glb");
  }
}

}  // namespace
}  // namespace soms::test
