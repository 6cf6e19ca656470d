#include "python/src/page_scene.h"

#include "python/src/poses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>

namespace soms::python {

namespace {

/// Pairs of triangles that are drawn of two bodies at a step, where there is one and where there
/// are many.
constexpr std::size_t kMostDrawn = 4000;
constexpr std::size_t kMostOfStep = 64;

/// A length as it is written beside a segment: for people, six digits.
std::string length_text(const Bracket& distance) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", distance.upper);
  return text.data();
}

std::string name_of(const Body& body, const std::string& otherwise) {
  return !body.name.empty() ? body.name : otherwise;
}

void check_triangle(const Body& body, TriangleId triangle) {
  if (triangle >= body.shape.mesh().triangles.size()) {
    throw usage("answer: it names a triangle that the bodies have not",
                "give the bodies that the answer is of");
  }
}

}  // namespace

PageScene::PageScene(const py::object& given, const py::object& poses) {
  if (py::isinstance<HeldScene>(given)) {
    add_scene(given.cast<HeldScene&>());
  } else if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    for (const py::handle& one : given) {
      const std::string number = std::to_string(bodies_.size());
      const std::string what = "bodies[" + number + "]";
      add_body(BodyArgument(one, what.c_str()).get(), "body " + number, bodies_.empty());
    }
  } else {
    add_body(BodyArgument(given, "given").get(), "body", false);
  }
  if (!poses.is_none()) {
    check_pair();
    poses_.emplace(poses_of(poses));
    for (const Pose& pose : poses_->get()) {
      check(pose);
    }
    steps_ = poses_->get().size();
    if (steps_ == 0) {
      throw usage("poses: there are none", "give at least one pose");
    }
  }
}

void PageScene::add_body(Body body, std::string name, bool moves) {
  names_.push_back(name_of(body, name));
  numbers_[{SceneBodyKind::mover, static_cast<std::uint32_t>(bodies_.size())}] =
      static_cast<std::uint32_t>(bodies_.size());
  bodies_.push_back(std::move(body));
  moves_.push_back(moves);
}

void PageScene::add_scene(HeldScene& held) {
  const SceneUse in_use(held);
  std::map<soms::SceneBody, std::uint32_t> numbers;
  const auto add = [&](SceneBodyKind kind, std::uint32_t id, const Body& body, const char* name) {
    numbers[{kind, id}] = static_cast<std::uint32_t>(bodies_.size());
    add_body(body, name + std::to_string(id), kind == SceneBodyKind::mover);
  };
  for (const EnvironmentId id : in_use.queried().environments()) {
    add(SceneBodyKind::environment, id, in_use.queried().environment(id), "part ");
  }
  for (const MoverId id : in_use.queried().movers()) {
    add(SceneBodyKind::mover, id, in_use.queried().mover(id), "mover ");
  }
  numbers_ = std::move(numbers);
}

void PageScene::check_pair() const {
  if (bodies_.size() != 2) {
    throw usage(std::to_string(bodies_.size()) + " bodies with an answer or poses of two",
                "give the two bodies that the answer is of: [a, b]");
  }
}

void PageScene::check_steps(std::size_t entries) const {
  if (!poses_ || entries != steps_) {
    throw usage("answer: " + std::to_string(entries) + " entries for " +
                    (poses_ ? std::to_string(steps_) + " poses" : std::string("no poses")),
                "give the poses that the answer is of");
  }
}

Pose PageScene::pose_of_body(std::size_t body, std::size_t step) const {
  return poses_ && body == 0 ? poses_->get()[step] : bodies_[body].pose;
}

std::uint32_t PageScene::number_of(const soms::SceneBody& body) const {
  const auto found = numbers_.find(body);
  if (found == numbers_.end()) {
    throw usage("answer: it is about a body that the scene has not",
                "give the report of the last step of this scene");
  }
  return found->second;
}

