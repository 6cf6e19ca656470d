#include "apps/view/scene/counted_step.h"

#include <algorithm>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

/// Pairs of meshes whose moved boxes are kept.
constexpr std::size_t kKeptQueries = 64;

std::vector<BodyRef> bodies_of(const ViewScene& scene) {
  std::vector<BodyRef> bodies;
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    bodies.push_back(city_part(k));
  }
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    bodies.push_back(mover(k));
  }
  return bodies;
}

std::vector<Pose> poses_of(const ViewScene& scene) {
  std::vector<Pose> poses;
  for (const BodyRef body : bodies_of(scene)) {
    poses.push_back(scene.body(body).pose);
  }
  return poses;
}

}  // namespace

const std::optional<CountedStep>& StepCounter::find(const ViewScene& scene, const Limits& limits) {
  if (scene.trees().traversal.traversal == Traversal::fast) {
    step_.reset();
    queries_.clear();  // trees stay for who comes back
    return step_;
  }
  std::vector<Pose> poses = poses_of(scene);
  if (step_ && choice_ == scene.trees() && poses_ == poses) {
    return step_;
  }
  set_choice(scene.trees());
  if (queries_.size() > kKeptQueries) {
    queries_.clear();
  }
  step_.emplace();
  try {
    for (const auto& [a, b] : pairs_of(scene)) {
      run(scene, a, b, limits);
      if (step_->cut) {
        break;
      }
    }
  } catch (...) {
    step_.reset();
    throw;
  }
  std::sort(step_->touches.begin(), step_->touches.end());
  poses_ = std::move(poses);
  return step_;
}

void StepCounter::set_choice(const TreeChoice& choice) {
  if (choice_ == choice) {
    return;
  }
  queries_.clear();
  if (!choice_ || choice_->build != choice.build) {
    shapes_.clear();
  }
  choice_ = choice;
}

const Shape& StepCounter::shape_of(const Body& body, const Limits& limits) {
  const auto& mesh = body.shape.shared_mesh();
  const auto known = shapes_.find(mesh.get());
  if (known != shapes_.end()) {
    return known->second;
  }
  const ShapeOptions options{choice_->build, true, Layout::compact};  // only the tree is traversed
  return shapes_.emplace(mesh.get(), Shape(mesh, options, limits)).first->second;
}

/// Bodies that share meshes share a query, so that boxes of the city are moved once.
thesis::NamedOverlap& StepCounter::query_of(const ViewScene& scene, BodyRef a, BodyRef b,
                                            const Limits& limits) {
  const Body& first = scene.body(a);
  const Body& second = scene.body(b);
  const Key key{&first.shape.mesh(), a.role == Role::city ? std::optional(a.index) : std::nullopt,
                &second.shape.mesh()};
  if (choice_->traversal.traversal == Traversal::e_node_front) {
    queries_.clear();  // it would start at the front of other bodies
  }
  const auto known = queries_.find(key);
  if (known != queries_.end()) {
    return known->second;
  }
  thesis::NamedOverlap query(shape_of(first, limits), shape_of(second, limits), choice_->traversal);
  query.move(first.pose, Pose::identity());
  return queries_.emplace(key, std::move(query)).first->second;
}

std::vector<std::pair<BodyRef, BodyRef>> StepCounter::pairs_of(const ViewScene& scene) {
  const std::vector<BodyRef> bodies = bodies_of(scene);
  if (scene.movers() > 0 && bodies.size() == 2) {
    return {{bodies[0], bodies[1]}};
  }
  if (parts_ != scene.city_parts()) {
    parts_ = scene.city_parts();
    broad_phase_.set_filter(std::vector<std::uint32_t>(parts_, 1), {});
  }
  std::vector<Box> boxes;
  boxes.reserve(bodies.size());
  for (const BodyRef body : bodies) {
    boxes.push_back(scene.bounds(body));
  }
  std::vector<std::pair<BodyRef, BodyRef>> pairs;
  for (const auto& [a, b] : broad_phase_.find(boxes)) {
    pairs.emplace_back(bodies[a], bodies[b]);
  }
  return pairs;
}

void StepCounter::run(const ViewScene& scene, BodyRef a, BodyRef b, const Limits& limits) {
  thesis::NamedOverlap& query = query_of(scene, a, b, limits);
  CountedStep& step = *step_;
  const auto begin = Clock::now();
  Limits patient = limits;
  if (patience_) {
    const std::chrono::duration<double, std::milli> taken(step.milliseconds);
    patient.deadline = begin + *patience_ - std::chrono::duration_cast<Clock::duration>(taken);
  }
  const Overlap answer = query(scene.body(a).pose, scene.body(b).pose, {}, patient);
  step.milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  step.cut = answer.coverage == Coverage::cut;
  step.cost += answer.cost;
  step.counts += query.counts();
  ++step.queries;
  for (const auto& [i, j] : answer.pairs) {
    step.touches.push_back(a.role == Role::city ? Touch{b, a, j, i} : Touch{a, b, i, j});
  }
}

}  // namespace soms::view
