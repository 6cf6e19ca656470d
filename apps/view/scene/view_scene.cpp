#include "apps/view/scene/view_scene.h"

#include "soms/base/error.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/length_unit.h"
#include "apps/view/scene/frame_report.h"
#include "apps/view/scene/orientation_menu.h"
#include "apps/view/scene/tree_store.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// A mover of the scene and who moves it.
struct Mover {
  MoverId id = 0;
  Motion motion;
  bool held = false;
};

/// An orientation test that runs.
struct RunningTest {
  std::string_view name;
  std::uint32_t mover = 0;
  std::vector<Pose> poses;
};

/// What a traversal depends on.
struct TraceKey {
  std::pair<BodyRef, BodyRef> pair;
  Pose pose_a;
  Pose pose_b;

  [[nodiscard]] bool operator==(const TraceKey&) const = default;
};

}  // namespace

struct ViewScene::State {
  std::string title;
  double unit = 0;  ///< of lengths, in meters; 0: not known
  std::vector<std::string> notes;
  std::vector<command::FrameWarning> warnings;
  Georeference georeference;
  Limits limits;
  Scene scene;
  std::vector<EnvironmentId> city;
  std::vector<Mover> movers;
  Box city_bounds;
  std::uint64_t triangles = 0;

  std::uint64_t frame = 0;
  std::optional<RunningTest> test;
  std::shared_ptr<Replay> recording;
  std::optional<std::pair<BodyRef, BodyRef>> pair;

  StepReport report;
  bool replayed = false;  ///< the report is the recording's
  std::vector<Touch> touches;
  std::vector<Gap> frame_gaps;
  double step_milliseconds = 0;

  TreeChoice choice;
  TreeStore trees;
  std::uint64_t trees_version = 0;
  TraversalTrace trace;
  std::optional<TraceKey> trace_key;
  std::uint64_t trace_version = 0;
  MeshFactsStore facts;
  GapStore gaps;

  void add_city(Body body) {
    triangles += body.shape.mesh().triangles.size();
    city_bounds.grow(moved(body.pose, body.shape.bounds()));
    city.push_back(scene.add_environment(std::move(body)));
  }

  void add_mover(MovingBody mover) {
    triangles += mover.body.shape.mesh().triangles.size();
    if (mover.motion) {
      mover.body.pose = mover.motion(frame);
    }
    movers.push_back({scene.add_mover(std::move(mover.body)), std::move(mover.motion), false});
  }

  void choose_pair() {
    if (!pair && !movers.empty() && !city.empty()) {
      pair.emplace(city_part(0), mover(0));
    } else if (!pair && movers.size() > 1) {
      pair.emplace(mover(0), mover(1));
    }
  }

  [[nodiscard]] std::optional<std::uint64_t> frames() const {
    return test        ? std::optional<std::uint64_t>(test->poses.size())
           : recording ? std::optional(recording->frames())
                       : std::nullopt;
  }

  /// The bodies are those that were recorded, all where they were.
  [[nodiscard]] bool as_recorded() const {
    return recording != nullptr && frame < recording->frames() && !test &&
           city.size() == recording->head().environment.size() &&
           movers.size() == recording->head().movers.size() &&
           std::none_of(movers.begin(), movers.end(), [](const Mover& m) { return m.held; });
  }

  /// Brings movers to the present frame.
  void place_movers() {
    for (std::uint32_t k = 0; k < movers.size(); ++k) {
      const Pose* recorded = recorded_pose(recording.get(), frame, k);
      if (test && test->mover == k) {
        scene.set_pose(movers[k].id, test->poses[frame]);
      } else if (recorded != nullptr && !movers[k].held) {
        scene.set_pose(movers[k].id, *recorded);
      } else if (movers[k].motion && !movers[k].held) {
        scene.set_pose(movers[k].id, movers[k].motion(frame));
      }
    }
  }

