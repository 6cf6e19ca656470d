// The parts of two disciplines of a generated building against each other: soms beside FCL and the
// way of ifcclash. One process, one thread, libraries in turn; processor time. soms decides what
// kind of clash each pair is and lists all of its triangle pairs; the others, and soms-touch, say
// which parts touch.
#include "soms/clash/clash.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/overlap.h"

#include "bench/clash/building.h"
#include "bench/clash/clash_peers.h"
#include "bench/measure.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <string_view>

namespace soms::bench {
namespace {

double processor_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The parts of both sets, as soms keeps them.
struct SomsParts {
  SomsParts(const Mesh& a, const Mesh& b) : first(part_bodies(a)), second(part_bodies(b)) {}

  std::vector<PartBody> first;
  std::vector<PartBody> second;
};

/// The whole list; what is inside another part without touching it is no pair here.
class SomsClash final : public ClashPeer {
 public:
  explicit SomsClash(const Building& building) : parts_(building.structure, building.services) {}

  void find(PartPairs& pairs) override {
    for (const Clash& clash : clashes(parts_.first, parts_.second).clashes) {
      if (clash.triangle_pairs > 0) {
        pairs.emplace_back(clash.a, clash.b);
      }
    }
  }

 private:
  SomsParts parts_;
};

/// What the others answer, and no more.
class SomsTouch final : public ClashPeer {
 public:
  explicit SomsTouch(const Building& building) : parts_(building.structure, building.services) {}

  void find(PartPairs& pairs) override {
    OverlapOptions options;
    options.mode = OverlapMode::any;
    for (const auto& [a, b] : clash_candidates(parts_.first, parts_.second)) {
      if (overlap(parts_.first[a].body, parts_.second[b].body, options).any) {
        pairs.emplace_back(a, b);
      }
    }
  }

 private:
  SomsParts parts_;
};

std::vector<FloatMesh> float_parts(const Mesh& mesh) {
  std::vector<FloatMesh> meshes;
  for (const Part& part : mesh.parts) {
    FloatMesh& made = meshes.emplace_back();
    // Each part's vertices follow each other, and only it uses them.
    std::uint32_t lowest = mesh.triangles[part.first][0];
    std::uint32_t highest = lowest;
    for (std::uint32_t t = part.first; t < part.first + part.count; ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        lowest = std::min(lowest, v);
        highest = std::max(highest, v);
      }
    }
    for (std::uint32_t v = lowest; v <= highest; ++v) {
      const Vec3& p = mesh.vertices[v];
      made.vertices.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    for (std::uint32_t t = part.first; t < part.first + part.count; ++t) {
      const auto& [x, y, z] = mesh.triangles[t];
      made.triangles.push_back({x - lowest, y - lowest, z - lowest});
    }
  }
  return meshes;
}

struct Row {
  std::string name;
  std::unique_ptr<ClashPeer> (*make)(const Building&) = nullptr;  ///< for soms
  ClashPeerMaker peer = {};                                       ///< for the others
  std::vector<double> prepare = {};
  std::vector<double> find = {};
  PartPairs pairs = {};
};

void run(Row& row, const Building& building, std::span<const FloatMesh> a,
         std::span<const FloatMesh> b) {
  const Loan loan{[](const Triangle& s, const Triangle& t) { return triangles_overlap(s, t); }};
  const double begin = processor_seconds();
  const std::unique_ptr<ClashPeer> prepared =
      row.make != nullptr ? row.make(building) : row.peer.make(a, b, loan);
  const double ready = processor_seconds();
  row.pairs.clear();
  prepared->find(row.pairs);
  row.find.push_back(processor_seconds() - ready);
  row.prepare.push_back(ready - begin);
  std::sort(row.pairs.begin(), row.pairs.end());
}

std::size_t lacking(const PartPairs& all, const PartPairs& some) {
  PartPairs lack;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(lack));
  return lack.size();
}

void print(const std::vector<Row>& rows) {
  std::puts("library,prepare ms,find ms,both ms,find / soms,both / soms,pairs,missing,wrong");
  const double find = median(rows.front().find);
  const double both = find + median(rows.front().prepare);
  for (const Row& row : rows) {
    const double finds = median(row.find);
    const double prepares = median(row.prepare);
    std::printf("%s,%.2f,%.2f,%.2f,%.2f,%.2f,%zu,%zu,%zu\n", row.name.c_str(), 1e3 * prepares,
                1e3 * finds, 1e3 * (prepares + finds), finds / find, (prepares + finds) / both,
                row.pairs.size(), lacking(rows.front().pairs, row.pairs),
                lacking(row.pairs, rows.front().pairs));
  }
}

void compare(std::uint64_t count, int passes, std::span<char* const> names) {
  const Building building = make_building(count, 7);
  const std::vector<FloatMesh> a = float_parts(building.structure);
  const std::vector<FloatMesh> b = float_parts(building.services);
  std::printf("# %zu x %zu parts, %zu x %zu triangles; median of %d\n", a.size(), b.size(),
              building.structure.triangles.size(), building.services.triangles.size(), passes);
  std::vector<Row> rows;
  rows.push_back({"soms", [](const Building& all) -> std::unique_ptr<ClashPeer> {
                    return std::make_unique<SomsClash>(all);
                  }});
  rows.push_back({"soms-touch", [](const Building& all) -> std::unique_ptr<ClashPeer> {
                    return std::make_unique<SomsTouch>(all);
                  }});
  std::vector<ClashPeerMaker> makers;
  soms_bench_clash_peers(makers);
  for (const ClashPeerMaker& maker : makers) {
    rows.push_back({maker.name, nullptr, maker});
  }
  std::erase_if(rows, [&](const Row& row) {
    return !names.empty() && std::find(names.begin(), names.end(), row.name) == names.end();
  });
  if (rows.empty()) {
    std::puts("no such library");
    return;
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      run(rows[(k + static_cast<std::size_t>(pass)) % rows.size()], building, a, b);
    }
  }
  print(rows);
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  std::uint64_t numbers[] = {10000, 5};
  for (int k = 1; k < std::min(argc, 3); ++k) {
    const std::string_view text = argv[k];
    const char* const end = text.data() + text.size();
    if (std::from_chars(text.data(), end, numbers[k - 1]).ptr != end || numbers[k - 1] < 1) {
      std::fputs("usage: clash_bench [PARTS [PASSES [LIBRARY...]]]\n", stderr);
      return 2;
    }
  }
  const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
  soms::bench::compare(numbers[0], static_cast<int>(numbers[1]),
                       words.subspan(std::min<std::size_t>(words.size(), 3)));
  return 0;
}
