#include "apps/view/window/scene_subject.h"

#include "apps/cli/text.h"
#include "apps/view/scene/draw_scene.h"
#include "apps/view/scene/load.h"
#include "apps/view/scene/orientation_menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace soms::view {

namespace {

/// Levels that can be requested before a tree is built and its depth is known.
constexpr int kLevelsUnknown = 32;
/// Half the angle, in radians, within which a contact is picked: some five pixels.
constexpr double kContactAngle = 0.008;
/// Contacts of a picked triangle that are explained.
constexpr std::size_t kExplained = 3;

double greatest_side(const Box& box) {
  if (box.empty()) {
    return 1;
  }
  const Vec3 extent = box.extent();
  return std::max({extent.x, extent.y, extent.z});
}

std::vector<bool> motions_of(const SceneContent& content) {
  std::vector<bool> moves;
  for (const MovingBody& mover : content.movers) {
    moves.push_back(mover.motion || content.recording);
  }
  return moves;
}

std::string in_words(const Vec3& v) {
  return fmt::format("{:.9g}, {:.9g}, {:.9g}", v.x, v.y, v.z);
}

std::string body_in_words(const ViewScene& scene, BodyRef ref) {
  const std::string& name = scene.body(ref).name;
  return ref.role == Role::city ? name : fmt::format("{} (mover {})", name, ref.index);
}

void add_corners(const Triangle& corners, PickedFacts& facts) {
  facts.numbers.emplace_back("a", in_words(corners.a));
  facts.numbers.emplace_back("b", in_words(corners.b));
  facts.numbers.emplace_back("c", in_words(corners.c));
}

std::vector<std::string> reasons(const ViewScene& scene, const Picked& picked) {
  if (picked.touches.empty()) {
    return {"It touches nothing."};
  }
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < std::min(kExplained, picked.touches.size()); ++k) {
    const Touch& touch = picked.touches[k];
    const bool first = touch.a == picked.body && touch.i == picked.triangle;
    const BodyRef other = first ? touch.b : touch.a;
    sentences.push_back(fmt::format("With triangle {} of {}: {}",
                                    scene.numbers().triangle(other, first ? touch.j : touch.i),
                                    body_in_words(scene, other), scene.explain(touch).text));
  }
  if (picked.touches.size() > kExplained) {
    sentences.push_back(
        fmt::format("It also touches {} more.", picked.touches.size() - kExplained));
  }
  return sentences;
}

}  // namespace

TreeChoice trees_of(const ViewState& state) {
  TreeChoice trees;
  trees.build = state.tree;
  trees.build.rule = state.rule;
  trees.build = without_idle(trees.build);  // each rule has the options that it uses
  trees.traversal.traversal = state.traversal;
  trees.traversal.prune = state.prune;
  trees.traversal.descent = descent_of(state);
  trees.traversal = without_idle(trees.traversal);  // E-Node's descent stays beside no other
  return trees;
}

ViewOptions options_of(const ViewState& state) {
  const Shown& shown = state.shown;
  ViewOptions options;
  options.movers = shown.movers;
  options.city_style = shown.edges ? SurfaceStyle::both : SurfaceStyle::solid;
  options.mover_style = options.city_style;
  options.trees = trees_of(state);
  if (shown.visited || shown.pruned || shown.found) {
    options.trace = TraceBoxes{shown.visited, shown.pruned, shown.found};
  }
  options.contacts.glow = shown.contact_triangles;
  options.contacts.markers = shown.contact_triangles;
  options.contacts.parts = shown.contact_parts;
  options.contacts.segments = shown.crossing_segments;
  options.contacts.lines = shown.contact_lines;
  options.contacts.on_top = shown.contacts_on_top;
  options.gap = shown.gap;
  options.frame_gaps.shown = shown.gap;
  return options;
}

SceneSubject::SceneSubject(SceneContent content, const Limits& limits)
    : has_motion_(motions_of(content)),
      limits_(limits),
      finder_(content, limits),
      scene_(std::move(content), limits),
      place_(dense_place(scene_)) {
  if (place_) {
    scene_.add_notes({"of places far apart, the one that holds most is seen; Enter shows all"});
  }
  list_events();
}

void SceneSubject::set_gap_patience(GapStore::Patience patience) {
  scene_.set_gap_patience(patience);
}

void SceneSubject::set_step_patience(std::chrono::steady_clock::duration patience) {
  counter_.set_patience(patience);
}

std::optional<std::uint32_t> SceneSubject::object() const {
  const auto pair = scene_.pair();
  return pair ? std::optional(pair->second.index) : std::nullopt;
}

