#include "apps/soms/probes/contains_winding.h"

#include "soms/query/reference/contains.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/shapes.h"
#include "apps/soms/probes/side_question.h"
#include "apps/soms/probes/winding_verify.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace soms::command {

namespace {

class WindingQuestion : public SideQuestion<Winding> {
 public:
  WindingQuestion(const ContainsVerbOptions& options, const ProbeRows<PointSource>& rows,
                  const Pose& pose, const Console& console)
      : SideQuestion(rows),
        console_(console),
        width_(options.width),
        index_(index_of(options, pose)),
        report_(options, index_.body().shape.mesh()) {}

  std::uint64_t answer(const ShowProgress&) override {
    set(winding(index_, points(), {.width = width_}, console_.limits()));
    return 0;
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Winding answer = at(k);
    if (answer.coverage == Coverage::cut) {
      return std::nullopt;
    }
    return console_.run("verifying", [&](const Limits&) -> std::optional<std::string> {
      const Body& body = index_.body();
      const Bracket truth = reference::winding_by_brute_force(body, point(k));
      if (!agrees(answer.number, truth)) {
        return fmt::format(
            "brute force finds a winding number from {} to {}, but the answer is "
            "from {} to {}",
            truth.lower, truth.upper, answer.number.lower, answer.number.upper);
      }
      const bool on = reference::contains_by_brute_force(body, point(k)) == Side::on;
      return on == (answer.side == Side::on)
                 ? std::nullopt
                 : std::optional(fmt::format("brute force finds the point {} the surface, but the "
                                             "answer is {}",
                                             on ? "on" : "off", name(answer.side)));
    });
  }

 private:
  [[nodiscard]] WindingIndex index_of(const ContainsVerbOptions& options, const Pose& pose) const {
    Shape shape =
        load_only_model(options.model, options.reading, {.build = options.build}, console_).shape;
    return console_.run("looking for the boundary", [&](const Limits& limits) {
      return WindingIndex(Body(std::move(shape), pose), limits);
    });
  }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return (row.number == 0 ? fmt::format(",\"boundary_edges\":{}", index_.boundary_edges())
                            : std::string()) +
           report_.keys(row);
  }

  [[nodiscard]] std::string column_head() const override {
    return fmt::format("{:<12}  ", "winding");
  }

  [[nodiscard]] std::string column(const Winding& answer) const override {
    const double middle = 0.5 * (answer.number.lower + answer.number.upper);
    return fmt::format("{:<12}  ", answer.side == Side::on ? std::string("-")
                                   : answer.coverage == Coverage::cut
                                       ? std::string("?")
                                       : fmt::format("{:.9g}", middle + 0.0));
  }

  const Console& console_;
  double width_;
  WindingIndex index_;
  ProbeReport report_;
};

}  // namespace

int run_contains_winding(const ContainsVerbOptions& options, Console& console) {
  return run_probes<PointSource>(options, options.points, {.verb = "contains"}, console,
                                 [&](const auto& rows, const Pose& pose) {
                                   return WindingQuestion(options, rows, pose, console);
                                 });
}

}  // namespace soms::command
