#include "bench/peers/options.h"

#include "soms/base/error.h"
#include "soms/io/poses.h"

#include "bench/peers/core/machine.h"

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string_view>

namespace soms::bench {

namespace {

constexpr const char* kHelp =
    R"(soms-bench: time soms and its peer libraries on the same queries, in one process.
Usage: soms-bench [OPTIONS]        generated scenes, models and cities
       soms-bench A B [OPTIONS]    two meshes of your own: A moves, B does not

  --quick           a few minutes: fewer rounds, and fewer scenes unless --scenes is given
  --jobs LIST       of any,all,still,broad,distance,within,solid,closest,contains,closest-hit,any-hit
                    (default: all of them)
  --scenes LIST     scenes whose names begin with these, such as twins-knot,city,real
  --sets LIST       sets of poses, points or rays, such as random,near-0.001
  --least N         leave out scenes of fewer than N triangles or boxes (default 0)
  --most N          leave out scenes of more than N (default 5000000)
  --libraries LIST  libraries whose names begin with these, such as soms,fcl
  --rounds N        timed rounds of each library (default 7, quick 3)
  --budget SECONDS  processor time per pass of the best peer (default 0.1, quick 0.03)
  --judge N         triangles that the judge looks at per set, of the mover or around the probes
                    (default 5e6)
  --seed N          seed of the random poses, points and rays (default 1)
  --cpu N           processor to run on (default: the last)
  --data FOLDER     folder of models and cities (default: SOMS_DATA; without it they are left out)
  --out FOLDER      for peers.csv and peers.md (default: bench/results/<machine>_<isa>; with A B:
                    none)
  --list            list the scenes that would run
  --pose POSE       with A B: pose of A, "x y z [qw qx qy qz]", or a CSV file
  --random N        with A B: number of random poses of A around B's box (default 1000)
  --json            with A B: print JSON Lines
  --strict          with A B: treat warnings and notes about a model as errors
  --quiet           print only errors on standard error

Example: soms-bench --quick --scenes twins-knot --most 10000 --out results
)";

template <class Number>
Number number(std::string_view option, std::string_view text, Number least) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= least)) {
    throw Error(ErrorKind::usage, std::string(option) + " " + std::string(text),
                "give a number in the range of this option; see soms-bench --help");
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

std::vector<Job> jobs(const std::string& list) {
  std::vector<Job> chosen;
  for (const std::string& word : split(list)) {
    bool known = false;
    for (const Job job : RunOptions{}.jobs) {
      if (word == name(job)) {
        chosen.push_back(job);
        known = true;
      }
    }
    if (!known) {
      throw Error(ErrorKind::usage, "--jobs " + word,
                  "choose any, all, still, broad, distance, within, solid, closest, contains, "
                  "closest-hit or any-hit");
    }
  }
  return chosen;
}

/// Messages call it by its name.
std::vector<Pose> poses_of_standard_input() {
  constexpr std::string_view kPath = "/dev/stdin";
  try {
    return read_poses(kPath);
  } catch (const Error& error) {
    std::string place = error.place();
    if (place.starts_with(kPath)) {
      place.replace(0, kPath.size(), "standard input");
    }
    throw Error(error.kind(), place, error.remedy());
  }
}

/// Never none: without poses random ones would be queried.
std::vector<Pose> poses(const std::string& text) {
  std::error_code ignored;
  if (text != "-" && !std::filesystem::exists(text, ignored)) {
    return {parse_pose(text)};
  }
  std::vector<Pose> rows = text == "-" ? poses_of_standard_input() : read_poses(text);
  if (rows.empty()) {
    throw Error(ErrorKind::bad_file, (text == "-" ? "standard input" : text) + ": no rows",
                "give at least one pose below the header");
  }
  return rows;
}

/// Options of the run itself; false for another one.
bool set_run(RunOptions& run, std::string_view option, const std::string& value) {
  if (option == "--jobs") {
    run.jobs = jobs(value);
  } else if (option == "--sets") {
    run.sets = split(value);
  } else if (option == "--libraries") {
    run.libraries = split(value);
  } else if (option == "--rounds") {
    run.race.rounds = number<int>(option, value, 1);
  } else if (option == "--budget") {
    run.race.budget = number<double>(option, value, 1e-6);
  } else if (option == "--judge") {
    run.judge = number<double>(option, value, 1);
  } else {
    return false;
  }
  return true;
}

void set(Options& options, std::string_view option, const std::string& value) {
  if (set_run(options.run, option, value)) {
    return;
  }
  if (option == "--scenes") {
    options.scenes = split(value);
  } else if (option == "--least") {
    options.least = number<std::uint64_t>(option, value, 0);
  } else if (option == "--most") {
    options.most = number<std::uint64_t>(option, value, 1);
  } else if (option == "--cpu") {
    options.cpu = number<int>(option, value, 0);
  } else if (option == "--data") {
    options.data = value;
  } else if (option == "--out") {
    options.out = value;
  } else if (option == "--pose") {
    options.poses = poses(value);
  } else if (option == "--random") {
    options.random = number<std::size_t>(option, value, 1);
  } else if (option == "--seed") {
    options.seed = number<std::uint64_t>(option, value, 0);
  } else {
    throw Error(ErrorKind::usage, "unknown option " + std::string(option),
                "soms-bench --help lists them");
  }
}

bool set_flag(Options& options, std::string_view word) {
  if (word == "--quick") {
    options.quick = true;
  } else if (word == "--list") {
    options.list = true;
  } else if (word == "--json") {
    options.json = true;
  } else if (word == "--quiet") {
    options.quiet = true;
  } else if (word == "--strict") {
    options.strict = true;
  } else {
    return false;
  }
  return true;
}

void finish(Options& options) {
  if (!options.files.empty() && options.files.size() != 2) {
    throw Error(ErrorKind::usage, "only one mesh is given",
                "give two meshes, or none to run the built-in scenes");
  }
  if (options.out.empty() && options.files.empty()) {
    options.out = std::filesystem::path("bench") / "results" / machine_folder();
  }
}

}  // namespace

std::optional<Options> parse(int argc, char** argv) {
  Options options;
  const char* folder = std::getenv("SOMS_DATA");
  options.data = folder == nullptr ? "" : folder;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (const std::string& word : words) {
    if (word == "--help" || word == "-h") {
      std::cout << kHelp;
      return std::nullopt;
    }
    if (word == "--quick") {  // first: what is said besides wins
      options.run.race = {.rounds = 3, .budget = 0.03, .least_pass = 0.01};
      options.run.judge = 1e6;
    }
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      options.files.push_back(words[i]);
    } else if (!set_flag(options, words[i])) {
      if (i + 1 == words.size()) {
        throw Error(ErrorKind::usage, words[i] + " needs a value", "soms-bench --help lists them");
      }
      set(options, words[i], words[i + 1]);
      ++i;
    }
  }
  finish(options);
  return options;
}

}  // namespace soms::bench
