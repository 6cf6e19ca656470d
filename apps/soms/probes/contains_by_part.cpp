#include "apps/soms/probes/contains_by_part.h"

#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/query/contains_parts.h"
#include "soms/query/reference/contains.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/shapes.h"
#include "apps/output/json.h"
#include "apps/rows/csv_file.h"
#include "apps/rows/point_source.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/probe_rows.h"
#include "apps/world/part_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

/// Triangles of one part, as a mesh of their own: what `--verify` looks at.
Mesh triangles_of_part(const DividedBody& body, std::uint32_t part) {
  Mesh mesh;
  const MeshView& whole = body.body().shape.mesh();
  mesh.vertices.assign(whole.vertices.begin(), whole.vertices.end());
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    if (body.part_of(static_cast<TriangleId>(i)) == part) {
      mesh.triangles.push_back(whole.triangles[i]);
    }
  }
  return mesh;
}

/// Which parts of a model hold each point?
class ContainsPartsQuestion : public Question {
 public:
  ContainsPartsQuestion(const ContainsVerbOptions& options, const ProbeRows<PointSource>& rows,
                        const Pose& pose, const Console& console)
      : rows_(rows),
        console_(console),
        body_(body_of(options, pose)),
        report_(options, body_.body().shape.mesh()) {
    note_open_parts();
  }

  std::uint64_t answer(const ShowProgress&) override {
    answers_ = contains(body_, rows_.block(), console_.limits());
    return answers_.parts.size();
  }

  [[nodiscard]] RowOutcome outcome(std::size_t k) const override {
    const bool cut = answers_.coverage[k] == Coverage::cut;
    return {.found = !answers_.parts_of(k).empty(), .undecided = cut, .cut = cut};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (answers_.coverage[k] == Coverage::cut) {
      return std::nullopt;
    }
    return console_.run("verifying", [&](const Limits& limits) {
      std::optional<std::string> found;
      for (std::uint32_t part = 0; part < body_.parts().size() && !found; ++part) {
        check_stop(limits);
        found = difference_of_part(k, part);
      }
      return found;
    });
  }

  void count(const AnsweredRow& row) override {
    held_ += answers_.parts_of(row.k).empty() ? 0U : 1U;
  }

  void json(const AnsweredRow& row, JsonRows& rows) const override {
    const std::size_t k = row.k;
    Json parts = Json::array();
    for (const PartSide& part : answers_.parts_of(k)) {
      parts.push_back(part_json(part.part));
      parts.back()["side"] = std::string(name(part.side));
    }
    std::string keys =
        ",\"parts\":" + json_text(parts) + coverage_keys(answers_.coverage[k], answers_.costs[k]);
    if (row.number == 0) {
      Json open = Json::array();
      for (std::uint32_t part = 0; part < body_.parts().size(); ++part) {
        if (!body_.parts()[part].closed) {
          open.push_back(part_json(part));
          open.back()["odd_edges"] = body_.parts()[part].odd_edges;
        }
      }
      keys += ",\"open_parts\":" + json_text(open);
    }
    rows.put(json_row("contains", "row", row, keys + report_.keys(row)));
    rows.end_row();
  }

  [[nodiscard]] std::string text_head() const override {
    return fmt::format("{:>6}  {}\n", "point", "at, and parts that hold it");
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    return fmt::format("{:>6}  {}: {}\n", row.number, point_in_text(rows_.block()[row.k]),
                       in_words(row.k));
  }

  [[nodiscard]] std::string totals(const RowTotals& totals) const override {
    return fmt::format("{}: {} in or on {}, {} of them closed\n", counted(totals.rows, "point"),
                       with_commas(held_), counted(body_.parts().size(), "part"),
                       with_commas(body_.parts().size() - body_.open_parts()));
  }

  [[nodiscard]] std::string csv_head() const override {
    return "row,part,name,path,first,side,coverage";
  }

  void csv(const AnsweredRow& row, CsvFile& file) const override {
    for (const PartSide& found : answers_.parts_of(row.k)) {
      const DividedPart& part = body_.parts()[found.part];
      const std::string path =
          part.named == Part::kNoParent ? "" : csv_field(part_path_label(mesh(), part.named));
      file.line() +=
          fmt::format("{},{},{},{},{},{}", row.number, part_csv_fields(mesh(), part.named), path,
                      numbers_(part.first), name(found.side), name(answers_.coverage[row.k]));
      file.end_line();
    }
  }