std::optional<BodyRef> SceneSubject::tree_body(TreeOf tree) const {
  if (const auto pair = scene_.pair()) {
    return tree == TreeOf::city ? pair->first : pair->second;
  }
  if (scene_.city_parts() > 0) {
    return city_part(0);
  }
  return scene_.movers() > 0 ? std::optional(mover(0)) : std::nullopt;
}

const SceneStatistics& SceneSubject::statistics() const {
  if (!statistics_) {
    statistics_ = scene_.statistics();
  }
  return *statistics_;
}

int SceneSubject::levels_of(TreeOf tree) const {
  if (single_levels_ && !scene_.pair()) {
    return *single_levels_;
  }
  const auto& known = tree == TreeOf::city ? statistics().tree_a : statistics().tree_b;
  return known ? static_cast<int>(known->depth) + 1 : kLevelsUnknown;
}

bool SceneSubject::moves() const {
  if (scene_.frames()) {
    return true;
  }
  for (std::uint32_t k = 0; k < scene_.movers(); ++k) {
    if (has_motion_[k] && !scene_.held(k)) {
      return true;
    }
  }
  return false;
}

ViewLimits SceneSubject::limits() const {
  ViewLimits limits;
  limits.city_levels = levels_of(TreeOf::city);
  limits.mover_levels = levels_of(TreeOf::mover);
  limits.frames = scene_.frames().value_or(0);
  limits.movers = scene_.movers();
  limits.moves = moves();
  limits.can_seek = true;
  limits.scene_size = greatest_side(scene_.bounds());
  if (const auto held = object()) {
    limits.has_object = true;
    limits.object_size = greatest_side(scene_.body(mover(*held)).shape.bounds());
  }
  return limits;
}

void SceneSubject::choose(const ViewState& state) {
  changed();
  single_levels_.reset();
  through_ = state.shown.contacts_on_top;
  movers_shown_ = state.shown.movers;
  scene_.set_trees(trees_of(state));
  if (state.orientation_test != test_) {
    start_test(state.orientation_test);
  }
  prepare_lesson(state);
}

void SceneSubject::start_test(const std::optional<std::size_t>& row) {
  if (row) {
    if (const auto held = object()) {  // the way home leads out of the test
      home_.try_emplace(*held, scene_.body(mover(*held)).pose);
    }
    scene_.start_test(orientation_tests()[*row].name);
  } else {
    scene_.end_test();
  }
  test_ = row;
}

Facts SceneSubject::facts(const ViewState& state) const {
  const SceneStatistics& now = statistics();
  Facts facts;
  facts.name = scene_.title();
  for (const std::string& note : scene_.notes()) {
    facts.note += facts.note.empty() ? note : "; " + note;
  }
  for (const command::FrameWarning& warning : scene_.warnings()) {
    facts.note += (facts.note.empty() ? "warning: " : "; warning: ") + warning.place;
  }
  facts.triangles = now.triangles;
  facts.movers = scene_.movers();
  facts.frame = now.frame;
  facts.contacts = now.contacts;
  facts.bodies = now.touching_movers;
  if (now.clearance > 0) {
    facts.clearance = command::four_digits(now.clearance) + " m";
    facts.gaps = now.gaps;
    facts.least_gap = now.least_gap ? meters_in_text(*now.least_gap) : "";
  }
  add_costs(facts);
  facts.left_out = left_out_;
  facts.limits = limits();
  facts.orientation_test = test_;
  facts.bounds = scene_.bounds();
  facts.framed = place_ ? place_->box : Box{};
  if (state.shown.gap) {
    facts.gap = gap_facts();
  }
  if (const auto held = object()) {
    facts.object = scene_.body(mover(*held)).pose;
    facts.object_bounds = scene_.bounds(mover(*held));
    facts.bounds.grow(facts.object_bounds);
  }
  if (state.followed < scene_.movers()) {
    const BodyRef followed = mover(static_cast<std::uint32_t>(state.followed));
    facts.followed = scene_.body(followed).pose;
    facts.followed_bounds = scene_.bounds(followed);
  }
  if (state.learn) {
    facts.learn = lesson_facts_;
  }
  // Of a traversal that is not shown any more the counts are those of other poses.
  if (now.trace && (state.shown.visited || state.shown.pruned || state.shown.found)) {
    facts.traversed = true;
    facts.visited = now.trace->entered;
    facts.pruned = now.trace_pruned;
    facts.found = now.trace->leaf_pairs;
    facts.trace_cut = now.trace_cut;
  }
  return facts;
}

