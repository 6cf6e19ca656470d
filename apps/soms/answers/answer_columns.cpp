#include "apps/soms/answers/answer_columns.h"

#include "apps/cli/parse.h"
#include "apps/soms/pairs/pair_options.h"

#include <limits>
#include <variant>

namespace soms::command {

namespace {

/// The number of a part, or -1 for triangles that are in none.
std::int64_t number_of_part(std::uint32_t part) {
  return part == Part::kNoParent ? -1 : std::int64_t{part};
}

NpzColumn& side_column(NpzFile& file) {
  return file.names("side", kWords<Side>.names);
}

NpzColumn& coverage_column(NpzFile& file) {
  return file.names("coverage", kWords<Coverage>.names);
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
    lower_ = &file_->column("lower", Kind::number);
    upper_ = &file_->column("upper", Kind::number);
    triangle_ = &file_->column("triangle", Kind::count);
    coverage_ = &coverage_column(*file_);
  } else {
    fields_.begin<Closest>(*file_);
  }
  if (sides) {
    side_ = &side_column(*file_);
  }
}

void PointColumns::add(const PointAnswer& answer) {
  if (!file_) {
    return;
  }
  if (answer.hits) {
    add_list(answer);
    return;
  }
  Closest closest = answer.closest;
  closest.coverage = answer.coverage();
  fields_.add(closest);
  if (side_ != nullptr) {
    side_->add(code(answer.side.value_or(Side::undecided)));
  }
}

void PointColumns::add_list(const PointAnswer& answer) {
  for (const ListedTriangle& hit : *answer.hits) {
    lower_->add(hit.distance.lower);
    upper_->add(hit.distance.upper);
    triangle_->add(std::int64_t{hit.triangle});
  }
  hits_ += static_cast<std::int64_t>(answer.hits->size());
  offsets_->add(hits_);
  coverage_->add(code(answer.coverage()));
}

void RayColumns::begin(const RayAnswer& like) {
  if (!file_) {
    return;
  }
  if (std::holds_alternative<AnyHit>(like)) {
    fields_.begin<AnyHit>(*file_);
  } else if (std::holds_alternative<ClosestHit>(like)) {
    hit_ = &file_->column("hit", Kind::flag);
    fields_.begin<ClosestHit>(*file_);
  } else {
    offsets_ = &file_->column("offsets", Kind::count);
    lower_ = &file_->column("lower", Kind::number);
    upper_ = &file_->column("upper", Kind::number);
    kind_ = &file_->names("kind", kWords<CrossingKind>.names);
    triangle_offsets_ = &file_->column("triangle_offsets", Kind::count);
    triangle_ = &file_->column("triangle", Kind::count);
    coverage_ = &coverage_column(*file_);
    offsets_->add(crossings_);
    triangle_offsets_->add(triangles_);
  }
}

void RayColumns::add(const RayAnswer& answer) {
  if (file_) {
    std::visit([this](const auto& one) { add_row(one); }, answer);
  }
}

void RayColumns::add_row(const ClosestHit& hit) {
  hit_->add(hit.triangle.has_value());
  fields_.add(hit);
}

void RayColumns::add_row(const AnyHit& hit) {
  fields_.add(hit);
}

void RayColumns::add_row(const Crossings& hits) {
  for (const Crossing& place : hits.places) {
    lower_->add(place.t.lower);
    upper_->add(place.t.upper);
    kind_->add(code(place.kind));
    for (const TriangleId triangle : place.triangles) {
      triangle_->add(std::int64_t{triangle});
    }
    triangles_ += static_cast<std::int64_t>(place.triangles.size());
    triangle_offsets_->add(triangles_);
  }
  crossings_ += static_cast<std::int64_t>(hits.places.size());
  offsets_->add(crossings_);
  coverage_->add(code(hits.coverage));
}

SolidPartColumns::SolidPartColumns(const std::string& path) : AnswerColumns(path) {
  if (file_) {
    relation_ = &file_->names("relation", kWords<Relation>.names);
    surfaces_meet_ = &file_->column("surfaces_meet", Kind::flag);
    why_ = &file_->names("why", kWords<Undecided>.names);
    offsets_ = &file_->column("offsets", Kind::count);
    parts_ = &file_->column("parts", Kind::count, {2});
    coverage_ = &coverage_column(*file_);
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
    relation_->add(code(pair.answer.relation));
    surfaces_meet_->add(pair.answer.surfaces_meet);
    why_->add(code(pair.answer.why));
  }
  pairs_ += static_cast<std::int64_t>(pairs.size());
  offsets_->add(pairs_);
  coverage_->add(code(cut ? Coverage::cut : Coverage::complete));
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
    pairs_ = &file_->column("pairs", Kind::count, {2});
  }
  if (list == List::parts) {
    parts_ = &file_->column("parts", Kind::count, {2});
    count_ = &file_->column("count", Kind::count);
    first_ = &file_->column("first", Kind::count, {2});
  }
  coverage_ = &coverage_column(*file_);
}

void OverlapColumns::add(const Overlap& answer, std::span<const PartPair> parts) {
  if (!file_) {
    return;
  }
  any_->add(answer.any);
  coverage_->add(code(answer.coverage));
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
    pairs_->add(std::int64_t{pair.first});
    pairs_->add(std::int64_t{pair.second});
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