  void find_contacts() {
    const bool recorded = as_recorded();
    report = recorded ? report_of(recording->frame(frame))
                      : scene.step({.clearance = clearance_of(recording.get())}, limits);
    replayed = recorded;
    touches = touches_of(report);
    frame_gaps = gaps_of(report);
  }

  void show_frame() {
    const auto begin = Clock::now();
    place_movers();
    find_contacts();
    step_milliseconds = milliseconds_since(begin);
  }

  [[nodiscard]] const Body& body(BodyRef ref) const {
    return ref.role == Role::city ? scene.environment(city[ref.index])
                                  : scene.mover(movers[ref.index].id);
  }

  void check_mover(std::uint32_t index) const {
    if (index >= movers.size()) {
      throw Error(ErrorKind::usage, "no mover " + std::to_string(index),
                  "there are " + std::to_string(movers.size()));
    }
  }

  void check_body(BodyRef ref) const {
    if (ref.role == Role::mover) {
      check_mover(ref.index);
    } else if (ref.index >= city.size()) {
      throw Error(ErrorKind::usage, "no city part " + std::to_string(ref.index),
                  "there are " + std::to_string(city.size()));
    }
  }
};

ViewScene::ViewScene(SceneContent content, const Limits& limits)
    : state_(std::make_unique<State>()), numbers_(std::move(content.numbers)) {
  State& s = *state_;
  s.title = std::move(content.title);
  s.notes = std::move(content.notes);
  s.warnings = std::move(content.warnings);
  s.georeference = std::move(content.georeference);
  s.limits.threads = limits.threads;
  s.limits.stop = limits.stop;
  s.unit = command::common_unit(content.city);
  for (Body& body : content.city) {
    s.add_city(std::move(body));
  }
  for (MovingBody& mover : content.movers) {
    s.add_mover(std::move(mover));
    if (s.movers.size() % 1024 == 0) {
      check_stop(limits);
    }
  }
  if (content.recording != nullptr && content.recording->frames() > 0) {
    s.recording = std::move(content.recording);
  }
  s.choose_pair();
  s.show_frame();
}

ViewScene::~ViewScene() = default;
ViewScene::ViewScene(ViewScene&&) noexcept = default;
ViewScene& ViewScene::operator=(ViewScene&&) noexcept = default;

const std::string& ViewScene::title() const {
  return state_->title;
}

double ViewScene::unit() const {
  return state_->unit;
}

const std::vector<std::string>& ViewScene::notes() const {
  return state_->notes;
}

const Georeference& ViewScene::georeference() const {
  return state_->georeference;
}

const std::vector<command::FrameWarning>& ViewScene::warnings() const {
  return state_->warnings;
}

std::uint32_t ViewScene::city_parts() const {
  return static_cast<std::uint32_t>(state_->city.size());
}

std::uint32_t ViewScene::movers() const {
  return static_cast<std::uint32_t>(state_->movers.size());
}

const Body& ViewScene::body(BodyRef body) const {
  return state_->body(body);
}

Box ViewScene::bounds(BodyRef ref) const {
  const Body& b = body(ref);
  return moved(b.pose, b.shape.bounds());
}

Box ViewScene::bounds() const {
  Box box = state_->city_bounds;
  if (box.empty()) {
    for (std::uint32_t k = 0; k < movers(); ++k) {
      box.grow(bounds(mover(k)));
    }
  }
  return box;
}

void ViewScene::add_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (std::find(state_->notes.begin(), state_->notes.end(), note) == state_->notes.end()) {
      state_->notes.push_back(note);
    }
  }
}

BodyRef ViewScene::add_city(Body body) {
  state_->add_city(std::move(body));
  state_->choose_pair();
  state_->show_frame();
  return city_part(city_parts() - 1);
}

BodyRef ViewScene::add_mover(MovingBody mover_body) {
  state_->add_mover(std::move(mover_body));
  state_->choose_pair();
  state_->show_frame();
  return mover(movers() - 1);
}

std::uint64_t ViewScene::frame() const {
  return state_->frame;
}

std::optional<std::uint64_t> ViewScene::frames() const {
  return state_->frames();
}

