#include "soms/motion/detail/exact/first_moment.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// The polynomial of the least degree that is not 0 throughout, or null.
const IntegerPolynomial* simplest_of(const std::vector<IntegerPolynomial>& polynomials) {
  const IntegerPolynomial* least = nullptr;
  for (const IntegerPolynomial& p : polynomials) {
    if (!p.is_zero() && (least == nullptr || p.degree() < least->degree())) {
      least = &p;
    }
  }
  return least;
}

bool all_hold(const MomentConditions& conditions, const IntegerPolynomial* known, UnitRoot& at) {
  if (conditions.nonzero && at.sign_of(*conditions.nonzero) == 0) {
    return false;
  }
  for (const IntegerPolynomial& p : conditions.not_negative) {
    if (&p != known && at.sign_of(p) < 0) {
      return false;
    }
  }
  for (const IntegerPolynomial& p : conditions.zero) {
    if (&p != known && at.sign_of(p) != 0) {
      return false;
    }
  }
  return true;
}

/// Adds the first root of `p` at which all hold.
void add_first(const MomentConditions& conditions, const IntegerPolynomial& p,
               std::vector<UnitRoot>& moments) {
  for (UnitRoot& root : unit_roots(p)) {
    if (all_hold(conditions, &p, root)) {
      moments.push_back(root);
      return;
    }
  }
}

}  // namespace

int sure_sign(const IntegerPolynomial& p) {
  if (p.is_zero()) {
    return 0;
  }
  const BernsteinForm form(p);
  const int sign = form.sign_inside();
  return form.first_sign() == sign && form.last_sign() == sign ? sign : 0;
}

std::vector<UnitRoot> first_moments(const MomentConditions& conditions) {
  std::vector<UnitRoot> moments;
  if (std::any_of(conditions.not_negative.begin(), conditions.not_negative.end(),
                  [](const IntegerPolynomial& p) { return sure_sign(p) < 0; })) {
    return moments;
  }
  if (const IntegerPolynomial* const p = simplest_of(conditions.zero)) {
    add_first(conditions, *p, moments);
    return moments;
  }
  // Of s itself, 0 is the root.
  add_first(conditions, IntegerPolynomial({Integer(), Integer(1)}), moments);
  if (moments.empty()) {
    for (const IntegerPolynomial& p : conditions.not_negative) {
      if (!p.is_zero()) {
        add_first(conditions, p, moments);
      }
    }
  }
  return moments;
}

}  // namespace soms::detail
