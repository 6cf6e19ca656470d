// What of `SceneSubject` concerns events.
#include "apps/view/scene/open_side.h"
#include "apps/view/window/scene_subject.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

/// Milliseconds of a search between two frames of the window.
constexpr double kSliceOfSearch = 50;
/// What surrounds a contact in its picture, in parts of the smaller body's diagonal.
constexpr double kSurroundings = 0.25;
/// How far the eye is that looks for a free side, likewise.
constexpr double kFarFromContact = 2.5;

double diagonal_of(const Box& box) {
  const Vec3 extent = box.extent();
  return std::sqrt(dot(extent, extent));
}

BodyRef ref_of(const SceneBody& body) {
  return body.kind == SceneBodyKind::mover ? mover(body.id) : city_part(body.id);
}

}  // namespace

void SceneSubject::list_events() {
  if (finder_.searched() < events_.searched) {
    events_.rows.clear();
    ++events_.edition;
  }
  events_.frames = finder_.frames();
  events_.searched = finder_.searched();
  for (std::size_t i = 0; i < finder_.spans().size(); ++i) {
    const ContactSpan& span = finder_.spans()[i];
    if (i == events_.rows.size()) {
      events_.rows.push_back({.title = finder_.title(span)});
    }
    ContactEvent& row = events_.rows[i];
    row.begin = span.begin;
    row.end = span.end;
    row.most_pairs = span.most_pairs;
    row.most_frame = span.most_step;
  }
}

void SceneSubject::search_events() {
  finder_.search(kSliceOfSearch);
  list_events();
}

void SceneSubject::let_go() {
  scene_.end_test();
  test_.reset();
  for (const auto& [number, pose] : home_) {
    if (!has_motion_[number]) {
      scene_.set_pose(number, pose);
    }
    scene_.release(number);
  }
  home_.clear();
}

Sight SceneSubject::show_event(std::size_t row) {
  const ContactSpan span = finder_.spans().at(row);
  changed();
  let_go();
  scene_.go_to(span.most_step);
  const BodyRef a = ref_of(span.a.body);
  const BodyRef b = ref_of(span.b.body);
  const Touch touch{a, b, span.pair.first, span.pair.second};
  seen_ = Chosen{a, span.pair.first, touch};
  selected_ = seen_;
  scene_.set_pair(b, a);
  const Box box_a = scene_.bounds(a);
  const Box box_b = scene_.bounds(b);
  const double size = std::min(diagonal_of(box_a), diagonal_of(box_b));
  const double margin = kSurroundings * size;
  Sight sight;
  sight.facts = contact_facts(touch);
  sight.surroundings = span.box;
  sight.surroundings.grow(span.place - Vec3{margin, margin, margin});
  sight.surroundings.grow(span.place + Vec3{margin, margin, margin});
  sight.toward_eye = open_side(scene_, span.place, 0.5 * margin, kFarFromContact * size);
  return sight;
}

}  // namespace soms::view
