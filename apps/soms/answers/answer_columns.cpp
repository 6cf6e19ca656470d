#include "apps/soms/answers/answer_columns.h"

#include "apps/cli/parse.h"
#include "apps/soms/pairs/pair_options.h"

#include <limits>
#include <variant>

namespace soms::command {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The number of a triangle, or -1.
std::int64_t number_or_none(const std::optional<TriangleId>& triangle) {
  return triangle ? static_cast<std::int64_t>(*triangle) : -1;
}

/// The number of a part, or -1 for triangles that are in none.
std::int64_t number_of_part(std::uint32_t part) {
  return part == Part::kNoParent ? -1 : std::int64_t{part};
}

Vec3 point_or_none(bool there, const Vec3& point) {
  return there ? point : Vec3{kNone, kNone, kNone};
}

NpzColumn& side_column(NpzFile& file) {
  return file.names("side", {"outside", "inside", "on", "undecided"});
}

template <class Enum>
std::uint8_t code(Enum value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace

void add_binary(Parser& parser, std::string& target) {
  add_output(parser, "--binary", target, "write the answers as columns, arrays that NumPy loads")
      ->group(kQuestionGroup);
}

void PointColumns::begin(bool lists, bool sides) {
  if (!file_) {
    return;
  }
  if (lists) {
    offsets_ = &file_->column("offsets", Kind::count);
    offsets_->add(hits_);
  }
  lower_ = &file_->column("lower", Kind::number);
  upper_ = &file_->column("upper", Kind::number);
  triangle_ = &file_->column("triangle", Kind::count);
  if (!lists) {
    at_ = &file_->column("at", Kind::number, {3});
    feature_ = &file_->names("feature", {"vertex", "edge", "face"});
    farther_ = &file_->column("farther", Kind::flag);
  }
  if (sides) {
    side_ = &side_column(*file_);
  }
  cut_ = &file_->column("cut", Kind::flag);
}

void PointColumns::add(const PointAnswer& answer) {
  if (!file_) {
    return;
  }
  cut_->add(answer.cut());
  if (answer.hits) {
    add_list(answer);
    return;
  }
  const Closest& closest = answer.closest;
  lower_->add(closest.distance.lower);
  upper_->add(closest.distance.upper);
  triangle_->add(number_or_none(closest.triangle));
  at_->add(point_or_none(closest.triangle.has_value(), closest.point));
  feature_->add(code(closest.feature));
  farther_->add(closest.farther);
  if (side_ != nullptr) {
    side_->add(code(answer.side.value_or(Side::undecided)));
  }
}

void PointColumns::add_list(const PointAnswer& answer) {
  for (const ListedTriangle& hit : *answer.hits) {
    lower_->add(hit.distance.lower);
    upper_->add(hit.distance.upper);
    triangle_->add(number_or_none(hit.triangle));
  }
  hits_ += static_cast<std::int64_t>(answer.hits->size());
  offsets_->add(hits_);
}

SideColumns::SideColumns(const std::string& path, bool winding) : AnswerColumns(path) {
  if (file_) {
    side_ = &side_column(*file_);
    if (winding) {
      lower_ = &file_->column("lower", Kind::number);
      upper_ = &file_->column("upper", Kind::number);
    }
  }
}

void SideColumns::add(Side side) {
  if (file_) {
    side_->add(code(side));
  }
}

void SideColumns::add(const Bracket& number) {
  if (file_) {
    lower_->add(number.lower);
    upper_->add(number.upper);
  }
}

void RayColumns::begin(const RayAnswer& like) {
  if (!file_) {
    return;
  }
  if (std::holds_alternative<AnyHit>(like)) {
    hit_ = &file_->column("hit", Kind::flag);
  } else if (std::holds_alternative<ClosestHit>(like)) {
    hit_ = &file_->column("hit", Kind::flag);
    lower_ = &file_->column("lower", Kind::number);
    upper_ = &file_->column("upper", Kind::number);
    triangle_ = &file_->column("triangle", Kind::count);
    at_ = &file_->column("at", Kind::number, {3});
    front_ = &file_->column("front", Kind::flag);
  } else {
    offsets_ = &file_->column("offsets", Kind::count);
    lower_ = &file_->column("lower", Kind::number);
    upper_ = &file_->column("upper", Kind::number);
    kind_ = &file_->names("kind", {"enter", "leave", "graze"});
    triangle_offsets_ = &file_->column("triangle_offsets", Kind::count);
    triangle_ = &file_->column("triangle", Kind::count);
    offsets_->add(crossings_);
    triangle_offsets_->add(triangles_);
  }
  cut_ = &file_->column("cut", Kind::flag);
}

void RayColumns::add(const RayAnswer& answer) {
  if (!file_) {
    return;
  }
  std::visit([this](const auto& one) { add_row(one); }, answer);
  cut_->add(is_cut(answer));
}

void RayColumns::add_row(const ClosestHit& hit) {
  hit_->add(hit.triangle.has_value());
  lower_->add(hit.t.lower);
  upper_->add(hit.t.upper);
  triangle_->add(number_or_none(hit.triangle));
  at_->add(point_or_none(hit.triangle.has_value(), hit.point));
  front_->add(hit.front);
}

void RayColumns::add_row(const AnyHit& hit) {
  hit_->add(hit.hit);
}

void RayColumns::add_row(const Crossings& hits) {
  for (const Crossing& place : hits.places) {
    lower_->add(place.t.lower);
    upper_->add(place.t.upper);
    kind_->add(code(place.kind));
    for (const TriangleId triangle : place.triangles) {
      triangle_->add(number_or_none(triangle));
    }
    triangles_ += static_cast<std::int64_t>(place.triangles.size());
    triangle_offsets_->add(triangles_);
  }
  crossings_ += static_cast<std::int64_t>(hits.places.size());
  offsets_->add(crossings_);
}

void NearColumns::begin_pair() {
  triangles_ = &file_->column("triangles", Kind::count, {2});
  points_ = &file_->column("points", Kind::number, {2, 3});
  cut_ = &file_->column("cut", Kind::flag);
}

template <class Answer>
void NearColumns::add_pair(const Answer& answer) {
  const bool there = answer.triangles.has_value();
  triangles_->add(there ? std::int64_t{answer.triangles->first} : -1);
  triangles_->add(there ? std::int64_t{answer.triangles->second} : -1);
  points_->add(point_or_none(there, answer.point_a));
  points_->add(point_or_none(there, answer.point_b));
  cut_->add(answer.coverage == Coverage::cut);
}

void NearColumns::begin(const Distance&) {
  if (file_) {
    lower_ = &file_->column("lower", Kind::number);
    upper_ = &file_->column("upper", Kind::number);
    farther_ = &file_->column("farther", Kind::flag);
    begin_pair();
  }
}

void NearColumns::begin(const Within&) {
  if (file_) {
    within_ = &file_->column("within", Kind::flag);
    at_least_ = &file_->column("at_least", Kind::number);
    begin_pair();
  }
}

void NearColumns::add(const Distance& answer) {
  if (!file_) {
    return;
  }
  lower_->add(answer.distance.lower);
  upper_->add(answer.distance.upper);
  farther_->add(answer.farther);
  add_pair(answer);
}

void NearColumns::add(const Within& answer) {
  if (!file_) {
    return;
  }
  within_->add(answer.within);
  at_least_->add(answer.at_least);
  add_pair(answer);
}

SolidColumns::SolidColumns(const std::string& path) : AnswerColumns(path) {
  if (file_) {
    relation_ = &file_->names(
        "relation", {"clear", "touching", "crossing", "a_in_b", "b_in_a", "same", "undecided"});
    surfaces_meet_ = &file_->column("surfaces_meet", Kind::flag);
    why_ = &file_->names("why", {"none", "deadline", "open"});
  }
}

void SolidColumns::add(const Solid& answer) {
  if (file_) {
    relation_->add(code(answer.relation));
    surfaces_meet_->add(answer.surfaces_meet);
    why_->add(code(answer.why));
  }
}

SolidPartColumns::SolidPartColumns(const std::string& path) : SolidColumns(path) {
  if (file_) {
    offsets_ = &file_->column("offsets", Kind::count);
    parts_ = &file_->column("parts", Kind::count, {2});
    cut_ = &file_->column("cut", Kind::flag);
    offsets_->add(pairs_);
  }
}

void SolidPartColumns::add(std::span<const SolidPair> pairs, bool cut) {
  if (!file_) {
    return;
  }
  for (const SolidPair& pair : pairs) {
    parts_->add(number_of_part(pair.a->part));
    parts_->add(number_of_part(pair.b->part));
    SolidColumns::add(pair.answer);
  }
  pairs_ += static_cast<std::int64_t>(pairs.size());
  offsets_->add(pairs_);
  cut_->add(cut);
}

void OverlapColumns::begin(List list) {
  list_ = list;
  if (!file_) {
    return;
  }
  any_ = &file_->column("any", Kind::flag);
  if (list == List::none) {
    count_ = &file_->column("count", Kind::count);
  } else {
    offsets_ = &file_->column("offsets", Kind::count);
    offsets_->add(listed_);
  }
  if (list == List::triangles) {
    triangles_ = &file_->column("triangles", Kind::count, {2});
  }
  if (list == List::parts) {
    parts_ = &file_->column("parts", Kind::count, {2});
    count_ = &file_->column("count", Kind::count);
    first_ = &file_->column("first", Kind::count, {2});
  }
  cut_ = &file_->column("cut", Kind::flag);
}

void OverlapColumns::add(const Overlap& answer, std::span<const PartPair> parts) {
  if (!file_) {
    return;
  }
  any_->add(answer.any);
  cut_->add(answer.coverage == Coverage::cut);
  switch (list_) {
    case List::none:
      count_->add(static_cast<std::int64_t>(answer.pairs.size()));
      break;
    case List::triangles:
      add_triangles(answer);
      break;
    case List::parts:
      add_parts(parts);
      break;
  }
}

void OverlapColumns::add_triangles(const Overlap& answer) {
  for (const TrianglePair& pair : answer.pairs) {
    triangles_->add(std::int64_t{pair.first});
    triangles_->add(std::int64_t{pair.second});
  }
  listed_ += static_cast<std::int64_t>(answer.pairs.size());
  offsets_->add(listed_);
}

void OverlapColumns::add_parts(std::span<const PartPair> parts) {
  for (const PartPair& pair : parts) {
    parts_->add(number_of_part(pair.a));
    parts_->add(number_of_part(pair.b));
    count_->add(static_cast<std::int64_t>(pair.count));
    first_->add(std::int64_t{pair.first.first});
    first_->add(std::int64_t{pair.first.second});
  }
  listed_ += static_cast<std::int64_t>(parts.size());
  offsets_->add(listed_);
}

}  // namespace soms::command
