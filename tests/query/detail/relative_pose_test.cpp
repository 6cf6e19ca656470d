#include "soms/query/detail/relative_pose.h"

#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"

#include "tests/query/margins/touch.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

using test::Needed;
using test::Touch;

/// Shares of what is granted that touches needed.
void expect_granted(const Needed& share) {
  EXPECT_LE(share.along_y, 1);
  EXPECT_LE(share.along_x, 1);
  EXPECT_LE(share.of_roots, 1);
}

TEST(RelativePose, GrantsWhatRandomTouchesNeed) {
  std::size_t touches = 0;
  std::size_t apart = 0;
  test::for_each_case("relative-pose/touch", 1500, [&](Rng& rng) {
    Touch touch = test::random_touch(rng, rng.below(2) == 0 ? 2 : std::exp2(rng.uniform(1, 60)));
    if (test::bring_together(touch)) {
      ++touches;
      const Needed share = test::needed(touch);
      expect_granted(share);
      apart += share.of_roots > 0 ? 1U : 0U;
    }
  });
  EXPECT_GT(touches, 500U);
  // Boxes that touch are often apart by their rounding.
  EXPECT_GT(apart, 200U);
}

/// The most that was found along the axes of y: 4.5 u64 V of 192.
Touch worst_along_y() {
  Touch touch;
  touch.pose_x.m = {0x1.fffe74cd9af0bp-1,     0x1.3d90204a1f5efp-8,    0x1.1fcc2c577c7ep-12,
                    -0x0.0000000000001p-1022, -0x1.3d904d1b13f26p-8,   0x1.fffe760aacbbfp-1,
                    0x1.3971935725f9dp-15,    0x0.0000000000005p-1022, -0x1.1f9ab4b54f9dep-12,
                    -0x1.4498b19600579p-15,   0x1.00000590fe98cp+0,    -0x0p+0};
  touch.pose_y.m = {0x1.b05dd57851439p-1,  -0x1.07f79c4951f07p-1, 0x1.294eae3d1ce45p-3,
                    -0x1.01714b2ee7d2ap+0, 0x1.8c88247e09b63p-2,  0x1.8cc405a5a729cp-1,
                    0x1.ff838afb4a40ep-2,  -0x1.fe59c56ab4398p-1, -0x1.7ae9c911ac03fp-2,
                    -0x1.766441c064429p-2, 0x1.b545f586e34a6p-1,  -0x1.ffeb3c4d0b3b9p-1};
  touch.x = {-0x1.0000000000017p+0, -0x1.fffffffffffffp-1, -0x1.fffffffffffe8p-1};
  touch.end_x = {0x1.fffffffd28d57p-1, 0x1.ffffffe4bb865p-1, 0x1.fffffffffffe6p-1};
  touch.y = {0x1.07e94caa82e33p-10, 0x1.dd98ceaca583cp-11, 0x1.07e94ee2b5d99p-10};
  touch.end_y = {-0x1.07e94caa81f58p-10, -0x1.dd98ceaca595ep-11, -0x1.07e94cab0e881p-10};
  return touch;
}

/// The most that was found along the axes of x: 4.6 u64 V of 384.
Touch worst_along_x() {
  Touch touch;
  touch.pose_x.m = {0x1.fffe76b9e8481p-1,    0x1.3c6374a157a35p-8,     -0x1.7ff0af0b3e951p-12,
                    0x0.0000000000014p-1022, -0x1.3c635df278fc9p-8,    0x1.fffe78f8f500ap-1,
                    0x1.00cbc8c2a41e1p-16,   -0x0.0000000000009p-1022, 0x1.8003647c997c5p-12,
                    -0x1.c645c269c817p-17,   0x1.fffffdbd61977p-1,     -0x0.0000000000012p-1022};
  touch.pose_y.m = {0x1.356525c9d88cdp-1, 0x1.674dae5845f19p-1,  0x1.825dbd3ff1cb8p-2,
                    0x1.00dce6a75664ap+0, 0x1.48f58e7e21615p-2,  -0x1.4bbfd5e7c5a48p-1,
                    0x1.61998cfe0c7dp-1,  0x1.fe1ea2d377a3fp-1,  0x1.7550fef9e67ebp-1,
                    -0x1.2f3b5fa5a97bp-2, -0x1.3be5db99fd8dcp-1, -0x1.09ceef8d0c1aap-1};
  touch.x = {0x1.0000000000f94p+0, 0x1.fffffffffffffp-1, -0x1.0a04253aa4245p-1};
  touch.end_x = {-0x1.000002a4480cbp+0, -0x1.00000008e1a84p+0, 0x1.0a042539f8beep-1};
  touch.y = {0x1.2bf4ae7838793p-11, 0x1.f88ebc1763e76p-10, -0x1.52729f8e41d56p-13};
  touch.end_y = {-0x1.2bf4ae78340ffp-11, -0x1.f88ebc1763e96p-10, 0x1.52729f91da8c7p-13};
  return touch;
}

