#include "apps/soms/probes/closest_model.h"

#include "soms/query/reference/closest.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/rows/csv_file.h"
#include "apps/soms/answers/batch_question.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace soms::command {

ClosestModel::ClosestModel(const ClosestVerbOptions& options, const Pose& pose,
                           const Console& console)
    : model_(options.model, options.reading, options.build, pose,
             {refused_verify(options.verify),
              {options.with_side, "--signed", "inside is decided by whole surfaces"},
              {options.nearest != 0, "--nearest", "it lists triangles of several of them"},
              {options.radius.has_value(), "--radius", "it lists triangles of several of them"}},
             console),
      report_(options, model_.mesh()),
      parts_(model_.mesh()),
      console_(console) {
  query_.at_most =
      std::min(options.at_most, options.radius.value_or(std::numeric_limits<double>::infinity()));
}

std::string closest_totals(const RowTotals& totals, std::vector<std::string> parts) {
  if (totals.undecided != 0) {
    parts.push_back(with_commas(totals.undecided) + " undecided");
  }
  const std::string count = counted(totals.rows, "point");
  return (parts.empty() ? count : fmt::format("{}: {}", count, fmt::join(parts, "; "))) + "\n";
}

NearListsQuestion::NearListsQuestion(const ClosestVerbOptions& options,
                                     const ProbeRows<PointSource>& rows, const Pose& pose,
                                     const Console& console)
    : most_(options.nearest == 0 ? std::numeric_limits<std::size_t>::max() : options.nearest),
      rows_(rows),
      model_(options, pose, console) {
}

std::uint64_t NearListsQuestion::answer(const ShowProgress&) {
  lists_ = nearest_triangles(model_.model().body(), rows_.block(), most_, model_.query(),
                             model_.console().limits());
  return lists_.triangle.size();
}

RowOutcome NearListsQuestion::outcome(std::size_t k) const {
  return {.undecided = is_cut(k), .cut = is_cut(k)};
}

std::optional<std::string> NearListsQuestion::difference(std::size_t k) {
  if (is_cut(k)) {
    return std::nullopt;  // it says no more than that it found these
  }
  const std::vector<ListedTriangle> hits = hits_of(k);
  auto truth = model_.console().run("verifying", [&](const Limits&) {
    return reference::triangles_by_brute_force(model_.model().body(), rows_.block()[k],
                                               model_.query().at_most);
  });
  truth.resize(std::min(truth.size(), most_));
  const bool right =
      std::equal(hits.begin(), hits.end(), truth.begin(), truth.end(),
                 [](const ListedTriangle& hit, const reference::RankedTriangle& expected) {
                   return hit.triangle == expected.triangle && hit.distance == expected.distance;
                 });
  return right ? std::nullopt
               : std::optional(fmt::format("brute force finds other triangles: {} of them, and "
                                           "the answer has {}",
                                           truth.size(), hits.size()));
}

void NearListsQuestion::count(const AnsweredRow& row) {
  hits_ += lists_.offsets[row.k + 1] - lists_.offsets[row.k];
}

void NearListsQuestion::json(const AnsweredRow& row, JsonRows& rows) const {
  std::string text = ",\"hits\":[";
  for (const ListedTriangle& hit : shown(row.k)) {
    text += fmt::format("{}{{\"triangle\":{}{}}}", text.back() == '[' ? "" : ",", hit.triangle,
                        detail::json_key("distance", hit.distance));
  }
  rows.put(json_row("closest", "row", row,
                    text + "]" + coverage_keys(lists_.coverage[row.k], lists_.costs[row.k]) +
                        model_.report().keys(row)));
  rows.end_row();
}

std::string NearListsQuestion::sentence(std::size_t k) const {
  return list_text(shown(k), is_cut(k), model_.mesh()) + "\n";
}

std::string NearListsQuestion::text_head() const {
  return list_head();
}

std::string NearListsQuestion::text(const AnsweredRow& row) const {
  return list_row(row.number, shown(row.k), is_cut(row.k), model_.mesh(), digits());
}

std::string NearListsQuestion::totals(const RowTotals& totals) const {
  return closest_totals(totals, {counted(hits_, "triangle")});
}

std::string NearListsQuestion::csv_head() const {
  return "row,triangle,part,name,lower,upper,coverage";
}

void NearListsQuestion::csv(const AnsweredRow& row, CsvFile& file) const {
  for (const ListedTriangle& hit : shown(row.k)) {
    file.line() +=
        fmt::format("{},{},{},{},{}", row.number, model_.cells(hit.triangle), hit.distance.lower,
                    hit.distance.upper, name(lists_.coverage[row.k]));
    file.end_line();
  }
}

void NearListsQuestion::begin_columns(NpzFile& file) {
  offsets_.begin(file, "offsets");
  lower_ = &file.column("lower", NpzColumn::Kind::number);
  upper_ = &file.column("upper", NpzColumn::Kind::number);
  triangle_ = &file.column("triangle", NpzColumn::Kind::count);
  coverage_ = &file.names("coverage", kWords<Coverage>.names);
  add_georeference(file, model_.report().georeference());
}

void NearListsQuestion::add_columns(std::size_t rows) {
  for (std::size_t k = 0; k < rows; ++k) {
    offsets_.add(lists_.offsets[k + 1] - lists_.offsets[k]);
    add_code(*coverage_, lists_.coverage[k]);
  }
  for (std::size_t i = 0; i < lists_.offsets[rows]; ++i) {
    lower_->add(lists_.lower[i]);
    upper_->add(lists_.upper[i]);
    triangle_->add(std::int64_t{model_.model().numbers()(lists_.triangle[i])});
  }
}

}  // namespace soms::command
