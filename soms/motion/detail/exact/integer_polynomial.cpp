#include "soms/motion/detail/exact/integer_polynomial.h"

#include "soms/motion/detail/exact/exact_quotient.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace soms::detail {

namespace {

Integer power_of(const Integer& base, std::size_t exponent) {
  Integer power(1);
  for (std::size_t k = 0; k < exponent; ++k) {
    power = power * base;
  }
  return power;
}

/// quotient * q + rest = p times a power of the leading coefficient of q.
struct PseudoDivision {
  IntegerPolynomial quotient;
  IntegerPolynomial rest;
};

/// The power is that of the difference of the degrees plus 1. \pre The degree of q is not above
/// that of p, and q is not 0.
PseudoDivision pseudo_divided(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  const std::vector<Integer>& by = q.coefficients();
  const Integer& lead = by.back();
  std::vector<Integer> rest = p.coefficients();
  std::vector<Integer> quotient(rest.size() - by.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    const std::size_t top = k + by.size() - 1;
    quotient[k] = std::move(rest[top]);
    for (std::size_t i = k + 1; i < quotient.size(); ++i) {
      quotient[i] = quotient[i] * lead;
    }
    for (std::size_t i = 0; i < top; ++i) {
      rest[i] = rest[i] * lead;
    }
    for (std::size_t i = k; i < top; ++i) {
      rest[i] = rest[i] - quotient[k] * by[i - k];
    }
  }
  rest.resize(by.size() - 1);
  return {IntegerPolynomial(std::move(quotient)), IntegerPolynomial(std::move(rest))};
}

IntegerPolynomial over(const IntegerPolynomial& p, const Integer& divisor) {
  std::vector<Integer> quotients;
  for (const Integer& c : p.coefficients()) {
    quotients.push_back(exact_quotient(c, divisor));
  }
  return IntegerPolynomial(std::move(quotients));
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(std::vector<Integer> coefficients)
    : at_(std::move(coefficients)) {
  while (!at_.empty() && at_.back().sign() == 0) {
    at_.pop_back();
  }
}

int IntegerPolynomial::sign_at(const Integer& above, const Integer& below) const {
  Integer sum;
  Integer power(1);
  for (std::size_t k = at_.size(); k-- > 0;) {
    sum = sum * above + at_[k] * power;
    power = power * below;
  }
  return sum.sign();
}

IntegerPolynomial IntegerPolynomial::derivative() const {
  std::vector<Integer> slopes;
  for (std::size_t k = 1; k < at_.size(); ++k) {
    slopes.push_back(at_[k] * Integer(static_cast<std::int64_t>(k)));
  }
  return IntegerPolynomial(std::move(slopes));
}

IntegerPolynomial operator+(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  std::vector<Integer> sums = p.at_.size() < q.at_.size() ? q.at_ : p.at_;
  for (std::size_t k = 0; k < std::min(p.at_.size(), q.at_.size()); ++k) {
    sums[k] = p.at_[k] + q.at_[k];
  }
  return IntegerPolynomial(std::move(sums));
}

IntegerPolynomial operator-(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  std::vector<Integer> differences = p.at_;
  differences.resize(std::max(p.at_.size(), q.at_.size()));
  for (std::size_t k = 0; k < q.at_.size(); ++k) {
    differences[k] = differences[k] - q.at_[k];
  }
  return IntegerPolynomial(std::move(differences));
}

IntegerPolynomial operator*(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  if (p.is_zero() || q.is_zero()) {
    return {};
  }
  std::vector<Integer> products(p.at_.size() + q.at_.size() - 1);
  for (std::size_t i = 0; i < p.at_.size(); ++i) {
    for (std::size_t j = 0; j < q.at_.size(); ++j) {
      products[i + j] = products[i + j] + p.at_[i] * q.at_[j];
    }
  }
  return IntegerPolynomial(std::move(products));
}

IntegerPolynomial operator*(const IntegerPolynomial& p, const Integer& s) {
  std::vector<Integer> products;
  for (const Integer& c : p.at_) {
    products.push_back(c * s);
  }
  return IntegerPolynomial(std::move(products));
}

PolynomialVec operator+(const PolynomialVec& a, const PolynomialVec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

PolynomialVec operator-(const PolynomialVec& a, const PolynomialVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

PolynomialVec operator*(const IntegerVec& v, const IntegerPolynomial& p) {
  return {p * v.x, p * v.y, p * v.z};
}

IntegerPolynomial dot(const PolynomialVec& a, const IntegerVec& b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

IntegerPolynomial dot(const PolynomialVec& a, const PolynomialVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PolynomialVec cross(const PolynomialVec& a, const IntegerVec& b) {
  return {a[1] * b.z - a[2] * b.y, a[2] * b.x - a[0] * b.z, a[0] * b.y - a[1] * b.x};
}

IntegerPolynomial common_divisor(IntegerPolynomial p, IntegerPolynomial q) {
  if (p.degree() < q.degree() || p.is_zero()) {
    std::swap(p, q);
  }
  if (q.is_zero()) {
    return p;
  }
  Integer lead(1);
  Integer height(1);
  for (;;) {
    const std::size_t fall = p.degree() - q.degree();
    IntegerPolynomial rest = pseudo_divided(p, q).rest;
    if (rest.is_zero()) {
      return q;
    }
    if (rest.degree() == 0) {
      return rest;
    }
    p = std::move(q);
    q = over(rest, lead * power_of(height, fall));
    lead = p.coefficients().back();
    if (fall > 0) {
      height = exact_quotient(power_of(lead, fall), power_of(height, fall - 1));
    }
  }
}

IntegerPolynomial with_single_roots(const IntegerPolynomial& p) {
  if (p.degree() == 0) {
    return p;
  }
  return pseudo_divided(p, common_divisor(p, p.derivative())).quotient;
}

}  // namespace soms::detail
