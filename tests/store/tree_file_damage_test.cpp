#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/within.h"
#include "soms/store/tree_file.h"
#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "tests/store/forged_file.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

using detail::Section;
using test::ForgedFile;
using test::tree_file_of;

const Shape& small_city(Layout layout) {
  static const Shape kWide(generate_city({.triangles = 2000, .size = 600}).mesh);
  static const Shape kCompact(generate_city({.triangles = 2000, .size = 600}).mesh,
                              {.layout = Layout::compact});
  return layout == Layout::wide ? kWide : kCompact;
}

/// The message of the error that opening throws; empty if it throws none.
std::string refused(const std::vector<std::byte>& bytes, TreeCheck check) {
  try {
    static_cast<void>(open_shape(bytes, "city.somst", {.check = check}));
    return {};
  } catch (const Error& error) {
    EXPECT_TRUE(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::unsupported ||
                error.kind() == ErrorKind::not_finite || error.kind() == ErrorKind::out_of_range)
        << error.what();
    EXPECT_EQ(std::string(error.what()).rfind("city.somst", 0) == std::string::npos &&
                  std::string(error.what()).find("triangle") == std::string::npos,
              false)
        << error.what();
    return error.what();
  }
}

/// One of each question, whose answers nobody looks at: they end, and touch no other memory.
void ask(const Shape& shape) {
  static const Shape kCar(generate_mover(MoverKind::car));
  const Body city(shape);
  for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{40, 30, 1}, Vec3{-90, 55, 4}}) {
    const Body car(kCar, Pose::about_z(0.3, at));
    static_cast<void>(overlap(car, city));
    static_cast<void>(distance(car, city));
    static_cast<void>(within(car, city, 2));
    static_cast<void>(closest(city, at));
    static_cast<void>(closest_hit(city, Ray{at, {0.1, 0.2, -1}}));
    static_cast<void>(all_hits(city, std::vector{Ray{at, {1, 0, 0}}}));
  }
  static_cast<void>(overlap(city, city, {.mode = OverlapMode::any}));
}

/// Refused by the check that should see it, and harmless where a lower one lets it pass.
void expect_refused(std::vector<std::byte> bytes, TreeCheck check, const std::string& what,
                    const std::string& place) {
  const std::string message = refused(bytes, check);
  EXPECT_NE(message.find(place), std::string::npos) << what << ": \"" << message << '"';
  if (check > TreeCheck::safe && refused(bytes, TreeCheck::safe).empty()) {
    ask(open_shape(bytes, "city.somst", {.check = TreeCheck::safe}));
  }
}

template <class T>
void expect_record_refused(Layout layout, TreeCheck check, Section section, std::size_t i,
                           const std::string& what, const std::function<void(T&)>& change) {
  ForgedFile file(small_city(layout));
  ASSERT_LT(i, file.count(section)) << what;
  T record = file.record<T>(section, i);
  change(record);
  file.set_record(section, i, record);
  expect_refused(file.bytes(), check, what, "");
  EXPECT_FALSE(refused(file.bytes(), check).empty()) << what;
}

TEST(DamagedTreeFile, EveryChangedBitIsFound) {
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const std::vector<std::byte> whole = tree_file_of(small_city(layout));
    const detail::TreeFileHead head = detail::read_head(whole, "whole");
    const auto expect_found = [&](std::size_t at) {
      std::vector<std::byte> bytes = whole;
      bytes[at] ^= std::byte{1} << (at % 8);
      EXPECT_FALSE(refused(bytes, TreeCheck::sound).empty()) << "byte " << at;
    };
    for (std::size_t at = 0; at < 1024; ++at) {
      expect_found(at);
    }
    for (std::size_t k = 0; k < detail::kSections; ++k) {
      const auto section = static_cast<Section>(k);
      const std::size_t size = head.of(section).count * detail::record_size(section);
      for (std::size_t at = 0; at < size; at += 1 + size / 20) {
        expect_found(head.of(section).offset + at);
      }
    }
  }
}

TEST(DamagedTreeFile, EveryTruncationIsFound) {
  const std::vector<std::byte> whole = tree_file_of(small_city(Layout::wide));
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "city.somst";
  for (std::size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 2048) {
    const std::vector<std::byte> bytes(whole.begin(),
                                       whole.begin() + static_cast<std::ptrdiff_t>(size));
    for (const TreeCheck check : {TreeCheck::trusted, TreeCheck::sound}) {
      EXPECT_FALSE(refused(bytes, check).empty()) << size;
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
      std::ofstream(path, std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(size));
      EXPECT_THROW(static_cast<void>(open_shape(path, {.check = check})), Error) << size;
    }
  }
  std::vector<std::byte> longer = whole;
  longer.resize(whole.size() + 4096);
  EXPECT_FALSE(refused(longer, TreeCheck::trusted).empty());
}

