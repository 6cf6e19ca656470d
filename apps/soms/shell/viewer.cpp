#include "apps/soms/shell/viewer.h"

#include "apps/cli/child.h"
#include "apps/cli/parse.h"
#include "apps/model/part_filter.h"

#include <fmt/format.h>

#include <cstddef>

namespace soms::command {

namespace {

/// Movers of a simulation that names none; soms-view shows a city from files without movers.
constexpr const char* kMovers = "1000";

void add_model_words(std::vector<std::string>& words, const ModelOptions& model,
                     const std::string& scale, const std::string& up) {
  if (model.scale_is_given) {
    words.insert(words.end(), {scale, fmt::format("{}", model.scale)});
  }
  constexpr const char* kAxes[] = {"", "x", "y", "z"};
  if (model.up != UpAxis::unknown) {
    words.insert(words.end(), {up, kAxes[static_cast<std::size_t>(model.up)]});
  }
}

}  // namespace

std::vector<std::string> words_of(const WorldOptions& world, const Shared& shared) {
  std::vector<std::string> words;
  const auto add_all = [&](const std::string& name, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
      words.insert(words.end(), {name, value});
    }
  };
  add_all("--mover", world.movers);
  add_all("--route", world.routes);
  if (world.count) {
    words.insert(words.end(), {"--count", std::to_string(*world.count)});
  } else if (world.routes.empty()) {
    words.insert(words.end(), {"--count", kMovers});
  }
  add_model_words(words, world.city_model, "--scale", "--up");
  add_model_words(words, world.mover_model, "--mover-scale", "--mover-up");
  if (world.city_model.strict) {
    words.emplace_back("--strict");
  }
  if (const PartFilter* const parts = world.city_model.parts.get()) {
    for (const bool only : {true, false}) {
      for (const std::string& pattern : parts->patterns(only)) {
        words.push_back((only ? "--only=" : "--ignore=") + pattern);
      }
    }
  }
  words.insert(words.end(), {"--seed", std::to_string(shared.seed)});
  words.insert(words.end(), {"--threads", std::to_string(shared.threads)});
  if (shared.max_memory != 0) {
    words.insert(words.end(), {"--max-memory", std::to_string(shared.max_memory)});
  }
  if (shared.quiet) {
    words.emplace_back("--quiet");
  }
  for (const std::string& city : world.cities) {
    words.push_back(as_argument(city));
  }
  return words;
}

int show_world(const WorldOptions& world, const std::vector<std::string>& more,
               const Console& console) {
  std::vector<std::string> words{"view"};
  words.insert(words.end(), more.begin(), more.end());
  const std::vector<std::string> rest = words_of(world, console.shared());
  words.insert(words.end(), rest.begin(), rest.end());
  return run_child(viewer_program(), words, console, {.called = "soms"});
}

int draw_frame(const std::filesystem::path& recording, std::uint64_t frame,
               const std::string& picture, const Console& console) {
  return run_child(viewer_program(),
                   {"render", "--quiet", "--frame", std::to_string(frame), "--output", picture,
                    as_argument(recording.string())},
                   console, {.called = "soms", .timed = false});
}

}  // namespace soms::command
