#include "soms/motion/detail/exact/unit_root.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

/// Cells are halved this often before roots that do not part are taken for multiple ones, and
/// before a sign that does not show is taken for 0: both are then decided by a common divisor.
constexpr std::size_t kPatience = 32;

/// The number of the upper of two halves, or of the point between them.
Integer odd_above(const Integer& number) {
  return (number << 1) + Integer(1);
}

}  // namespace

/// Finds them by halving.
class UnitRoots {
 public:
  explicit UnitRoots(IntegerPolynomial p)
      : polynomial_(std::make_shared<const IntegerPolynomial>(std::move(p))) {}

  /// Nothing if roots are not parted within kPatience halvings, unless all are `single`.
  [[nodiscard]] std::optional<std::vector<UnitRoot>> find(bool single) {
    single_ = single;
    const UnitRoot whole(polynomial_, BernsteinForm(*polynomial_));
    if (whole.form_.first_sign() == 0) {
      add_known(whole, Integer(), 0);
    }
    if (!look_into(whole)) {
      return std::nullopt;
    }
    if (whole.form_.last_sign() == 0) {
      add_known(whole, Integer(1), 0);
    }
    return std::move(found_);
  }

 private:
  void add_known(UnitRoot cell, Integer number, std::size_t halvings) {
    cell.number_ = std::move(number);
    cell.halvings_ = halvings;
    cell.known_ = true;
    found_.push_back(std::move(cell));
  }

  /// Adds the roots inside of a cell; false if they do not part. No recursion: roots may be as near
  /// to each other as coefficients are long.
  [[nodiscard]] bool look_into(const UnitRoot& whole) {
    std::vector<UnitRoot> open{whole};
    while (!open.empty()) {
      UnitRoot cell = std::move(open.back());
      open.pop_back();
      const int changes = cell.form_.changes();
      const bool alone =
          changes == 1 && cell.form_.first_sign() != 0 && cell.form_.last_sign() != 0;
      if (cell.known_ || alone) {
        found_.push_back(std::move(cell));
        continue;
      }
      if (changes != 0 && !single_ && cell.halvings_ == kPatience) {
        return false;
      }
      if (changes != 0) {
        push_halves(std::move(cell), open);
      }
    }
    return true;
  }

  /// The upper one, what is between them if that is a root, and on top the lower one.
  static void push_halves(UnitRoot cell, std::vector<UnitRoot>& open) {
    UnitRoot upper = cell;
    upper.form_ = cell.form_.halve();
    upper.number_ = odd_above(cell.number_);
    cell.number_ = cell.number_ << 1;
    upper.halvings_ = ++cell.halvings_;
    open.push_back(upper);
    if (upper.form_.first_sign() == 0) {
      upper.known_ = true;
      open.push_back(std::move(upper));
    }
    open.push_back(std::move(cell));
  }

  std::shared_ptr<const IntegerPolynomial> polynomial_;
  bool single_ = false;
  std::vector<UnitRoot> found_;
};

std::vector<UnitRoot> unit_roots(const IntegerPolynomial& p) {
  if (auto found = UnitRoots(p).find(false)) {
    return std::move(*found);
  }
  return UnitRoots(with_single_roots(p)).find(true).value();
}

std::strong_ordering UnitRoot::compare(const Integer& above, const Integer& below) const {
  const Integer scaled = above << halvings_;
  const std::strong_ordering to_lower = number_ * below <=> scaled;
  if (known_ || to_lower >= 0) {
    return known_ || to_lower > 0 ? to_lower : std::strong_ordering::greater;
  }
  if ((number_ + Integer(1)) * below <= scaled) {
    return std::strong_ordering::less;
  }
  const int sign = polynomial_->sign_at(above, below);
  return sign == 0                    ? std::strong_ordering::equal
         : sign == form_.first_sign() ? std::strong_ordering::greater
                                      : std::strong_ordering::less;
}

/// What divides both has no other root in the cell, and is not 0 at its ends.
bool UnitRoot::is_root_of(const IntegerPolynomial& p) const {
  const IntegerPolynomial divisor = common_divisor(*polynomial_, p);
  return divisor.degree() > 0 &&
         divisor.sign_at(number_, scale()) == -divisor.sign_at(number_ + Integer(1), scale());
}

BernsteinForm UnitRoot::form_here(const IntegerPolynomial& p) const {
  BernsteinForm form(p);
  for (std::size_t bit = halvings_; bit-- > 0;) {
    const bool upper = (number_.word(bit / 64) >> bit % 64 & 1U) != 0;
    BernsteinForm other = form.halve();
    if (upper) {
      form = std::move(other);
    }
  }
  return form;
}

/// Takes the half that holds the root, and that of another polynomial's form.
void UnitRoot::halve(BernsteinForm& other) {
  BernsteinForm upper = form_.halve();
  BernsteinForm other_upper = other.halve();
  ++halvings_;
  if (form_.last_sign() == 0) {
    number_ = odd_above(number_);
    known_ = true;
  } else if (form_.last_sign() == form_.first_sign()) {
    number_ = odd_above(number_);
    form_ = std::move(upper);
    other = std::move(other_upper);
  } else {
    number_ = number_ << 1;
  }
}

int UnitRoot::sign_of(const IntegerPolynomial& p) {
  if (p.is_zero()) {
    return 0;
  }
  if (known_) {
    return p.sign_at(number_, scale());
  }
  BernsteinForm form = form_here(p);
  for (std::size_t halved = 0;; ++halved) {
    const int sign = form.sign_inside();
    if (sign != 0 || (halved == kPatience && is_root_of(p))) {
      return sign;
    }
    halve(form);
    if (known_) {
      return p.sign_at(number_, scale());
    }
  }
}

}  // namespace soms::detail
