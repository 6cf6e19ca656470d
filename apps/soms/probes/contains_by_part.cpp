#include "apps/soms/probes/contains_by_part.h"

#include "soms/base/error.h"
#include "soms/query/contains_parts.h"
#include "soms/query/reference/contains.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/shapes.h"
#include "apps/output/json.h"
#include "apps/rows/point_source.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/probe_run.h"
#include "apps/soms/solid/closed_body.h"
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

class PartsRun : public ProbeRun<PointSource> {
 public:
  PartsRun(const ContainsVerbOptions& options, PartSideCsv& csv, Console& console)
      : ProbeRun(options, options.points, {.verb = "contains", .has_files = !options.csv.empty()},
                 console),
        csv_(csv),
        body_(body_of(options)) {
    note_open_parts();
  }

 private:
  [[nodiscard]] DividedBody body_of(const ContainsVerbOptions& options) {
    Shape shape = load_shape(options.model, options.reading, {.build = options.build}, console());
    const Partition partition =
        options.by == ContainsBy::part ? Partition::named : Partition::connected;
    return console().run("looking for parts that are closed", [&](const Parallel& parallel) {
      return DividedBody(Body(std::move(shape), pose()), partition, parallel);
    });
  }

  [[nodiscard]] const MeshView& mesh() const { return body_.body().shape.mesh(); }

  /// The path of a named part; "the part of triangle 12" of another one. Printable.
  [[nodiscard]] std::string label(std::uint32_t part) const {
    const DividedPart& found = body_.parts()[part];
    return found.named != Part::kNoParent ? printable(body_label(mesh(), found.named, found.joined))
                                          : fmt::format("the part of triangle {}", found.first);
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
    console().note(fmt::format("{}: {} of {} not closed, and no point is inside of them: {}{}",
                               printable(mesh().source), body_.open_parts(),
                               counted(body_.parts().size(), "part"), names,
                               body_.open_parts() > kNamed ? ", ..." : ""));
  }

  std::uint64_t answer_block() override {
    answers_ = contains(body_, block(), {.deadline = console().deadline()}, console().parallel());
    return answers_.parts.size();
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const bool cut = answers_.coverage[k] == Coverage::cut;
    return {.found = !answers_.parts_of(k).empty(), .undecided = cut, .cut = cut};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (answers_.coverage[k] == Coverage::cut) {
      return std::nullopt;
    }
    return console().run("verifying", [&](const Parallel& parallel) {
      std::optional<std::string> found;
      for (std::uint32_t part = 0; part < body_.parts().size() && !found; ++part) {
        check_stop(parallel);
        found = difference_of_part(k, part);
      }
      return found;
    });
  }

  [[nodiscard]] std::optional<std::string> difference_of_part(std::size_t k, std::uint32_t part) {
    const auto row = answers_.parts_of(k);
    const auto found =
        std::find_if(row.begin(), row.end(), [&](const PartSide& p) { return p.part == part; });
    const Side side = found == row.end() ? Side::outside : found->side;
    auto& alone = alone_[part];
    if (!alone) {
      alone.emplace(triangles_of_part(body_, part), pose());
    }
    Side truth = reference::contains_by_brute_force(*alone, block()[k]);
    if (!body_.parts()[part].closed && truth != Side::on) {
      truth = Side::outside;
    }
    return truth == side ? std::nullopt
                         : std::optional(fmt::format("of {} brute force finds {}, but the answer "
                                                     "is {}",
                                                     label(part), name(truth), name(side)));
  }

  void print_row(std::size_t k, bool right, bool last) override {
    held_ += answers_.parts_of(k).empty() ? 0U : 1U;
    csv_.add(totals().rows, body_, answers_, k);
    if (console().shared().json) {
      print_json(mesh(), "row", keys(k), right, last);
      return;
    }
    if (totals().rows == 0) {
      console().print(fmt::format("{:>6}  {}\n", "point", "at, and parts that hold it"));
    }
    if (totals().rows < kProbesInText) {
      console().print(
          fmt::format("{:>6}  {}: {}\n", totals().rows, point_in_text(block()[k]), in_words(k)));
    }
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
    json["first"] = found.first;
    return json;
  }

  [[nodiscard]] std::string keys(std::size_t k) const {
    Json parts = Json::array();
    for (const PartSide& part : answers_.parts_of(k)) {
      parts.push_back(part_json(part.part));
      parts.back()["side"] = std::string(name(part.side));
    }
    std::string keys =
        ",\"parts\":" + json_text(parts) + coverage_keys(answers_.coverage[k], answers_.costs[k]);
    if (totals().rows == 0) {
      Json open = Json::array();
      for (std::uint32_t part = 0; part < body_.parts().size(); ++part) {
        if (!body_.parts()[part].closed) {
          open.push_back(part_json(part));
          open.back()["odd_edges"] = body_.parts()[part].odd_edges;
        }
      }
      keys += ",\"open_parts\":" + json_text(open);
    }
    return keys;
  }

  void print_totals() override {
    print_left_out();
    console().print(fmt::format("{}: {} in or on {}, {} of them closed\n",
                                counted(totals().rows, "point"), with_commas(held_),
                                counted(body_.parts().size(), "part"),
                                with_commas(body_.parts().size() - body_.open_parts())));
  }

  void finish(End) override { csv_.finish(); }

  PartSideCsv& csv_;
  DividedBody body_;
  ContainsPartsBatch answers_;
  std::map<std::uint32_t, std::optional<Body>> alone_;  // parts that brute force has looked at
  std::uint64_t held_ = 0;
};

}  // namespace

int run_contains_by_part(const ContainsVerbOptions& options, PartSideCsv& csv, Console& console) {
  return PartsRun(options, csv, console).run();
}

}  // namespace soms::command
