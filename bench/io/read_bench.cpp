// How fast is a model of a million triangles read, and in how much memory?
//
// `read_bench [TRIANGLES]` writes a knot in each format to a temporary folder, reads each file
// several times, in turns, and reads it once more in a process of its own, whose peak memory is set
// against that of the mesh. What is behind a file name in the table: `short` coordinates have six
// digits behind the point, as most files have; the others all digits of a double.
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "bench/measure.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace soms::bench {
namespace {

constexpr int kPasses = 7;

double now(clockid_t clock) {
  std::timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A folder that is removed when the program ends.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "read-bench-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("cannot make a temporary folder");
    }
    path_ = pattern;
  }

  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A file to be read, and what its reading took.
struct FileUnderTest {
  std::string name;
  std::filesystem::path file;
  double goal = 0;  ///< MB/s; 0 for none
  std::vector<double> processor = {};
  std::vector<double> wall = {};
};

/// Our own writer has no floats in PLY, but nearly all files of others do.
void write_float_ply(const std::filesystem::path& path, const Mesh& mesh) {
  std::ofstream out(path, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto put = [&](auto value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const Vec3& v : mesh.vertices) {
    put(static_cast<float>(v.x));
    put(static_cast<float>(v.y));
    put(static_cast<float>(v.z));
  }
  for (const auto& triangle : mesh.triangles) {
    out.put(3);
    for (const std::uint32_t corner : triangle) {
      put(corner);
    }
  }
}

Mesh rounded(Mesh mesh) {
  for (Vec3& v : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] = std::round(v[axis] * 1e6) / 1e6;
    }
  }
  return mesh;
}

std::vector<FileUnderTest> written(const std::filesystem::path& folder, std::uint64_t triangles) {
  constexpr double kBinaryGoal = 200;
  constexpr double kTextGoal = 60;
  const Mesh mesh = generate_knot(triangles);
  const Mesh brief = rounded(mesh);
  std::vector<FileUnderTest> all;
  const auto add = [&](const char* name, const char* file, const Mesh& m, MeshFormat format,
                       double goal = 0) {
    all.push_back({name, folder / file, goal});
    write_mesh(all.back().file, m, format);
  };
  all.push_back({"PLY binary float", folder / "float.ply", kBinaryGoal});
  write_float_ply(all.back().file, mesh);
  add("PLY binary double", "double.ply", mesh, MeshFormat::ply, kBinaryGoal);
  add("PLY ascii short", "short.ply", brief, MeshFormat::ply_ascii, kTextGoal);
  add("PLY ascii double", "ascii.ply", mesh, MeshFormat::ply_ascii, kTextGoal);
  add("OBJ short", "short.obj", brief, MeshFormat::obj, kTextGoal);
  add("OBJ double", "double.obj", mesh, MeshFormat::obj, kTextGoal);
  add("OFF short", "short.off", brief, MeshFormat::off);
  add("STL binary", "binary.stl", mesh, MeshFormat::stl);
  add("STL ascii", "ascii.stl", brief, MeshFormat::stl_ascii);
  add("3DS", "knot.3ds", mesh, MeshFormat::three_ds);
  add("GLB", "knot.glb", mesh, MeshFormat::glb);
  return all;
}

void read_once(FileUnderTest& file_under_test) {
  const double processor = now(CLOCK_PROCESS_CPUTIME_ID);
  const double wall = now(CLOCK_MONOTONIC);
  const Mesh mesh = read_mesh(file_under_test.file);
  file_under_test.processor.push_back(now(CLOCK_PROCESS_CPUTIME_ID) - processor);
  file_under_test.wall.push_back(now(CLOCK_MONOTONIC) - wall);
}

double kibibytes_at_most() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss);
}

/// The child's part: prints its peak over what it had before, in units of the mesh's vectors.
int print_peak(const char* file) {
  const double before = kibibytes_at_most();
  const Mesh mesh = read_mesh(file);
  const double bytes = static_cast<double>(mesh.vertices.size() * sizeof(mesh.vertices[0]) +
                                           mesh.triangles.size() * sizeof(mesh.triangles[0]));
  std::printf("%.2f\n", (kibibytes_at_most() - before) * 1024 / bytes);
  return 0;
}

std::string peak_of(const std::string& program, const std::filesystem::path& file) {
  const std::string command = "'" + program + "' --peak '" + file.string() + "'";
  FILE* const out = popen(command.c_str(), "r");
  std::array<char, 32> text{};
  const bool read = out != nullptr && std::fgets(text.data(), text.size(), out) != nullptr;
  if (out == nullptr || pclose(out) != 0 || !read) {
    throw std::runtime_error("cannot run " + command);
  }
  const std::string line = text.data();
  return line.substr(0, line.find('\n'));
}

void print(const FileUnderTest& file_under_test, const std::string& peak) {
  const double size = 1e-6 * static_cast<double>(std::filesystem::file_size(file_under_test.file));
  const double rate = size / median(file_under_test.processor);
  std::printf("%-18s %8.1f %8.0f %8.0f %8.0f %6s  %s\n", file_under_test.name.c_str(), size,
              1e3 * median(file_under_test.processor), rate, size / median(file_under_test.wall),
              peak.c_str(),
              file_under_test.goal == 0      ? ""
              : rate >= file_under_test.goal ? "goal met"
                                             : "goal missed");
}

int run(const std::string& program, std::uint64_t triangles) {
  const Folder folder;
  std::vector<FileUnderTest> files_under_test = written(folder.path(), triangles);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = 0; i < files_under_test.size(); ++i) {
      read_once(files_under_test[(i + static_cast<std::size_t>(pass)) % files_under_test.size()]);
    }
  }
  std::printf("%llu triangles, median of %d; peak memory over the mesh's own\n",
              static_cast<unsigned long long>(triangles), kPasses);
  std::printf("%-18s %8s %8s %8s %8s %6s\n", "file", "MB", "ms (cpu)", "MB/s cpu", "MB/s", "peak");
  for (const FileUnderTest& file_under_test : files_under_test) {
    print(file_under_test, peak_of(program, file_under_test.file));
  }
  return 0;
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  try {
    if (argc == 3 && std::string_view(argv[1]) == "--peak") {
      return soms::bench::print_peak(argv[2]);
    }
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    return soms::bench::run(program, argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "read_bench: %s\n", error.what());
    return 3;
  }
}