/// The most that was found between roots: 4.8 u64 V of 384.
Touch worst_between_roots() {
  Touch touch;
  touch.pose_x.m = {0x1.fffef32d2e571p-1,     -0x1.32da19e27acaep-17,  -0x1.065513d32c551p-8,
                    -0x0.0000000000005p-1022, 0x1.3cc26df3c044fp-17,   0x1.00000132cd4c9p+0,
                    0x1.354f640d60ab8p-14,    0x0.0000000000001p-1022, 0x1.06550f40cdf57p-8,
                    -0x1.357755090849fp-14,   0x1.fffef2db14037p-1,    0x0.0000000000002p-1022};
  touch.pose_y.m = {-0x1.69c1c2bf4998dp-1, 0x1.56b3c0526382cp-1,  -0x1.d66c1fda57991p-3,
                    0x1.fe2b29195c39cp-1,  0x1.51b499e8fd415p-2,  0x1.32806c4d3e2ecp-1,
                    0x1.75c017f122594p-1,  0x1.0a0d5782e8ee4p+0,  0x1.4091b2cbfe421p-1,
                    0x1.c294c15f8ee97p-2,  -0x1.4994a9762db27p-1, 0x1.09eb18d0a4874p+0};
  touch.x = {0x1.ffffff97b18acp-1, 0x1.000000580dbafp+0, 0x1.fffffdd42e2ebp-1};
  touch.end_x = {-0x1.ffffffe8f15abp-1, -0x1.ffffffebd4302p-1, -0x1.ffffff8f9b56cp-1};
  touch.y = {-0x1.19e6eddbdcaa8p-5, -0x1.401b32c148c1cp-5, -0x1.8ecd5deebc148p-8};
  touch.end_y = {0x1.19e6ed7637de3p-5, 0x1.401b309153dbap-5, 0x1.8ecd5d393ed2bp-8};
  return touch;
}

TEST(RelativePose, GrantsWhatTheWorstTouchesNeed) {
  for (const Touch& touch : {worst_along_y(), worst_along_x(), worst_between_roots()}) {
    ASSERT_EQ(touch.pose_x.apply(touch.x), touch.pose_y.apply(touch.y));
    expect_granted(test::needed(touch));
  }
  EXPECT_GT(test::needed(worst_along_y()).along_y, 0.02);
  EXPECT_GT(test::needed(worst_along_x()).along_x, 0.011);
  EXPECT_GT(test::needed(worst_between_roots()).of_roots, 0.012);
}

/// The most that was found between roots where y is the larger body, in whose axes `overlap` sees
/// the other, and its residual is next to nothing: 3.3 u64 V of 384.
Touch worst_of_a_larger_reference() {
  Touch touch;
  touch.pose_x.m = {0x1.ffffef39081bbp-1,    0x0.0000000000042p-1022, 0x0.000000000008p-1022,
                    -0x1.7ff6139ed5652p+0,   0x0.000000000004bp-1022, 0x1.ffffef417973fp-1,
                    0x0.000000000006ep-1022, 0x1.3464ca9cf15d3p+0,    -0x0.000000000012ap-1022,
                    0x0.00000000000bdp-1022, 0x1.000008366c682p+0,    0x1.943d2d87c9366p-6};
  touch.pose_y.m = {0x1.04de939bfe5f9p-4,  -0x1.c054b90ebd88ep-1, 0x1.ea398f5a21a56p-2,
                    0x1.25d4bf0da151p-2,   -0x1.dcef31ad3c05fp-1, 0x1.eb62d7973ff3p-4,
                    0x1.5f9877acf8e3ap-2,  -0x1.2ffc9cee18b96p-3, -0x1.6eaf38b32061cp-2,
                    -0x1.df0b14efbf096p-2, -0x1.9db6bceab5db8p-1, 0x1.b9de25438134p-6};
  touch.x = {0x1.fff7610cc353ap-1, -0x1.fffecb2900a32p-1, -0x1.ffffaa48f9296p-1};
  touch.end_x = {-0x1.fff766b921ceap-1, 0x1.000006505067dp+0, 0x1.fffefe4e92cd3p-1};
  touch.y = {-0x1.49b22f2a5ef9ep-6, 0x1.33444006abbc3p+0, 0x1.1bde70da53301p-1};
  touch.end_y = {0x1.fad887d952c64p+0, -0x1.99765c6fba3d5p-1, 0x1.29c155352b40fp-1};
  return touch;
}

// With a 128th of the slack for rounding the roots count as apart.
TEST(RelativePose, KeepsRootsThatRoundingPartsMost) {
  const Touch touch = worst_of_a_larger_reference();
  ASSERT_EQ(touch.pose_x.apply(touch.x), touch.pose_y.apply(touch.y));
  const Shape x = test::shape_x(touch);
  const Shape y = test::shape_y(touch);
  const Body a(x, touch.pose_x);
  const Body b(y, touch.pose_y);
  ASSERT_TRUE(reference::overlap(x.mesh(), a.pose, y.mesh(), b.pose).any);
  EXPECT_TRUE(overlap(a, b).any);
  EXPECT_TRUE(overlap(b, a).any);
  const Needed share = test::needed(touch);
  expect_granted(share);
  EXPECT_GT(share.of_roots, 1 / 128.0);
}