TEST(DamagedTreeFile, AnotherVersionSaysHowItIsBuiltAgain) {
  std::vector<std::byte> bytes = tree_file_of(small_city(Layout::wide));
  bytes[8] = std::byte{2};
  try {
    static_cast<void>(open_shape(bytes, "city.somst"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unsupported);
    EXPECT_NE(std::string(error.what()).find("build it again: soms build"), std::string::npos);
  }
}

TEST(DamagedTreeFile, WideRecordsOutOfRangeAreRefused) {
  const auto node = [](const std::string& what, std::size_t i,
                       const std::function<void(WideNode&)>& change) {
    expect_record_refused<WideNode>(Layout::wide, TreeCheck::safe, Section::nodes, i, what, change);
  };
  node("no child", 0, [](WideNode& n) { n.count = 0; });
  node("five children", 0, [](WideNode& n) { n.count = 5; });
  node("leaf beyond the count", 0, [](WideNode& n) { n.leaves = 0xff; });
  node("axes of a third kind", 0, [](WideNode& n) { n.oriented = 2; });
  node("itself", 1, [](WideNode& n) {
    n.leaves = 0;
    n.child[0] = 1;
  });
  node("its parent", 1, [](WideNode& n) {
    n.leaves = 0;
    n.child[0] = 0;
  });
  node("beyond the end", 0, [](WideNode& n) {
    n.leaves &= 0xe;
    n.child[0] = 1U << 27;
  });
  node("twice", 0, [](WideNode& n) {
    n.child[1] = n.child[0];
    n.leaves = 0;
  });
  node("leaf beyond the end", 0, [](WideNode& n) {
    n.leaves |= 1;
    n.child[0] = WideNode::kLeafBit | 0x0fffffff;
  });
  node("not finite", 3,
       [](WideNode& n) { n.center[1][0] = std::numeric_limits<float>::infinity(); });
  node("not a number", 3,
       [](WideNode& n) { n.half[1][0] = std::numeric_limits<float>::quiet_NaN(); });
  node("origin not finite", 3,
       [](WideNode& n) { n.origin[2] = std::numeric_limits<double>::infinity(); });
  const auto block = [](const std::string& what,
                        const std::function<void(TriangleBlock&)>& change) {
    expect_record_refused<TriangleBlock>(Layout::wide, TreeCheck::safe, Section::blocks, 5, what,
                                         change);
  };
  block("no triangle", [](TriangleBlock& b) { b.count = 0; });
  block("nine triangles", [](TriangleBlock& b) { b.count = 9; });
  block("triangle beyond the end", [](TriangleBlock& b) { b.id[2] = 5000; });
  block("a run that does not end", [](TriangleBlock& b) { b.following = 0x0fffffff; });
  block("not finite",
        [](TriangleBlock& b) { b.corner[8][7] = std::numeric_limits<float>::infinity(); });
  for (const auto section : {Section::least_ids, Section::list_nodes, Section::list_ends}) {
    expect_record_refused<std::uint32_t>(Layout::wide, TreeCheck::safe, section, 3, name(section),
                                         [](std::uint32_t& x) { x = 0x7fffffff; });
  }
  expect_record_refused<std::array<std::uint32_t, 3>>(Layout::wide, TreeCheck::safe,
                                                      Section::triangles, 7, "corner",
                                                      [](auto& t) { t[1] = 0x7fffffff; });
  expect_record_refused<Vec3>(Layout::wide, TreeCheck::safe, Section::vertices, 7, "vertex",
                              [](Vec3& v) { v.y = std::numeric_limits<double>::quiet_NaN(); });
}

TEST(DamagedTreeFile, CompactRecordsOutOfRangeAreRefused) {
  const auto node = [](const std::string& what, std::size_t i,
                       const std::function<void(CompactNode&)>& change) {
    expect_record_refused<CompactNode>(Layout::compact, TreeCheck::safe, Section::compact_nodes, i,
                                       what, change);
  };
  node("no child", 0, [](CompactNode& n) { n.count = 0; });
  node("itself", 1, [](CompactNode& n) {
    n.leaves = 0;
    n.child[0] = 1;
  });
  node("a huge step", 1, [](CompactNode& n) { n.step[0] = 0x1p125F; });
  node("leaf beyond the end", 0, [](CompactNode& n) {
    n.leaves |= 1;
    n.child[0] = WideNode::kLeafBit | 0x0fffffff;
  });
  expect_record_refused<std::uint32_t>(Layout::compact, TreeCheck::safe, Section::compact_ids, 1999,
                                       "no last",
                                       [](std::uint32_t& x) { x &= ~CompactParts::kLast; });
  expect_record_refused<std::uint32_t>(Layout::compact, TreeCheck::safe, Section::compact_ids, 3,
                                       "no triangle", [](std::uint32_t& x) { x |= 0x7fffffff; });
}

TEST(DamagedTreeFile, LeavesThatAreNotThoseOfTheMeshAreUnsound) {
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const Section ids = layout == Layout::wide ? Section::least_ids : Section::compact_ids;
    expect_record_refused<std::uint32_t>(layout, TreeCheck::sound, ids, 4, "another triangle",
                                         [](std::uint32_t& x) { x ^= 1; });
  }
  expect_record_refused<TriangleBlock>(Layout::wide, TreeCheck::sound, Section::blocks, 5,
                                       "a triangle twice", [](TriangleBlock& b) { b.id[0] ^= 1; });
}