/// Of the scene's own query, or of the traversal that was chosen in its place.
void SceneSubject::add_costs(Facts& facts) const {
  const std::optional<CountedStep>& step = counter_.find(scene_, limits_);
  facts.cost = step ? step->cost : statistics().cost;
  facts.collision_ms = step ? step->milliseconds : statistics().step_milliseconds;
  if (step) {
    facts.entered = step->counts.entered;
    facts.cost_cut = step->cut;
  }
}

std::string SceneSubject::gap_in_text(const Gap& gap) const {
  return meters_ == 1 ? meters_in_text(gap) : length_in_text(gap);
}

std::optional<GapFacts> SceneSubject::gap_facts() const {
  const std::optional<Gap>& gap = scene_.gap();
  if (!gap) {
    return std::nullopt;
  }
  const auto side = [&](BodyRef body, TriangleId i) {
    return fmt::format("{} of {}", scene_.numbers().triangle(body, i), scene_.body(body).name);
  };
  const Distance& near = gap->distance;
  if (!gap->known()) {
    return GapFacts{.length = {},
                    .numbers = {{"Gap", fmt::format("at most {:.6g}{}", near.distance.upper,
                                                    meters_ == 1 ? " m" : "")}},
                    .surroundings = {}};
  }
  return GapFacts{
      .length = gap_in_text(*gap),
      .numbers = {{"Gap", fmt::format("{:.6g}{}", near.distance.lower, meters_ == 1 ? " m" : "")},
                  {"from triangle", side(gap->a, near.triangles->a)},
                  {"to triangle", side(gap->b, near.triangles->b)}},
      .surroundings =
          surroundings(*gap, scene_.bounds(gap->a), scene_.bounds(gap->b), scene_.bounds())};
}

void SceneSubject::advance(int count) {
  changed();
  leave_moment();
  const std::uint64_t now = scene_.frame();
  if (count < 0) {
    const auto back = static_cast<std::uint64_t>(-static_cast<std::int64_t>(count));
    scene_.go_to(now - std::min(now, back));
    return;
  }
  const std::uint64_t next = now + static_cast<std::uint64_t>(count);
  const auto end = scene_.frames();
  scene_.go_to(end && *end > 0 ? next % *end : next);
}

void SceneSubject::seek(std::uint64_t frame) {
  changed();
  leave_moment();
  scene_.go_to(frame);
}

void SceneSubject::restart() {
  seek(0);
}

void SceneSubject::place_object(const Pose& pose) {
  if (const auto held = object()) {
    home_.try_emplace(*held, scene_.body(mover(*held)).pose);
    std::erase(at_moment_, *held);
    changed();
    scene_.set_pose(*held, pose);
    if (!scene_.test()) {
      test_.reset();
    }
  }
}

void SceneSubject::object_home() {
  const auto held = object();
  const auto home = held ? home_.find(*held) : home_.end();
  if (home == home_.end()) {
    return;
  }
  changed();
  scene_.end_test();
  test_.reset();
  if (has_motion_[*held]) {
    scene_.release(*held);
    scene_.go_to(scene_.frame());
  } else {
    scene_.set_pose(*held, home->second);
  }
  home_.erase(home);
}

std::optional<PickedFacts> SceneSubject::pick(const Ray& ray) {
  const auto picked = scene_.pick(ray, movers_shown_);
  if (through_ || !picked) {
    if (const auto touch = scene_.pick_contact(ray, kContactAngle)) {
      seen_ = Chosen{touch->a, touch->i, touch};
      return contact_facts(*touch);
    }
  }
  if (!picked) {
    seen_.reset();
    return std::nullopt;
  }
  seen_ = Chosen{picked->body, picked->triangle,
                 picked->touches.empty() ? std::nullopt : std::optional(picked->touches.front())};
  return triangle_facts(*picked);
}

PickedFacts SceneSubject::triangle_facts(const Picked& picked) const {
  PickedFacts facts;
  facts.title =
      fmt::format("triangle {} of {}", scene_.numbers().triangle(picked.body, picked.triangle),
                  body_in_words(scene_, picked.body));
  if (!picked.part_name.empty()) {
    facts.numbers.emplace_back("part", picked.part_name);
  }
  facts.numbers.emplace_back("face", std::to_string(picked.face));
  facts.numbers.emplace_back("vertices", fmt::format("{}, {}, {}", picked.vertices[0],
                                                     picked.vertices[1], picked.vertices[2]));
  add_corners(picked.corners, facts);
  if (picked.distance > 0) {
    facts.numbers.emplace_back("point", in_words(picked.point));
    facts.numbers.emplace_back("distance", fmt::format("{:.6g}", picked.distance));
  }
  facts.numbers.emplace_back("touches", std::to_string(picked.touches.size()));
  facts.why = reasons(scene_, picked);
  facts.point = picked.point;
  facts.bounds = bounds(picked.corners);
  return facts;
}