void ViewScene::step() {
  const auto last = frames();
  go_to(last && state_->frame + 1 >= *last ? 0 : state_->frame + 1);
}

void ViewScene::go_to(std::uint64_t frame) {
  const auto count = frames();
  const std::uint64_t before =
      std::exchange(state_->frame, count ? std::min(frame, *count - 1) : frame);
  try {
    state_->show_frame();
  } catch (...) {
    state_->frame = before;  // a recording that is no longer whole still shows this one
    throw;
  }
}

bool ViewScene::replaying() const {
  return state_->replayed && state_->as_recorded();
}

void ViewScene::set_pose(std::uint32_t mover, const Pose& pose) {
  State& s = *state_;
  s.check_mover(mover);
  const auto begin = Clock::now();
  s.scene.set_pose(s.movers[mover].id, pose);
  hold(mover);
  s.find_contacts();
  s.step_milliseconds = milliseconds_since(begin);
}

void ViewScene::hold(std::uint32_t mover) {
  state_->check_mover(mover);
  state_->movers[mover].held = true;
  if (state_->test && state_->test->mover == mover) {
    state_->test.reset();
  }
}

void ViewScene::release(std::uint32_t mover) {
  state_->check_mover(mover);
  state_->movers[mover].held = false;
}

bool ViewScene::held(std::uint32_t mover) const {
  state_->check_mover(mover);
  return state_->movers[mover].held;
}

std::optional<std::pair<BodyRef, BodyRef>> ViewScene::pair() const {
  return state_->pair;
}

void ViewScene::set_pair(BodyRef a, BodyRef b) {
  state_->check_body(a);
  state_->check_body(b);
  if (b.role != Role::mover || a == b) {
    throw Error(ErrorKind::usage, "a pair needs a mover second, and two bodies",
                "name a mover that is not the first body");
  }
  end_test();
  state_->pair.emplace(a, b);
}

void ViewScene::start_test(std::string_view name, std::size_t up) {
  State& s = *state_;
  if (!s.pair) {
    throw Error(ErrorKind::usage, "an orientation test needs two bodies", "add a mover");
  }
  const auto [a, b] = *s.pair;
  if (bounds(a).empty() || bounds(b).empty()) {
    throw Error(ErrorKind::usage, "an orientation test of a model without triangles",
                "choose another pair");
  }
  const auto tests = orientation_tests();
  std::vector<Pose> poses = orientation_poses(name, bounds(a), body(b).shape.bounds(), up);
  const auto entry = std::find_if(tests.begin(), tests.end(),
                                  [name](const OrientationTest& t) { return t.name == name; });
  s.test.emplace(RunningTest{entry->name, b.index, std::move(poses)});
  s.movers[b.index].held = false;
  go_to(0);
}

void ViewScene::end_test() {
  if (state_->test) {
    hold(state_->test->mover);
  }
}

std::optional<std::string_view> ViewScene::test() const {
  return state_->test ? std::optional(state_->test->name) : std::nullopt;
}

const Scene& ViewScene::scene() const {
  return state_->scene;
}

const std::vector<Touch>& ViewScene::contacts() const {
  return state_->touches;
}

const std::vector<Gap>& ViewScene::frame_gaps() const {
  return state_->frame_gaps;
}

const std::optional<Gap>& ViewScene::gap() const {
  static const std::optional<Gap> kNone;
  const auto question = gap_question(state_->pair, city_parts(), movers(), state_->touches);
  return question ? state_->gaps.find(
                        *question, [this](BodyRef ref) -> const Body& { return state_->body(ref); },
                        state_->limits)
                  : kNone;
}

void ViewScene::set_gap_patience(GapStore::Patience patience) {
  state_->gaps.set_patience(patience);
}

std::uint64_t ViewScene::gap_queries() const {
  return state_->gaps.queries();
}

Triangle ViewScene::triangle(BodyRef ref, TriangleId i) const {
  const Body& b = body(ref);
  const Triangle t = b.shape.mesh().triangle(i);
  return {b.pose.apply(t.a), b.pose.apply(t.b), b.pose.apply(t.c)};
}

