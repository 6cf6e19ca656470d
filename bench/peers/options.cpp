#include "bench/peers/options.h"

#include "soms/base/error.h"

#include <charconv>
#include <iostream>
#include <sstream>
#include <string_view>

namespace soms::bench {

namespace {

constexpr const char* kHelp = R"(peers: soms and its rivals, asked the same in one process.

  --scenes LIST   of city-car,city-drone,streets,knot (default: all)
  --most N        leave out scenes of more than N triangles (default 1000000)
  --passes N      timed passes of each contestant (default 7)
  --judge N       triangle pairs that brute force may look at in a set (default 2e9)
  --city FILE     with --mover FILE: these models instead of the scenes
  --mover FILE
  --out PREFIX    writes PREFIX.csv and PREFIX.md (default peers)

Example: taskset -c 1 peers --scenes city-car --out results/peers
)";

template <class Number>
Number number(std::string_view option, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0)) {
    throw Error(ErrorKind::usage, std::string(option) + " " + std::string(text),
                "give a positive number");
  }
  return value;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) {
    words.push_back(word);
  }
  return words;
}

void set(Options& options, std::string_view option, const std::string& value) {
  if (option == "--scenes") {
    options.scenes = split(value);
  } else if (option == "--most") {
    options.most = number<std::uint64_t>(option, value);
  } else if (option == "--passes") {
    options.passes = number<int>(option, value);
  } else if (option == "--judge") {
    options.judge = number<double>(option, value);
  } else if (option == "--city") {
    options.city = value;
  } else if (option == "--mover") {
    options.mover = value;
  } else if (option == "--out") {
    options.out = value;
  } else {
    throw Error(ErrorKind::usage, std::string(option), "peers --help lists the options");
  }
}

}  // namespace

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--help") {
      std::cout << kHelp;
      return std::nullopt;
    }
    if (i + 1 == argc) {
      throw Error(ErrorKind::usage, option, "give it a value");
    }
    set(options, option, argv[i + 1]);
  }
  if (options.city.empty() != options.mover.empty()) {
    throw Error(ErrorKind::usage, "--city and --mover", "give both or neither");
  }
  return options;
}

}  // namespace soms::bench