PickedFacts SceneSubject::contact_facts(const Touch& touch) const {
  PickedFacts facts;
  facts.title =
      fmt::format("contact of triangle {} of {} and triangle {} of {}",
                  scene_.numbers().triangle(touch.a, touch.i), body_in_words(scene_, touch.a),
                  scene_.numbers().triangle(touch.b, touch.j), body_in_words(scene_, touch.b));
  const Explanation why = scene_.explain(touch);
  facts.numbers.emplace_back("kind", std::string(name(why.kind)));
  facts.numbers.emplace_back("decided by", std::string(name(why.stage)));
  facts.numbers.emplace_back("arithmetic", why.exact_arithmetic ? "exact" : "plain doubles");
  for (const Vec3& point : why.common.points()) {
    facts.numbers.emplace_back("common", in_words(point));
    facts.bounds.grow(point);
  }
  facts.why = {why.text};
  const Box triangle = bounds(scene_.triangle(touch.a, touch.i));
  facts.point = (facts.bounds.empty() ? triangle : facts.bounds).center();
  if (facts.bounds.empty() || facts.bounds.lower == facts.bounds.upper) {
    facts.bounds = triangle;  // a point has no size by which to go near it
  }
  return facts;
}

void SceneSubject::select() {
  selected_ = seen_;
  focus_.reset();
  const auto pair = scene_.pair();
  if (selected_ && pair && selected_->body.role == Role::mover && selected_->body != pair->second &&
      selected_->body != pair->first) {
    changed();
    scene_.set_pair(scene_.city_parts() > 0 ? city_part(0) : pair->first, selected_->body);
    scene_.end_test();
    test_.reset();
  }
}

std::optional<PickedFacts> SceneSubject::selection() const {
  if (!selected_) {
    return std::nullopt;
  }
  if (selected_->touch) {
    return touching(selected_->touch) ? std::optional(contact_facts(*selected_->touch))
                                      : std::nullopt;
  }
  return triangle_facts(scene_.picked(selected_->body, selected_->triangle));
}

void SceneSubject::deselect() {
  selected_.reset();
  focus_.reset();
}

void SceneSubject::open(const std::string& path) {
  auto [body, notes] = read_body(path, limits_);
  changed();
  scene_.add_notes(notes);
  place_.reset();
  finder_.add(body);
  list_events();
  const bool first = scene_.city_parts() == 0 && scene_.movers() == 0;
  if (first) {
    scene_.add_city(std::move(body));
    return;
  }
  const BodyRef added = scene_.add_mover({std::move(body), {}});
  has_motion_.push_back(false);
  if (const auto pair = scene_.pair(); pair && pair->second != added) {
    scene_.set_pair(pair->first, added);
    test_.reset();
  }
}

bool SceneSubject::touching(const std::optional<Touch>& touch) const {
  const auto& all = scene_.contacts();
  return touch && std::binary_search(all.begin(), all.end(), *touch);
}

DrawList SceneSubject::draw_list(const ViewState& state) {
  ViewOptions options = options_of(state);
  options.in_meters = meters_ == 1;
  if (state.shown.tree_boxes) {
    if (const auto body = tree_body(state.tree_of)) {
      options.level = LevelBoxes{*body, state.level};
      if (!scene_.pair() && !single_levels_) {
        scene_.set_trees(options.trees);
        const TreeStatistics tree = soms::statistics(scene_.tree(*body), options.trees.build);
        single_levels_ = static_cast<int>(tree.depth) + 1;
      }
    }
  }
  if (selected_) {
    options.chosen = touching(selected_->touch) ? selected_->touch : std::nullopt;
    options.focus = options.chosen ? focus_ : std::nullopt;
    if (selected_->body.role == Role::mover && !options.focus) {
      options.highlighted = selected_->body;  // else what is around it is pale
    }
  }
  DrawnScene drawn = draw_scene(scene_, options);
  left_out_ = left_out(drawn.counts);
  DrawList& list = drawn.list;
  if (selected_) {
    const Triangle corners = scene_.triangle(selected_->body, selected_->triangle);
    for (const auto& [from, to] : {std::pair(corners.a, corners.b), std::pair(corners.b, corners.c),
                                   std::pair(corners.c, corners.a)}) {
      list.lines.push_back({from, to, palette::kBlack, 3, true});
    }
  }
  list.captions.meters = meters_;
  list.captions.north = meters_ > 0;
  prepare_lesson(state);
  add_lesson(list);
  changed();
  return std::move(list);
}

}  // namespace soms::view
