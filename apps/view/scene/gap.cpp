#include "apps/view/scene/gap.h"

#include "apps/cli/text.h"
#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::view {

namespace {

/// So many times the length of a gap is worth seeing around it; a small one counts as this share of
/// the smaller body.
constexpr double kAroundGap = 3;
constexpr double kLeastOfBody = 0.3;
/// Of the whole scene no more than this share, unless the gap itself is longer.
constexpr double kShareOfScene = 0.1;

}  // namespace

std::string length_in_text(const Gap& gap) {
  return command::four_digits(gap.distance.distance.lower);
}

Box surroundings(const Gap& gap, const Box& a, const Box& b, const Box& scene) {
  const double segment = length(gap.distance.point_b - gap.distance.point_a);
  const double smaller = 0.5 * std::min(length(a.extent()), length(b.extent()));
  const double reach =
      std::max(segment, std::min({smaller, kShareOfScene * length(scene.extent()),
                                  std::max(kAroundGap * segment, kLeastOfBody * smaller)}));
  const Vec3 middle = (gap.distance.point_a + gap.distance.point_b) * 0.5;
  const Vec3 half{reach, reach, reach};
  return {middle - half, middle + half};
}

std::optional<GapQuestion> gap_question(const std::optional<std::pair<BodyRef, BodyRef>>& pair,
                                        std::uint32_t city_parts, std::uint32_t movers,
                                        std::span<const Touch> touches) {
  if (!pair) {
    return city_parts == 2 && movers == 0 ? std::optional(GapQuestion{{city_part(0)}, city_part(1)})
                                          : std::nullopt;
  }
  const auto& [a, b] = *pair;
  const bool with_city = a.role == Role::city;
  const BodyRef first = with_city ? b : std::min(a, b);
  const BodyRef second = with_city ? city_part(0) : std::max(a, b);
  const auto touch = std::lower_bound(touches.begin(), touches.end(), Touch{first, second, 0, 0});
  if (touch != touches.end() && touch->a == first &&
      (with_city ? touch->b.role == Role::city : touch->b == second)) {
    return std::nullopt;
  }
  GapQuestion question{{}, b};
  for (std::uint32_t k = 0; with_city && k < city_parts; ++k) {
    question.a.push_back(city_part(k));
  }
  if (!with_city) {
    question.a.push_back(a);
  }
  return question;
}

const std::optional<Gap>& GapStore::find(const GapQuestion& question, const BodyOf& body,
                                         const Limits& limits) {
  std::vector<Pose> poses;
  poses.reserve(question.a.size() + 1);
  for (const BodyRef a : question.a) {
    poses.push_back(body(a).pose);
  }
  poses.push_back(body(question.b).pose);
  if (question_ == question && poses_ == poses) {
    return gap_;
  }
  question_.reset();  // an error leaves no answer of other poses
  gap_.reset();
  DistanceOptions options;
  Limits patient = limits;
  if (patience_) {
    patient.deadline = std::chrono::steady_clock::now() + *patience_;
  }
  Coverage coverage = Coverage::complete;
  for (const BodyRef a : question.a) {
    Distance answer = distance(body(a), body(question.b), options, patient);
    ++queries_;
    coverage = answer.coverage == Coverage::complete ? coverage : answer.coverage;
    // An upper end of 0 is a shared point; a gap may be so small that its lower end rounds to 0.
    if (answer.distance.upper == 0) {
      gap_.reset();
      break;
    }
    if (answer.triangles && (!gap_ || answer.distance.upper < gap_->distance.distance.upper)) {
      options.at_most = answer.distance.upper;
      gap_ = Gap{a, question.b, std::move(answer)};
    }
  }
  if (gap_) {
    gap_->distance.coverage = coverage;
  }
  question_ = question;
  poses_ = std::move(poses);
  return gap_;
}

}  // namespace soms::view
