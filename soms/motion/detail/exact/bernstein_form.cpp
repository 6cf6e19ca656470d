#include "soms/motion/detail/exact/bernstein_form.h"

#include <cstdint>

namespace soms::detail {

// With a_j those of the powers, coefficient i is the sum of a_j (i over j) / (n over j). All are
// taken times n!, so that a_j has the factor j! (n - j)!.
BernsteinForm::BernsteinForm(const IntegerPolynomial& p) : at_(p.coefficients()) {
  const std::size_t n = p.degree();
  std::vector<std::int64_t> factorial{1};
  for (std::size_t k = 1; k <= n; ++k) {
    factorial.push_back(factorial.back() * static_cast<std::int64_t>(k));
  }
  for (std::size_t j = 0; j <= n; ++j) {
    at_[j] = at_[j] * Integer(factorial[j] * factorial[n - j]);
  }
  // Sums by Pascal's triangle.
  for (std::size_t round = 1; round <= n; ++round) {
    for (std::size_t i = n; i >= round; --i) {
      at_[i] = at_[i] + at_[i - 1];
    }
  }
}

int BernsteinForm::changes() const {
  int changes = 0;
  int before = 0;
  for (const Integer& c : at_) {
    if (c.sign() != 0) {
      changes += c.sign() == -before ? 1 : 0;
      before = c.sign();
    }
  }
  return changes;
}

int BernsteinForm::sign_inside() const {
  int seen = 0;
  for (const Integer& c : at_) {
    if (c.sign() != 0) {
      if (c.sign() == -seen) {
        return 0;
      }
      seen = c.sign();
    }
  }
  return seen;
}

// De Casteljau, with sums in place of means: the k-th sums are 2^k times too large.
BernsteinForm BernsteinForm::halve() {
  const std::size_t n = at_.size() - 1;
  BernsteinForm upper;
  upper.at_ = at_;
  for (std::size_t k = 0; k <= n; ++k) {
    at_[k] = upper.at_[0] << (n - k);
    for (std::size_t i = 0; i + k < n; ++i) {
      upper.at_[i] = upper.at_[i] + upper.at_[i + 1];
    }
    // The last sum of this round stays: it is control point n - k of the upper half.
    upper.at_[n - k] = upper.at_[n - k] << (n - k);
  }
  return upper;
}

}  // namespace soms::detail
