#include "apps/soms/probes/contains_winding.h"

#include "soms/query/reference/contains.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/shapes.h"
#include "apps/soms/pairs/near_output.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/pairs/pair_report.h"
#include "apps/soms/probes/side_run.h"
#include "apps/soms/probes/winding_verify.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace soms::command {

namespace {

class WindingRun : public SideRun {
 public:
  WindingRun(const ContainsVerbOptions& options, SideFiles& files, Console& console)
      : SideRun(options, files, console), width_(options.width), index_(index_of(options)) {}

 private:
  [[nodiscard]] WindingIndex index_of(const ContainsVerbOptions& options) {
    Shape shape = load_shape(options.model, options.reading, {.build = options.build}, console());
    return console().run("looking for the boundary", [&](const Parallel& parallel) {
      return WindingIndex(Body(std::move(shape), pose()), parallel);
    });
  }

  std::uint64_t answer_block() override {
    answers_ = winding(index_, block(), {.width = width_, .deadline = console().deadline()},
                       console().parallel());
    return 0;
  }

  [[nodiscard]] const MeshView& mesh() const override { return index_.body().shape.mesh(); }

  [[nodiscard]] Side side(std::size_t k) const override { return answers_.side[k]; }

  [[nodiscard]] bool is_cut(std::size_t k) const override {
    return answers_.coverage[k] == Coverage::cut;
  }

  [[nodiscard]] std::string keys(std::size_t k) const override {
    const Winding answer = answers_.at(k);
    std::string keys = field_keys(answer) + coverage_keys(answer.coverage, answer.cost);
    if (totals().rows == 0) {
      keys += fmt::format(",\"boundary_edges\":{}", index_.boundary_edges());
    }
    return keys;
  }

  void put(std::size_t k, SideFiles& files) const override {
    files.csv.add(totals().rows, answers_.at(k));
    files.columns.add(answers_.at(k));
  }

  [[nodiscard]] std::string column_head() const override {
    return fmt::format("{:<12}  ", "winding");
  }

  [[nodiscard]] std::string column(std::size_t k) const override {
    const Bracket number = answers_.at(k).number;
    const double middle = 0.5 * (number.lower + number.upper);
    return fmt::format("{:<12}  ", side(k) == Side::on ? std::string("-")
                                   : is_cut(k)         ? std::string("?")
                                                       : fmt::format("{:.9g}", middle + 0.0));
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (is_cut(k)) {
      return std::nullopt;
    }
    return console().run("verifying", [&](const Parallel&) -> std::optional<std::string> {
      const Body& body = index_.body();
      const Bracket truth = reference::winding_by_brute_force(body, block()[k]);
      const Bracket number = answers_.at(k).number;
      if (!agrees(number, truth)) {
        return fmt::format(
            "brute force finds a winding number from {} to {}, but the answer is "
            "from {} to {}",
            truth.lower, truth.upper, number.lower, number.upper);
      }
      const bool on = reference::contains_by_brute_force(body, block()[k]) == Side::on;
      return on == (side(k) == Side::on)
                 ? std::nullopt
                 : std::optional(fmt::format("brute force finds the point {} the surface, but the "
                                             "answer is {}",
                                             on ? "on" : "off", name(side(k))));
    });
  }

  double width_;
  WindingIndex index_;
  WindingBatch answers_;
};

}  // namespace

int run_contains_winding(const ContainsVerbOptions& options, SideFiles& files, Console& console) {
  return WindingRun(options, files, console).run();
}

}  // namespace soms::command
