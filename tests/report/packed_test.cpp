#include "apps/report/packed.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace soms::report {
namespace {

/// The bytes that are put.
std::vector<std::uint8_t> packed(const std::function<void(Base64Writer&)>& put) {
  std::ostringstream text;
  Base64Writer data(text);
  put(data);
  data.finish();
  return test::bytes_of(text.str());
}

/// What bytes mean, read by the words of packed.h.
std::vector<std::int64_t> signed_numbers(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::int64_t> numbers;
  std::uint64_t value = 0;
  unsigned shift = 0;
  for (const std::uint8_t byte : bytes) {
    value |= std::uint64_t{byte & 0x7fU} << shift;
    shift += 7;
    if (byte < 0x80U) {
      const auto half = static_cast<std::int64_t>(value / 2);
      numbers.push_back(value % 2 == 0 ? half : -half - 1);
      value = 0;
      shift = 0;
    }
  }
  EXPECT_EQ(shift, 0U) << "cut off";
  return numbers;
}

TEST(Packed, NumbersTakeSevenBitsAByte) {
  const auto bytes = [](std::uint64_t value) {
    return packed([value](Base64Writer& data) { put_unsigned(data, value); });
  };
  EXPECT_EQ(bytes(0), (std::vector<std::uint8_t>{0}));
  EXPECT_EQ(bytes(127), (std::vector<std::uint8_t>{127}));
  EXPECT_EQ(bytes(128), (std::vector<std::uint8_t>{128, 1}));
  EXPECT_EQ(bytes(300), (std::vector<std::uint8_t>{172, 2}));
  EXPECT_EQ(bytes(std::numeric_limits<std::uint64_t>::max()).size(), 10U);
}

TEST(Packed, SignedNumbersComeBack) {
  std::vector<std::int64_t> numbers{std::numeric_limits<std::int64_t>::min(),
                                    std::numeric_limits<std::int64_t>::max()};
  for (std::int64_t value = -300; value <= 300; ++value) {
    numbers.push_back(value);
  }
  const auto bytes = packed([&](Base64Writer& data) {
    for (const std::int64_t value : numbers) {
      put_signed(data, value);
    }
  });
  EXPECT_EQ(signed_numbers(bytes), numbers);
  const auto few = packed([](Base64Writer& data) {
    for (const std::int64_t value : {0, -1, 1, -2, 2}) {
      put_signed(data, value);
    }
  });
  EXPECT_EQ(few, (std::vector<std::uint8_t>{0, 1, 2, 3, 4}));
}

TEST(Packed, AStepIsThePowerOfTwoThatGivesAlmostAllBits) {
  for (const double size : {1e-9, 0.3, 1.0, 1.5, 2.0, 4096.0, 1e12}) {
    const double step = step_of(size, 16);
    int exponent = 0;
    EXPECT_EQ(std::frexp(step, &exponent), 0.5) << size;
    EXPECT_LE(size / step, 65536) << size;
    EXPECT_GT(size / step, 32768) << size;
  }
  EXPECT_EQ(step_of(0, 16), 1);
}

TEST(Packed, AMeshNamesAVertexOnceAndThenByItsAge) {
  DrawnMesh mesh;
  mesh.vertices = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, -1, 0.5};  // the first one has no triangle
  mesh.indices = {1, 2, 3, 3, 2, 1};
  const auto numbers = packed([&](Base64Writer& data) { put_mesh(data, mesh, 0.5); });
  // New ones as 0 and the difference to the one before in halves; then 1, 2 and 3 vertices ago.
  EXPECT_EQ(numbers, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 4, 0, 0, 0, 3, 3, 2, 1, 2, 3}));
}

TEST(Packed, PointsAndLinesAreDifferencesThatDoNotDrift) {
  std::vector<Vec3> points;
  std::vector<std::array<Vec3, 2>> lines;
  const Vec3 place{100, -50, 7};
  for (int k = 0; k < 200; ++k) {
    const Vec3 at{0.37 * k, -0.11 * k * k, std::sin(k)};
    points.push_back(at);
    lines.push_back({place + at, place + at + Vec3{0.4, -0.3, 0.26}});
  }
  constexpr double kStep = 0.25;
  const auto near = [](double value, double steps) {
    EXPECT_NEAR(value, steps * kStep, 0.5 * kStep + 1e-9);
  };
  const auto of_points =
      signed_numbers(packed([&](Base64Writer& data) { put_points(data, points, kStep); }));
  ASSERT_EQ(of_points.size(), 3 * points.size());
  std::array<std::int64_t, 3> now{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      now[axis] += of_points[3 * k + axis];
      near(points[k][axis], static_cast<double>(now[axis]));
    }
  }
  const auto of_lines =
      signed_numbers(packed([&](Base64Writer& data) { put_lines(data, lines, place, kStep); }));
  ASSERT_EQ(of_lines.size(), 6 * lines.size());
  now = {};
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      now[axis] += of_lines[6 * k + axis];
      near(lines[k][0][axis] - place[axis], static_cast<double>(now[axis]));
      const std::int64_t end = now[axis] + of_lines[6 * k + 3 + axis];
      near(lines[k][1][axis] - place[axis], static_cast<double>(end));
    }
  }
}

TEST(Packed, EvenMotionTakesAByteANumberAndTurningsDoNotJump) {
  const auto numbers = signed_numbers(packed([](Base64Writer& data) {
    PackedPath path(data, 0.5);
    for (int k = 0; k < 50; ++k) {
      const double angle = 0.01 * k;
      const double sign = k % 2 == 0 ? 1 : -1;  // the same turning either way
      path.put({3.0 * k, -2.0 * k, 1}, {sign * std::cos(angle), 0, 0, sign * std::sin(angle)});
    }
  }));
  ASSERT_EQ(numbers.size(), 7U * 50);
  std::array<std::int64_t, 7> now{};
  std::array<std::int64_t, 7> change{};
  for (int k = 0; k < 50; ++k) {
    for (std::size_t n = 0; n < 7; ++n) {
      const std::int64_t number = numbers[7 * static_cast<std::size_t>(k) + n];
      if (k > 1) {
        EXPECT_LE(std::abs(number), 63) << "more than a byte in step " << k;
      }
      const std::int64_t by = number + change[n];
      now[n] += by;
      change[n] = k == 0 ? 0 : by;
    }
    EXPECT_EQ(now[0], 6 * k);
    EXPECT_EQ(now[1], -4 * k);
    EXPECT_EQ(now[2], 2);
    EXPECT_NEAR(static_cast<double>(now[3]) / kTurns, std::cos(0.01 * k), 1 / kTurns);
    EXPECT_NEAR(static_cast<double>(now[6]) / kTurns, std::sin(0.01 * k), 1 / kTurns);
  }
}

}  // namespace
}  // namespace soms::report