TEST(DamagedTreeFile, BoxesTooSmallAreFoundByTheFullCheck) {
  ForgedFile file(small_city(Layout::wide));
  auto root = file.record<WideNode>(Section::nodes, 0);
  root.half[0] = {};
  file.set_record(Section::nodes, 0, root);
  EXPECT_EQ(refused(file.bytes(), TreeCheck::sound), "");
  EXPECT_NE(refused(file.bytes(), TreeCheck::full), "");
  ForgedFile compact(small_city(Layout::compact));
  auto node = compact.record<CompactNode>(Section::compact_nodes, 0);
  node.upper[0] = {};
  compact.set_record(Section::compact_nodes, 0, node);
  EXPECT_NE(refused(compact.bytes(), TreeCheck::full), "");
  ForgedFile low(small_city(Layout::wide));
  auto cell = low.record<layout::MinMaxGrid::Cell>(Section::cells, 2);
  cell.taken = 0;
  low.set_record(Section::cells, 2, cell);
  EXPECT_NE(refused(low.bytes(), TreeCheck::full), "");
}

TEST(DamagedTreeFile, HeadsThatLieAreRefused) {
  const auto expect_head = [](const std::string& what,
                              const std::function<void(detail::TreeFileHead&)>& change) {
    ForgedFile file(small_city(Layout::wide));
    change(file.head());
    EXPECT_NE(refused(file.bytes(), TreeCheck::safe), "") << what;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_head("bytes", [](auto& head) { head.bytes += 4096; });
  expect_head("many records",
              [](auto& head) { head.of(Section::nodes).count = std::uint64_t{1} << 62; });
  expect_head("overlapping sections", [](auto& head) { head.of(Section::blocks).offset -= 4096; });
  expect_head("fewer cells", [](auto& head) { head.of(Section::cells).count -= 1; });
  expect_head("fewer least ids", [](auto& head) { head.of(Section::least_ids).count -= 1; });
  expect_head("fewer lists", [](auto& head) { head.of(Section::list_ends).count -= 1; });
  expect_head("fewer vertices", [](auto& head) { head.of(Section::vertices).count -= 1; });
  expect_head("fewer statements", [](auto& head) { head.of(Section::statements).count -= 1; });
  expect_head("bounds", [&](auto& head) { head.bounds.lower.x = nan; });
  expect_head("empty bounds", [](auto& head) { head.bounds = {}; });
  expect_head("plan", [](auto& head) { head.plan.axis[1] = 3; });
  expect_head("plan twice", [](auto& head) { head.plan.axis[1] = head.plan.axis[0]; });
  expect_head("columns", [](auto& head) { head.plan.last[1] = 1e9; });
  expect_head("part of a column", [](auto& head) { head.plan.last[1] += 0.5; });
  expect_head("areas", [&](auto& head) { head.sah_area_ratio = nan; });
  expect_head("options", [](auto& head) { head.options.per_leaf = -3; });
  expect_head("rule", [](auto& head) { head.options.rule = static_cast<Rule>(77); });
}

/// Whatever the numbers are that no check refuses, queries end and touch no other memory.
TEST(DamagedTreeFile, WhatIsSafeIsSafeToAsk) {
  test::for_each_case("safe tree files", 300, [](Rng& rng) {
    const Layout layout = rng.below(2) == 0 ? Layout::wide : Layout::compact;
    ForgedFile file(small_city(layout));
    for (std::uint64_t k = 1 + rng.below(20); k > 0; --k) {
      const auto section = static_cast<Section>(rng.below(detail::kSections));
      const std::size_t words =
          file.count(section) * detail::record_size(section) / sizeof(std::uint32_t);
      if (words > 0 && section != Section::statements) {
        const std::size_t at = rng.below(words);
        const auto word = file.record<std::uint32_t>(section, at);
        file.set_record(section, at, word ^ (1U << rng.below(32)));
      }
    }
    const std::vector<std::byte> bytes = file.bytes();
    if (refused(bytes, TreeCheck::safe).empty()) {
      ask(open_shape(bytes, "city.somst", {.check = TreeCheck::safe}));
    }
  });
}

}  // namespace
}  // namespace soms
