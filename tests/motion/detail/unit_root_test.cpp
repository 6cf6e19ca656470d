// Roots of polynomials in whole numbers, and the signs of others there.
#include "soms/motion/detail/exact/unit_root.h"

#include "soms/motion/detail/exact/exact_quotient.h"
#include "soms/motion/detail/exact/first_moment.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace soms::detail {
namespace {

/// below s - above, whose root is above / below.
IntegerPolynomial root_at(std::int64_t above, std::int64_t below) {
  return IntegerPolynomial({Integer(-above), Integer(below)});
}

/// s^2 - 1 / 2^shift, a bit above: its root is no fraction where the shift is odd.
IntegerPolynomial square_less(std::size_t shift) {
  return IntegerPolynomial({Integer(-1), Integer(), Integer(1, shift)});
}

/// A number of up to `words` words of any sign, but not 0.
Integer any_integer(Rng& rng, std::uint64_t words) {
  Integer number(1);
  for (std::uint64_t k = rng.below(words) + 1; k > 0; --k) {
    number = number * Integer(static_cast<std::int64_t>(rng.below(1ULL << 62) + 1), rng.below(90));
  }
  return rng.below(2) == 0 ? number : -number;
}

IntegerPolynomial any_polynomial(Rng& rng, std::size_t degree) {
  std::vector<Integer> coefficients;
  for (std::size_t k = 0; k <= degree; ++k) {
    coefficients.push_back(any_integer(rng, 3));
  }
  return IntegerPolynomial(std::move(coefficients));
}

TEST(ExactQuotient, UndoesProducts) {
  test::for_each_case("quotient", 2000, [](Rng& rng) {
    const Integer a = any_integer(rng, 40);
    const Integer b = any_integer(rng, 40);
    ASSERT_EQ(exact_quotient(a * b, b), a);
    ASSERT_EQ(exact_quotient(a, a), Integer(1));
    ASSERT_EQ(exact_quotient(Integer(), b), Integer());
  });
}

TEST(IntegerPolynomial, CommonDivisorsHaveTheCommonRoots) {
  test::for_each_case("common divisor", 300, [](Rng& rng) {
    const IntegerPolynomial shared = any_polynomial(rng, rng.below(4));
    const IntegerPolynomial p = shared * any_polynomial(rng, rng.below(4));
    const IntegerPolynomial q = shared * any_polynomial(rng, rng.below(4));
    const IntegerPolynomial found = common_divisor(p, q);
    ASSERT_EQ(found.degree(), shared.degree());
    // A multiple of the shared factor.
    const Integer& to = found.coefficients().back();
    const Integer& from = shared.coefficients().back();
    ASSERT_TRUE((found * from - shared * to).is_zero());
  });
  EXPECT_EQ(common_divisor(root_at(1, 3), IntegerPolynomial()).degree(), 1U);
  EXPECT_EQ(common_divisor(IntegerPolynomial(), root_at(1, 3)).degree(), 1U);
}

TEST(UnitRoot, MultipleRootsAreOnceInOrder) {
  const IntegerPolynomial third = root_at(1, 3);
  const IntegerPolynomial p = third * third * root_at(2, 3) * square_less(1) * square_less(1) *
                              root_at(0, 1) * root_at(1, 1) * root_at(3, 2) * root_at(1, 2);
  std::vector<UnitRoot> roots = unit_roots(p);
  ASSERT_EQ(roots.size(), 6U);
  const std::vector<std::pair<std::int64_t, std::int64_t>> known{{0, 1}, {1, 3}, {1, 2},
                                                                 {2, 3}, {0, 0}, {1, 1}};
  for (std::size_t k = 0; k < known.size(); ++k) {
    const auto [above, below] = known[k];
    if (below != 0) {
      EXPECT_EQ(roots[k].compare(Integer(above), Integer(below)), std::strong_ordering::equal) << k;
      EXPECT_EQ(roots[k].sign_of(root_at(above, below)), 0) << k;
    }
    EXPECT_EQ(roots[k].sign_of(p), 0) << k;
    EXPECT_EQ(roots[k].sign_of(root_at(1, 3)), k < 1 ? -1 : k == 1 ? 0 : 1) << k;
  }
  EXPECT_EQ(roots[4].sign_of(square_less(1)), 0);
  EXPECT_EQ(roots[4].compare(Integer(7), Integer(10)), std::strong_ordering::greater);
  EXPECT_EQ(roots[4].compare(Integer(71), Integer(100)), std::strong_ordering::less);
}

// Nearer to each other than cells are halved before divisors are looked for.
TEST(UnitRoot, RootsThatAreNextToEachOtherArePartedAndCompared) {
  constexpr std::int64_t kLarge = std::int64_t{1} << 60;
  const IntegerPolynomial p = root_at(kLarge / 3, kLarge) * root_at(1, 3);
  std::vector<UnitRoot> roots = unit_roots(p);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_EQ(roots[0].compare(Integer(1), Integer(3)), std::strong_ordering::less);
  EXPECT_EQ(roots[1].compare(Integer(1), Integer(3)), std::strong_ordering::equal);
  // Two that have thousands of digits in common.
  const IntegerPolynomial beside({Integer(1) - Integer(3, 6000), Integer(9, 6000)});
  EXPECT_EQ(unit_roots(beside * root_at(1, 3)).size(), 2U);
  UnitRoot root = unit_roots(square_less(1)).at(0);
  EXPECT_EQ(root.sign_of(square_less(1) * Integer(kLarge) + IntegerPolynomial({Integer(1)})), 1);
  EXPECT_EQ(root.sign_of(square_less(1) * Integer(kLarge) - IntegerPolynomial({Integer(1)})), -1);
  EXPECT_EQ(root.sign_of(square_less(1) * root_at(5, 7)), 0);
}

TEST(UnitRoot, NothingOutsideIsFound) {
  EXPECT_TRUE(unit_roots(root_at(4, 3)).empty());
  EXPECT_TRUE(unit_roots(root_at(-1, 3)).empty());
  EXPECT_TRUE(unit_roots(IntegerPolynomial({Integer(1), Integer(-3), Integer(3)})).empty());
  EXPECT_TRUE(unit_roots(IntegerPolynomial({Integer(5)})).empty());
}

TEST(FirstMoments, ConditionsThatHoldInIntervalsBeginAtARoot) {
  const IntegerPolynomial late = root_at(1, 3);
  const IntegerPolynomial later = root_at(2, 5);
  const auto first = [](const MomentConditions& conditions) {
    std::vector<UnitRoot> moments = first_moments(conditions);
    EXPECT_EQ(moments.size(), 1U);
    return moments.at(0);
  };
  const MomentConditions both{{IntegerPolynomial()}, {late, later}, std::nullopt};
  EXPECT_EQ(first(both).compare(Integer(2), Integer(5)), std::strong_ordering::equal);
  const MomentConditions always{{}, {late * late}, std::nullopt};
  EXPECT_EQ(first(always).compare(Integer(0), Integer(1)), std::strong_ordering::equal);
  const MomentConditions at_a_root{{late * later}, {late * Integer(-1)}, std::nullopt};
  EXPECT_EQ(first(at_a_root).compare(Integer(1), Integer(3)), std::strong_ordering::equal);
  EXPECT_TRUE(first_moments({{late, later}, {}, std::nullopt}).empty());
  EXPECT_TRUE(first_moments({{late}, {}, late * later}).empty());
}

}  // namespace
}  // namespace soms::detail
