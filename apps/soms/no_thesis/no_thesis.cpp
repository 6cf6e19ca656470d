// What a command built without the thesis' wing has in its place: it says how to get it.
#include "soms/base/error.h"

#include "apps/cli/parser.h"
#include "apps/model/models.h"
#include "apps/soms/pairs/traversal_by_name.h"
#include "apps/soms/thesis/thesis_verb.h"

#include <fmt/format.h>

#include <cstdlib>

namespace soms::command {

namespace {

constexpr const char* kRemedy =
    "make build builds all of soms, as does CMake with -D SOMS_BUILD_THESIS=ON";

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::unsupported, what + " is not built into this soms", kRemedy);
}

class NoTraversal final : public TraversalByName {
 public:
  explicit NoTraversal(Parser& parser) {
    for (const char* const key : {"--traversal", "--descent"}) {
      parser
          .add_option_function(
              key, [key](const std::string&) { refuse(fmt::format("{} of the thesis", key)); },
              "not built into this soms: make build")
          ->option_text("NAME")
          ->group(kTreeGroup)
          ->key_of(parser.option("--tree"));
    }
  }

  [[nodiscard]] bool named() const override { return false; }

  [[nodiscard]] std::string text() const override { return {}; }

  void check(const Parser&) const override {}

  [[nodiscard]] CountedAnswer overlap(const Body&, const Body&, const OverlapOptions&,
                                      const Limits&) const override {
    std::abort();  // none is named
  }

  [[nodiscard]] std::vector<CountedAnswer> overlap(const Shape&, std::span<const Pose>, const Body&,
                                                   const OverlapOptions&,
                                                   const Limits&) const override {
    std::abort();
  }

  [[nodiscard]] std::unique_ptr<OverlapMethod> method() const override { return nullptr; }
};

int refuse_thesis(std::string_view, const std::vector<std::string>&) {
  refuse("the verb thesis");
}

}  // namespace

std::shared_ptr<const TraversalByName> add_traversal_by_name(Parser& parser) {
  return std::make_shared<NoTraversal>(parser);
}

Verb thesis_verb() {
  return {
      .name = kThesisVerb, .question = kThesisQuestion, .add = nullptr, .pass_on = refuse_thesis};
}

}  // namespace soms::command
