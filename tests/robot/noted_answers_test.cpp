// Contradictions that can change no answer (decision 0077), put into the files of every robot that
// tests have: links, joints and answers stay the same, and exactly the notes of them are added.
#include "soms/io/print.h"
#include "soms/io/robot.h"
#include "soms/kinematics/print.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms {
namespace {

constexpr int kRandomStates = 4;

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::size_t line_of(const std::string& text, std::size_t at) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

/// Entries of a kind, of which a note tells how many there are, and where the first is.
struct ExpectedNote {
  std::string_view what;
  std::size_t count = 0;
  std::size_t line = 0;  ///< of the first

  void add(std::size_t at) { line = count++ == 0 ? at : line; }

  void add_to(std::vector<std::string>& notes, const std::string& file) const {
    if (count > 0) {
      notes.push_back(file + std::string(what) + ": " + std::to_string(count) +
                      (count > 1 ? ", the first in line " : ", in line ") + std::to_string(line));
    }
  }
};

/// The text of a robot with `<mimic>` in some of its fixed joints.
struct MimickedText {
  std::string text;
  ExpectedNote note{"<mimic> of fixed joints"};

  MimickedText(const std::string& plain, Rng* rng) {
    std::size_t at = 0;
    for (std::size_t begin = plain.find("<joint "); begin != std::string::npos;
         begin = plain.find("<joint ", at)) {
      const std::size_t end = plain.find("</joint>", begin);
      text += plain.substr(at, end - at);
      at = end;
      const std::string joint = plain.substr(begin, end - begin);
      if (joint.substr(0, joint.find('>')).find(R"(type="fixed")") == std::string::npos) {
        continue;
      }
      if (const std::size_t own = joint.find("<mimic"); own != std::string::npos) {
        note.add(line_of(plain, begin + own));
      } else if (rng != nullptr && rng->below(2) == 0) {
        note.add(line_of(plain, end));
        text += rng->below(2) == 0 ? R"(<mimic joint="no such"/>)" : "<mimic/>";
      }
    }
    text += plain.substr(at);
  }
};

/// The text of an SRDF file with entries of links and joints that are not there before its end.
struct ContradictedText {
  std::string text;
  ExpectedNote links{"entries of links that the robot does not have"};
  ExpectedNote pairs{"pairs of a link with itself"};
  ExpectedNote joints{"values of joints that the robot does not have"};
  std::vector<NamedState> states = {};  ///< that are added

  ContradictedText(const std::string& plain, const Robot& robot, Rng& rng) {
    const std::string& link = robot.links[rng.below(robot.links.size())].name;
    const std::array<std::string, 7> entries{
        R"(<disable_default_collisions link="no such"/>)",
        "<enable_collisions link1=\"" + link + R"(" link2="no such"/>)",
        "<enable_collisions link1=\"" + link + "\" link2=\"" + link + "\"/>",
        R"(<disable_collisions link1="no such" link2="nor such" reason="Never"/>)",
        "<disable_collisions link1=\"no such\" link2=\"" + link + "\"/>",
        "<disable_collisions link1=\"" + link + "\" link2=\"" + link + "\"/>",
        R"(<group_state name="NAME"><joint name="no such" value="1 2 3"/></group_state>)"};
    const std::size_t end = plain.rfind("</robot>");
    std::string more;
    std::vector<std::size_t> added;  // in the order of the file
    for (std::uint64_t count = rng.below(6); count > 0; --count) {
      added.push_back(rng.below(entries.size()));
      std::string entry = entries[added.back()];
      if (added.back() + 1 == entries.size()) {
        const std::string name = "added " + std::to_string(added.size());
        entry.replace(entry.find("NAME"), 4, name);
        states.push_back({.name = name, .unknown = {"no such"}});
      }
      more += entry + "\n";
    }
    text = plain.substr(0, end) + more + plain.substr(end);
    // Defaults are read first, then what is enabled, then what is disabled.
    for (const auto& kinds : {std::vector<std::size_t>{0}, {1, 2}, {3, 4, 5}, {6}}) {
      for (std::size_t k = 0; k < added.size(); ++k) {
        if (std::find(kinds.begin(), kinds.end(), added[k]) != kinds.end()) {
          ExpectedNote& note = added[k] == 6                    ? joints
                               : added[k] == 2 || added[k] == 5 ? pairs
                                                                : links;
          note.add(line_of(plain, end) + k);
        }
      }
    }
  }
};