 private:
  [[nodiscard]] DividedBody body_of(const ContainsVerbOptions& options, const Pose& pose) {
    ModelShape model =
        load_only_model(options.model, options.reading, {.build = options.build}, console_);
    numbers_ = model.numbers;
    const Partition partition =
        options.by == ContainsBy::part ? Partition::named : Partition::connected;
    return console_.run("looking for parts that are closed", [&](const Limits& limits) {
      return DividedBody(Body(std::move(model.shape), pose), partition, limits);
    });
  }

  [[nodiscard]] const MeshView& mesh() const { return report_.mesh(); }

  /// The path of a named part; "the part of triangle 12" of another one. Printable.
  [[nodiscard]] std::string label(std::uint32_t part) const {
    const DividedPart& found = body_.parts()[part];
    return found.named != Part::kNoParent
               ? printable(body_label(mesh(), found.named, found.joined))
               : fmt::format("the part of triangle {}", numbers_(found.first));
  }

  void note_open_parts() {
    if (body_.open_parts() == 0) {
      return;
    }
    constexpr std::size_t kNamed = 3;
    std::string names;
    std::size_t named = 0;
    for (std::uint32_t k = 0; k < body_.parts().size(); ++k) {
      if (!body_.parts()[k].closed && named < kNamed) {
        names += (named == 0 ? "" : ", ") + label(k);
        ++named;
      }
    }
    console_.note(fmt::format("{}: {} of {} not closed, and no point is inside of them: {}{}",
                              printable(mesh().source), body_.open_parts(),
                              counted(body_.parts().size(), "part"), names,
                              body_.open_parts() > kNamed ? ", ..." : ""));
  }

  [[nodiscard]] std::optional<std::string> difference_of_part(std::size_t k, std::uint32_t part) {
    const auto row = answers_.parts_of(k);
    const auto found =
        std::find_if(row.begin(), row.end(), [&](const PartSide& p) { return p.part == part; });
    const Side side = found == row.end() ? Side::outside : found->side;
    auto& alone = alone_[part];
    if (!alone) {
      alone.emplace(triangles_of_part(body_, part), body_.body().pose);
    }
    Side truth = reference::contains_by_brute_force(*alone, rows_.block()[k]);
    if (!body_.parts()[part].closed && truth != Side::on) {
      truth = Side::outside;
    }
    return truth == side ? std::nullopt
                         : std::optional(fmt::format("of {} brute force finds {}, but the answer "
                                                     "is {}",
                                                     label(part), name(truth), name(side)));
  }

  [[nodiscard]] std::string in_words(std::size_t k) const {
    if (answers_.coverage[k] == Coverage::cut) {
      return "undecided";
    }
    std::string words;
    for (const PartSide& part : answers_.parts_of(k)) {
      words += (words.empty() ? "" : ", ") + std::string(name(part.side)) + " " +
               (part.side == Side::inside ? "" : "the surface of ") + label(part.part);
    }
    return words.empty() ? "in no part" : words;
  }

  [[nodiscard]] Json part_json(std::uint32_t part) const {
    const DividedPart& found = body_.parts()[part];
    Json json = body_.partition() == Partition::named
                    ? body_as_json(mesh(), found.named, found.joined)
                    : Json::object();
    json["first"] = numbers_(found.first);
    return json;
  }

  const ProbeRows<PointSource>& rows_;
  const Console& console_;
  FileNumbers numbers_;
  DividedBody body_;
  ProbeReport report_;
  ContainsPartsBatch answers_;
  std::map<std::uint32_t, std::optional<Body>> alone_;  // parts that brute force has looked at
  std::uint64_t held_ = 0;
};

}  // namespace

int run_contains_by_part(const ContainsVerbOptions& options, Console& console) {
  return run_probes<PointSource>(options, options.points, {.verb = "contains"}, console,
                                 [&](const auto& rows, const Pose& pose) {
                                   return ContainsPartsQuestion(options, rows, pose, console);
                                 });
}

}  // namespace soms::command
