#include "soms/query/detail/engine/batch.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"

#include "tests/support/support.h"

#include <atomic>
#include <limits>
#include <string>

namespace soms::detail {
namespace {

using Row = std::vector<int>;

/// The rows of a column.
std::vector<Row> rows_of(const std::vector<std::uint64_t>& offsets,
                         const std::vector<int>& values) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    rows.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(offsets[k]),
                      values.begin() + static_cast<std::ptrdiff_t>(offsets[k + 1]));
  }
  return rows;
}

TEST(Batch, AsksForEachPoseOnceWithMemoriesThatAreNotShared) {
  struct Memory {
    std::atomic<bool> in_use = false;
    std::vector<double> seen;
  };

  const Shape shape(generate_sphere(80));
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < 3 * kPosesOfBlock + 7; ++i) {
    poses.push_back(Pose::translation(static_cast<double>(i), 0, 0));
  }
  for (const int threads : {1, 4}) {
    std::atomic<int> memories = 0;
    std::vector<double> column(poses.size(), -1);
    std::vector<int> calls(poses.size());
    for_each_pose(
        poses, shape, {.threads = threads},
        [&] {
          ++memories;
          return Memory();
        },
        [&](Memory& memory, const Pose& pose, std::size_t i) {
          EXPECT_FALSE(memory.in_use.exchange(true));
          memory.seen.push_back(pose.m[3]);
          column[i] = memory.seen.back();
          ++calls[i];
          memory.in_use = false;
        });
    EXPECT_LE(memories, threads);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      ASSERT_EQ(column[i], static_cast<double>(i));
      ASSERT_EQ(calls[i], 1);
    }
  }
}

TEST(Batch, AsksNothingWhereAPoseIsAtFault) {
  const Shape shape(generate_sphere(80));
  std::vector<Pose> poses(kPosesOfBlock + 3);
  poses[kPosesOfBlock + 1].m[7] = std::numeric_limits<double>::infinity();
  try {
    for_each_pose(
        poses, shape, {}, [] { return 0; }, [](int, const Pose&, std::size_t) { FAIL(); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_finite);
    EXPECT_TRUE(error.place().starts_with("pose 257: ")) << error.place();
  }
}

TEST(Batch, AppendsRowsOfAnyLength) {
  std::vector<std::uint64_t> offsets{0};
  std::vector<int> values;
  append_rows(offsets, values, {0, 2, 2}, {1, 2});
  append_rows(offsets, values, {0}, {});
  append_rows(offsets, values, {0, 1}, {3});
  EXPECT_EQ(rows_of(offsets, values), (std::vector<Row>{{1, 2}, {}, {3}}));
}

TEST(RowWriter, WritesRowsThatComeInAnyOrder) {
  std::vector<std::uint64_t> offsets;
  std::vector<int> values;
  RowWriter<int> writer;  // used again and again
  test::for_each_case("row_writer/orders", 200, [&](Rng& rng) {
    const std::size_t count = rng.below(6);
    std::vector<Row> rows(count);
    std::vector<std::size_t> order(count);
    for (std::size_t k = 0; k < count; ++k) {
      rows[k].resize(rng.below(4));
      for (int& value : rows[k]) {
        value = static_cast<int>(rng.below(1000));
      }
      order[k] = k;
      std::swap(order[k], order[rng.below(k + 1)]);
    }
    writer.begin(count, offsets, values);
    for (const std::size_t k : order) {
      if (!rows[k].empty() || rng.below(2) == 0) {
        writer.add(k, rows[k]);
      }
    }
    writer.finish();
    ASSERT_EQ(offsets.size(), count + 1);
    ASSERT_EQ(offsets.back(), values.size());
    ASSERT_EQ(rows_of(offsets, values), rows);
  });
}

}  // namespace
}  // namespace soms::detail
