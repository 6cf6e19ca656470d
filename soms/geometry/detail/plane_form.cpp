#include "soms/geometry/detail/plane_form.h"

namespace soms::detail {

int PlaneForm::sign(const PlanePoint& p) const {
  return (u * p.u + v * p.v + w * p.w).sign();
}

int PlaneForm::sign_beside(const PlanePoint& p) const {
  const int there = sign(p);
  return there != 0 ? there : u.sign() != 0 ? u.sign() : v.sign();
}

bool PlaneForm::is_zero() const {
  return u.sign() == 0 && v.sign() == 0 && w.sign() == 0;
}

}  // namespace soms::detail