std::span<const std::byte> bytes_of_text(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// A robot of two texts, which are changed in memory.
class RobotOfTexts {
 public:
  /// Without `srdf`, one that says nothing. Meshes are found by whole paths and packages.
  RobotOfTexts(std::string urdf, std::string srdf, RobotReadOptions options = {})
      : options_(std::move(options)), urdf_(std::move(urdf)), srdf_(std::move(srdf)) {
    if (srdf_.empty()) {
      const Robot robot = read_robot(bytes_of_text(urdf_), "robot.urdf", options_);
      srdf_ = "<robot name=\"" + robot.name + "\">\n</robot>\n";
    }
    plain_ = read(urdf_, srdf_);
    Rng rng(5);
    const Kinematics kinematics(plain_);
    for (int k = 0; k < kRandomStates; ++k) {
      for (const double value : random_state(kinematics, rng)) {
        states_.push_back(value);
      }
    }
    answers_ = answers_of(plain_);
  }

  /// Puts contradictions into both texts; how many.
  std::size_t expect_the_same(Rng& rng, bool answer) const {
    const MimickedText urdf(urdf_, &rng);
    const ContradictedText srdf(srdf_, plain_, rng);
    const Robot robot = read(urdf.text, srdf.text);
    SCOPED_TRACE(srdf.text.substr(srdf.text.size() - std::min<std::size_t>(srdf.text.size(), 900)));
    Robot expected = plain_;
    expected.states.insert(expected.states.end(), srdf.states.begin(), srdf.states.end());
    std::vector<std::string> without;
    MimickedText(urdf_, nullptr).note.add_to(without, "");
    std::erase_if(expected.notes, [&](const std::string& note) {
      return std::find(without.begin(), without.end(), note) != without.end();
    });
    urdf.note.add_to(expected.notes, "");
    for (const ExpectedNote* const note : {&srdf.links, &srdf.pairs, &srdf.joints}) {
      note->add_to(expected.notes, "robot.srdf: ");
    }
    EXPECT_EQ(robot.notes, expected.notes);
    EXPECT_TRUE(robot == expected);
    if (answer) {
      EXPECT_EQ(answers_of(robot), answers_);
    }
    return urdf.note.count + srdf.links.count + srdf.pairs.count + srdf.joints.count;
  }

 private:
  [[nodiscard]] Robot read(const std::string& urdf, const std::string& srdf) const {
    Robot robot = read_robot(bytes_of_text(urdf), "robot.urdf", options_);
    read_semantics(robot, bytes_of_text(srdf), "robot.srdf", options_);
    return robot;
  }

  [[nodiscard]] std::vector<RobotAnswer> answers_of(const Robot& robot) const {
    std::vector<RobotAnswer> answers =
        robot_contacts(RobotModel(robot), states_, {.distance = true});
    for (RobotAnswer& answer : answers) {
      answer.cost = {};
    }
    return answers;
  }

  RobotReadOptions options_;
  std::string urdf_;
  std::string srdf_;
  Robot plain_;
  std::vector<double> states_;
  std::vector<RobotAnswer> answers_;
};

/// One in `every` of the changed robots also answers.
void expect_noted(const RobotOfTexts& robot, const std::string& name, int cases,
                  std::uint64_t every) {
  std::size_t contradictions = 0;
  int seen = 0;
  test::for_each_case("noted answers of " + name, cases, [&](Rng& rng) {
    contradictions += robot.expect_the_same(rng, rng.below(every) == 0);
    ++seen;
  });
  EXPECT_GE(seen, cases) << name;
  EXPECT_GT(contradictions, static_cast<std::size_t>(cases)) << name;
}

/// The text of a robot of tests/data, which names its meshes by whole paths.
std::string our_robot(const std::filesystem::path& urdf) {
  std::string text = text_of_file(urdf);
  const std::string named = "<mesh filename=\"";
  for (std::size_t at = text.find(named); at != std::string::npos; at = text.find(named, at + 1)) {
    text.insert(at + named.size(), urdf.parent_path().string() + "/");
  }
  return text;
}

TEST(NotedAnswers, OfOurRobotsStayTheSame) {
  std::size_t robots = 0;
  for (const char* const folder : {"robots/", "robots/noted/", "bodies/"}) {
    std::set<std::filesystem::path> files;
    for (const auto& file : std::filesystem::directory_iterator(test::data(folder))) {
      files.insert(file.path());
    }
    for (const std::filesystem::path& file : files) {
      if (file.extension() != ".urdf") {
        continue;
      }
      SCOPED_TRACE(file);
      const std::string name = file.stem().string();
      const std::filesystem::path srdf =
          file.parent_path() / (name == "floating_srdf" ? "floating_vj.srdf" : name + ".srdf");
      const RobotOfTexts robot(our_robot(file),
                               std::filesystem::exists(srdf) ? text_of_file(srdf) : "");
      expect_noted(robot, name, 200, 1);
      ++robots;
    }
  }
  EXPECT_GE(robots, 9U);
}

TEST(NotedAnswers, OfThePandaStayTheSame) {
  SOMS_NEEDS_OUTSIDE_DATA("200 variations of the Panda arm");
  const std::filesystem::path folder = *test::outside_data("robots");
  const RobotOfTexts panda(
      text_of_file(folder / "panda_description/urdf/panda.urdf"),
      text_of_file(folder / "panda_moveit_config/config/panda.srdf"),
      {.packages = {{"moveit_resources_panda_description", folder / "panda_description"}}});
  expect_noted(panda, "panda", 200, 10);
}

}  // namespace
}  // namespace soms