// Products of such numbers are off by more than any share of them.
TEST(RelativePose, KeepsRootsThatTouchWhereProductsUnderflow) {
  std::size_t touches = 0;
  test::for_each_case("relative-pose/underflow", 500, [&](Rng& rng) {
    Touch touch = test::random_touch(rng, 0.5);
    const double scale = std::exp2(-rng.uniform(1055, 1068));
    for (Vec3* const v : {&touch.x, &touch.end_x, &touch.y, &touch.end_y}) {
      *v = *v * scale;
    }
    for (const std::size_t shift : {3U, 7U, 11U}) {
      touch.pose_x.m[shift] *= scale;
    }
    if (!test::bring_together(touch)) {
      return;
    }
    ++touches;
    const Body a(test::shape_x(touch), touch.pose_x);
    const Body b(test::shape_y(touch), touch.pose_y);
    ASSERT_TRUE(overlap(a, b).any);
    ASSERT_TRUE(overlap(b, a).any);
  });
  EXPECT_GT(touches, 400U);
}

/// A rotation next to the identity whose RtR - I is 1e-6 in every entry, or nearly.
Pose all_entries_off() {
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose.m[4 * i + j] += 0.4999e-6;
    }
  }
  check(pose);
  return pose;
}

double largest_off_identity(const detail::Matrix3& inverse, const detail::Matrix3& rotation) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += inverse[i][k] * rotation[k][j];
      }
      most = std::max(most, std::abs(sum));
    }
  }
  return most;
}

// The proof asks nothing of the inverse but its residual. R^T is as bad an inverse as poses allow;
// what is found with it needs an eighth of what the residual grants.
TEST(RelativePose, GrantsWhatABadInverseNeeds) {
  Touch touch;
  touch.pose_y = all_entries_off();
  touch.y = {1, 1, 1};
  touch.end_y = {-1, -1, -1};
  touch.end_x = {0x1p-10, 0x1p-10, 0x1p-10};
  touch.pose_x.m[3] = touch.pose_x.m[7] = touch.pose_x.m[11] = 1;
  ASSERT_TRUE(test::bring_together(touch));
  const Shape x = test::shape_x(touch);
  const Shape y = test::shape_y(touch);
  detail::ReferenceFrame frame(y.layout(), touch.pose_y);
  EXPECT_LT(frame.residual, 0x1p-50);
  const detail::Matrix3 rotation = detail::rotation(touch.pose_y);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      frame.inverse[i][j] = rotation[j][i];
    }
  }
  frame.residual = largest_off_identity(frame.inverse, rotation);
  EXPECT_GT(frame.residual, 0.99e-6);
  const Needed share = test::needed(touch, x, y, frame);
  expect_granted(share);
  EXPECT_GT(share.along_y, 1 / 16.0);
  EXPECT_FALSE(detail::RelativePose(x.layout(), touch.pose_x, frame).apart());
}

// What poses are off orthonormal is granted beside what floats need, not out of it: (N^T N - I) p
// is within the margin less 2.75 * 2^-17.
TEST(RelativePose, GrantsTheDefectBesideTheRoundingOfFloats) {
  const Shape body = test::shape_x(worst_of_a_larger_reference());
  double largest = 0;
  test::for_each_case("relative-pose/defect", 300, [&](Rng& rng) {
    Pose pose_x = test::awkward_rotation(rng);
    Pose pose_y = test::awkward_rotation(rng);
    if (rng.below(2) == 0) {
      pose_x = all_entries_off();
    }
    if (rng.below(2) == 0) {
      pose_y = all_entries_off().inverse();
    }
    detail::RelativePose relative(body.layout(), pose_x,
                                  detail::ReferenceFrame(body.layout(), pose_y));
    relative.prepare();
    const auto& column = relative.numbers().column;
    double defect = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const long double entry = static_cast<long double>(column[i][0]) * column[j][0] +
                                  static_cast<long double>(column[i][1]) * column[j][1] +
                                  static_cast<long double>(column[i][2]) * column[j][2];
        defect = std::max(defect, static_cast<double>(std::abs(entry - (i == j ? 1 : 0))));
      }
    }
    largest = std::max(largest, defect);
    // The most that p and d need: |d|_1 is up to 1.73 radii, and counts three times.
    ASSERT_GE(double{relative.numbers().relative}, 2.75 * 0x1p-17 + defect * (1 + 3 * 1.73));
  });
  EXPECT_GT(largest, 1.9e-6);
}

}  // namespace
}  // namespace soms
