// What of `SceneSubject` concerns events.
#include "apps/view/scene/aim.h"
#include "apps/view/window/scene_subject.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

/// Milliseconds of a search between two frames of the window.
constexpr double kSliceOfSearch = 50;

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

Sight SceneSubject::show_event(std::size_t row, const FitCamera& fit) {
  const ContactSpan span = finder_.spans().at(row);
  changed();
  let_go();
  scene_.go_to(span.most_step);
  const BodyRef a = ref_of(span.a.body);
  const BodyRef b = ref_of(span.b.body);
  const Touch touch{a, b, span.pair.a, span.pair.b};
  seen_ = Chosen{a, span.pair.a, touch};
  selected_ = seen_;
  scene_.set_pair(b, a);
  std::vector<Touch> touches;
  const PartsOf parts(scene_.body(b).shape.mesh());
  for (const Touch& other : scene_.contacts()) {
    if (other.a == a && other.b == b &&
        (span.b.part == Part::kNoParent || parts(other.j) == span.b.part)) {
      touches.push_back(other);
    }
  }
  PartBoxes part_boxes(scene_);
  const Aim aim = aim_at_touches(scene_, a, touches, part_boxes);
  const AimedCamera aimed = aimed_camera(scene_, {&aim, 1}, {.may_cut = true}, fit, limits_);
  focus_ = aimed.around;
  return {contact_facts(touch), aimed.camera};
}

}  // namespace soms::view
