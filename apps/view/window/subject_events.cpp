// What of `SceneSubject` concerns events.
#include "soms/scene/passages.h"

#include "apps/view/sight/aim.h"
#include "apps/view/window/scene_subject.h"

#include <fmt/format.h>

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
  for (std::size_t i = 0; i < finder_.events().size(); ++i) {
    const FoundEvent& found = finder_.events()[i];
    if (found.is_passage) {
      if (i == events_.rows.size()) {
        const FoundPassage& passage = finder_.passages()[found.index];
        events_.rows.push_back({.title = finder_.title(passage),
                                .begin = passage.before,
                                .end = passage.before,
                                .most_pairs = 1,
                                .most_frame = passage.before,
                                .after = moment_of(passage.t)});
      }
      continue;
    }
    const ContactSpan& span = finder_.spans()[found.index];
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

/// Movers that stand between two frames go on along their motions with the next frame.
void SceneSubject::leave_moment() {
  for (const std::uint32_t number : at_moment_) {
    scene_.release(number);
  }
  at_moment_.clear();
}

Sight SceneSubject::show_event(std::size_t row, const FitCamera& fit) {
  const FoundEvent& found = finder_.events().at(row);
  changed();
  let_go();
  leave_moment();
  if (found.is_passage) {
    return show_passage(finder_.passages()[found.index], fit);
  }
  const ContactSpan span = finder_.spans()[found.index];
  scene_.go_to(span.most_step);
  return aimed_at({ref_of(span.a.body), ref_of(span.b.body), span.pair.a, span.pair.b}, span.b.part,
                  fit);
}

void SceneSubject::place_at_moment(BodyRef body, const Pose& before, const FoundPassage& passage) {
  if (body.role == Role::mover) {
    const Body& now = scene_.body(body);
    const RigidMotion way = way_of_step(now.shape, before, now.pose);
    scene_.set_pose(body.index, way.pose_at(moment_of(passage.t)));
    at_moment_.push_back(body.index);
  }
}

/// All movers are where they are in the frame in which the way ends, but for the two: they stand
/// where the law puts them at the moment.
Sight SceneSubject::show_passage(const FoundPassage& passage, const FitCamera& fit) {
  const BodyRef a = ref_of(passage.a.body);
  const BodyRef b = ref_of(passage.b.body);
  scene_.go_to(passage.before);
  const Pose from_a = scene_.body(a).pose;
  const Pose from_b = scene_.body(b).pose;
  scene_.go_to(passage.before + 1);
  place_at_moment(a, from_a, passage);
  place_at_moment(b, from_b, passage);
  Sight sight = aimed_at({a, b, passage.pair.a, passage.pair.b}, passage.b.part, fit);
  sight.facts.title = finder_.title(passage);
  sight.facts.numbers.insert(
      sight.facts.numbers.begin(),
      {"moment", fmt::format("frame {} + {:.9g}", passage.before, moment_of(passage.t))});
  return sight;
}

/// Chooses a contact, or what stands for one, and looks at all that the two share.
Sight SceneSubject::aimed_at(const Touch& touch, std::uint32_t part, const FitCamera& fit) {
  seen_ = Chosen{touch.a, touch.i, touch};
  selected_ = seen_;
  scene_.set_pair(touch.b, touch.a);
  std::vector<Touch> touches;
  const PartsOf parts(scene_.body(touch.b).shape.mesh());
  for (const Touch& other : scene_.contacts()) {
    if (other.a == touch.a && other.b == touch.b &&
        (part == Part::kNoParent || parts(other.j) == part)) {
      touches.push_back(other);
    }
  }
  if (touches.empty()) {
    touches.push_back(touch);  // next to rounding
  }
  PartBoxes part_boxes(scene_);
  const Aim aim = aim_at_touches(scene_, touch.a, touches, part_boxes);
  const AimedCamera aimed = aimed_camera(scene_, {&aim, 1}, {.may_cut = true}, fit, limits_);
  focus_ = aimed.around;
  return {contact_facts(touch), aimed.camera};
}

}  // namespace soms::view