CommonPoints ViewScene::common_points(const Touch& touch) const {
  return soms::common_points(triangle(touch.a, touch.i), triangle(touch.b, touch.j));
}

Explanation ViewScene::explain(const Touch& pair) const {
  return view::explain(triangle(pair.a, pair.i), triangle(pair.b, pair.j));
}

void ViewScene::set_trees(const TreeChoice& choice) {
  check(choice.build);
  check(choice.traversal);
  State& s = *state_;
  if (s.choice.build != choice.build) {
    s.trees.clear();
    ++s.trees_version;
  }
  if (s.choice != choice) {
    s.trace_key.reset();
    s.trace = {};
  }
  s.choice = choice;
}

const TreeChoice& ViewScene::trees() const {
  return state_->choice;
}

std::uint64_t ViewScene::trees_version() const {
  return state_->trees_version;
}

const Tree& ViewScene::tree(BodyRef body) {
  State& s = *state_;
  s.check_body(body);
  return s.trees.tree(s.body(body).shape.shared_mesh(), s.choice.build, s.limits);
}

std::span<const Box> ViewScene::world_boxes(BodyRef body) {
  State& s = *state_;
  s.check_body(body);
  return s.trees.boxes(body, s.body(body), s.choice.build, s.choice.traversal.update, s.limits)
      .boxes();
}

const TraversalTrace& ViewScene::trace() {
  State& s = *state_;
  if (!s.pair || s.choice.traversal.traversal == Traversal::fast) {
    s.trace = {};
    return s.trace;
  }
  const auto [a, b] = *s.pair;
  const TraceKey key{*s.pair, body(a).pose, body(b).pose};
  if (s.trace_key == key) {
    return s.trace;
  }
  // Requested once before, since the second body's boxes may push out the first one's.
  (void)world_boxes(a);
  const std::span<const Box> boxes_b = world_boxes(b);
  const std::span<const Box> boxes_a = world_boxes(a);
  s.trace = watch({&tree(a), boxes_a}, {&tree(b), boxes_b}, s.choice.traversal, kMostWatchedTests,
                  s.limits);
  s.trace_key = key;
  ++s.trace_version;
  return s.trace;
}

std::uint64_t ViewScene::trace_version() const {
  return state_->trace_version;
}

MeshFactsStore& ViewScene::mesh_facts() {
  return state_->facts;
}

SceneStatistics ViewScene::statistics() const {
  const State& s = *state_;
  SceneStatistics out;
  out.bodies = s.city.size() + s.movers.size();
  out.triangles = s.triangles;
  out.frame = s.frame;
  out.contacts = s.touches.size();
  out.touching_movers = s.report.touching_movers().size();
  out.clearance = clearance_of(s.recording.get());
  out.gaps = s.frame_gaps.size();
  if (!s.frame_gaps.empty()) {
    out.least_gap = s.frame_gaps.front();
  }
  out.queries = s.report.queries;
  out.box_pairs = s.report.box_pairs;
  out.cost = s.report.cost;
  out.step_milliseconds = s.step_milliseconds;
  out.rule = entry(s.choice.build.rule).name;
  out.traversal = entry(s.choice.traversal.traversal).name;
  if (s.pair) {
    const auto tree_counts = [&](BodyRef ref) -> std::optional<TreeStatistics> {
      const TreeStatistics* counts = s.trees.statistics(*s.body(ref).shape.shared_mesh());
      return counts == nullptr ? std::nullopt : std::optional(*counts);
    };
    out.tree_a = tree_counts(s.pair->first);
    out.tree_b = tree_counts(s.pair->second);
  }
  if (s.trace_key) {
    out.trace = s.trace.counts;
    out.trace_pruned = s.trace.pruned;
    out.trace_milliseconds = s.trace.milliseconds;
    out.trace_cut = s.trace.cut;
  }
  return out;
}

}  // namespace soms::view