void PageScene::follow(std::size_t step, StepReport report) {
  lists_contacts_ = true;
  complete_ =
      complete_ && report.coverage == Coverage::complete && report.scope == StepScope::every_pair;
  // What is drawn of an answer that lacks pairs lacks them, too, and the page says so.
  report.coverage = Coverage::complete;
  report.scope = StepScope::every_pair;
  const auto add_pair = [&](const soms::SceneBody& x, const soms::SceneBody& y, TrianglePair pair) {
    const std::uint32_t a = number_of(x);
    const std::uint32_t b = number_of(y);
    check_triangle(bodies_[a], pair.a);
    check_triangle(bodies_[b], pair.b);
    Sample& sample = samples_[{step, a, b}];
    ++sample.pairs_in_all;
    if (sample.pairs.size() < (steps_ == 1 ? kMostDrawn : kMostOfStep)) {
      sample.pairs.push_back(pair);
    }
  };
  for (const EnvironmentContact& c : report.environment) {
    add_pair({SceneBodyKind::mover, c.mover}, {SceneBodyKind::environment, c.part}, {c.i, c.j});
  }
  for (const MoverContact& c : report.movers) {
    add_pair({SceneBodyKind::mover, c.a}, {SceneBodyKind::mover, c.b}, {c.i, c.j});
  }
  spans_.follow(step, report, {.triangle = [&](const soms::SceneBody& body, TriangleId id) {
                  const std::uint32_t number = number_of(body);
                  const Triangle t = bodies_[number].shape.mesh().triangle(id);
                  const Pose pose = pose_of_body(number, step);
                  return Triangle{pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
                }});
}

void PageScene::add_step(const StepReport& report) {
  follow(0, report);
  for (const EnvironmentGap& gap : report.environment_gaps) {
    add_gap(number_of({SceneBodyKind::mover, gap.mover}),
            number_of({SceneBodyKind::environment, gap.part}), 0, gap.distance, gap.point_a,
            gap.point_b);
  }
  for (const MoverGap& gap : report.mover_gaps) {
    add_gap(number_of({SceneBodyKind::mover, gap.a}), number_of({SceneBodyKind::mover, gap.b}), 0,
            gap.distance, gap.point_a, gap.point_b);
  }
}

void PageScene::add_overlap(std::size_t step, std::span<const TrianglePair> pairs,
                            Coverage coverage) {
  check_pair();
  StepReport report;
  report.coverage = coverage;
  for (const TrianglePair& pair : pairs) {
    report.movers.push_back({0, 1, pair.a, pair.b});
  }
  follow(step, std::move(report));
}

void PageScene::add_distance(std::size_t step, const Distance& distance) {
  check_pair();
  complete_ = complete_ && distance.coverage == Coverage::complete;
  if (distance.triangles) {
    add_gap(0, 1, step, distance.distance, distance.point_a, distance.point_b);
  }
}

void PageScene::add_gap(std::uint32_t a, std::uint32_t b, std::size_t step, const Bracket& distance,
                        const Vec3& point_a, const Vec3& point_b) {
  gaps_.push_back({.a = a,
                   .b = b,
                   .begin = step,
                   .end = step,
                   .nearest = step,
                   .point_a = point_a,
                   .point_b = point_b,
                   .length = length_text(distance)});
}

std::string PageScene::title() const {
  return bodies_.size() == 1   ? names_.front()
         : bodies_.size() == 2 ? names_[0] + " and " + names_[1]
                               : std::to_string(bodies_.size()) + " bodies";
}

/// A row for each pair of bodies, and in it a contact for each stretch of steps.
void PageScene::add_rows(report::Scene& scene) const {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> rows;
  for (const ContactSpan& span : spans_.spans()) {
    const std::uint32_t a = number_of(span.a.body);
    const std::uint32_t b = number_of(span.b.body);
    const auto [found, is_new] = rows.try_emplace({a, b}, scene.rows.size());
    if (is_new) {
      scene.rows.push_back({.a = a, .b = b, .begin = span.begin, .first = span.pair});
    }
    report::SceneRow& row = scene.rows[found->second];
    ++row.count;
    row.steps += span.steps;
    row.end = std::max(row.end, span.end);
    row.box.grow(span.box);
    if (span.most_pairs > row.most_pairs) {
      row.most_pairs = span.most_pairs;
      row.most_step = span.most_step;
      row.place = span.place;
      row.pairs = samples_.at({span.most_step, a, b}).pairs;
    }
    const Sample& sample = samples_.at({span.begin, a, b});
    const auto shown = static_cast<std::ptrdiff_t>(
        std::min(sample.pairs.size(), report::SceneLimits().pairs_of_contact));
    scene.contacts.push_back({.row = found->second,
                              .a = a,
                              .b = b,
                              .begin = span.begin,
                              .end = span.end,
                              .pairs = {sample.pairs.begin(), sample.pairs.begin() + shown},
                              .pairs_in_all = sample.pairs_in_all});
  }
  scene.contacts_in_all = scene.contacts.size();
}

report::Scene PageScene::scene() const {
  report::Scene scene;
  std::map<const MeshView*, std::size_t> models;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const MeshView* const mesh = &bodies_[k].shape.mesh();
    const auto [model, is_new] = models.try_emplace(mesh, scene.models.size());
    if (is_new) {
      scene.models.push_back({*mesh, names_[k]});
    }
    scene.bodies.push_back({.model = model->second, .name = names_[k], .moves = moves_[k]});
  }
  add_rows(scene);
  scene.gaps = gaps_;
  scene.gaps_in_all = gaps_.size();
  scene.lists_contacts = lists_contacts_;
  scene.complete = complete_;
  scene.steps = {.count = std::max<std::uint64_t>(steps_, 1), .noun = "pose", .smooth = false};
  scene.pose = [this](std::uint32_t body, std::uint64_t step) { return pose_of_body(body, step); };
  scene.y_is_up = std::all_of(bodies_.begin(), bodies_.end(),
                              [](const Body& body) { return body.shape.mesh().up == UpAxis::y; });
  return scene;
}

}  // namespace soms::python
