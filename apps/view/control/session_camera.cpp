// What of `Session` concerns the camera: requests, and following a mover.
#include "apps/view/control/session.h"

namespace soms::view {

namespace {

constexpr double kFollowDistance = 3;  ///< times what would fill the picture

Box usable(const Box& box) {
  return box.empty() ? Box{{-1, -1, -1}, {1, 1, 1}} : box;
}

}  // namespace

void Session::frame_again() {
  if (camera_ == first_) {
    const Box& box = facts_.framed.empty() ? facts_.bounds : facts_.framed;
    camera_ = first_ =
        seen_from(usable(box), Side::corner, window_, camera_.field_of_view, covered_);
  }
}

Camera Session::seen_whole(Side side) const {
  return seen_from(usable(facts_.bounds), side, window_, camera_.field_of_view, covered_);
}

Camera Session::fit(const Box& box) const {
  return fitted_beside(box, camera_.eye - camera_.target, window_, covered_, camera_.field_of_view);
}

void Session::do_camera_requests() {
  Requests& wishes = state_.requests;
  if (wishes.fit_all) {
    wishes.fit_all = false;
    go(seen_whole(Side::corner));
  }
  if (wishes.look_from) {
    go(seen_whole(*wishes.look_from));
    wishes.look_from.reset();
  }
  if (wishes.fit_gap) {
    wishes.fit_gap = false;
    if (facts_.gap && !facts_.gap->surroundings.empty()) {
      go(fit(facts_.gap->surroundings));
    } else {
      message_ = "there is no gap: it is not shown, not known, or the object touches something";
    }
  }
  if (wishes.fit_object) {
    wishes.fit_object = false;
    const Box box = picked_ ? picked_->bounds : facts_.object_bounds;
    if (!box.empty()) {
      go(dollied(fit(box), kFollowDistance));
    }
  }
}

void Session::start_following() {
  const Pose& pose = *facts_.followed;
  const Vec3 back{-pose.m[0], -pose.m[4], 0.5};
  const Camera near =
      fitted_beside(usable(facts_.followed_bounds), back, window_, covered_, camera_.field_of_view);
  camera_ = dollied(near, kFollowDistance);
  flight_.reset();
}

void Session::follow(const std::optional<Pose>& before) {
  const bool begins = state_.camera == CameraMode::follow &&
                      (mode_before_ != CameraMode::follow || followed_before_ != state_.followed);
  mode_before_ = state_.camera;
  followed_before_ = state_.followed;
  if (state_.camera != CameraMode::follow || !facts_.followed) {
    return;
  }
  if (begins) {
    start_following();
  } else if (before && *before != *facts_.followed) {
    camera_ = followed(camera_, *before, *facts_.followed);
  }
}

}  // namespace soms::view
