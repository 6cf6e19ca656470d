#include "soms/base/text.h"

#include "tests/commands/fins.h"
#include "tests/commands/run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace soms {

namespace {

/// What a terminal would obey: a window's title, a color, one byte that is a command, and no UTF-8.
const std::string kHostile =
    "x\x1b]0;owned\x07\x1b[31m\x9b\xc2\x9b"
    "2J\xff";

/// The first part of `text` that is not fit for a terminal, or nothing.
std::string unfit(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = utf8_character(text, at);
    const std::string_view character = std::string_view(text).substr(at, size);
    if (character != "\n" && (size == 0 || printable(character) != character)) {
      return printable(text.substr(at < 40 ? 0 : at - 40, 80));
    }
    at += size;
  }
  return {};
}

class Names : public ::testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  /// A model whose file and parts have names that should not be obeyed.
  std::string hostile(const std::string& suffix) {
    std::string path = at(kHostile + suffix);
    test::write_text(path, test::fins_obj(kHostile, 2, 2, true));
    return path;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Names, ReachNoTerminalAsCommands) {
  const std::string a = hostile(".obj");
  const std::string b = at("b" + kHostile + ".obj");
  test::write_text(b, test::fins_obj(kHostile + "b", 2, 2, false));
  const std::string none = at(kHostile + ".ply");
  const std::string bad = at("bad" + kHostile + ".ply");
  test::write_text(bad, "ply\nformat " + kHostile + " 1.0\nelement " + kHostile + "\n");
  const std::string rows = at(kHostile + ".csv");
  test::write_text(rows, "x,y,z\n0,0," + kHostile + "\n");
  const std::vector<std::vector<std::string>> lines{
      {"info", a, "--list", "all"},
      {"info", a, "--json"},
      {"info", none},
      {"info", bad},
      {"info", a, "--" + kHostile},
      {"overlap", a, b},
      {"overlap", a, b, "--first"},
      {"overlap", a, b, "--by", "part", "--verify"},
      {"overlap", a, b, "--by", "part", "--json"},
      {"overlap", a, b, "-o", at(kHostile + ".html")},
      {"overlap", a, b, "--pose", rows},
      {"overlap", a, b, "--pose", kHostile},
      {"overlap", a, none},
      {"overlap", a, b, "-o", at(kHostile + "/no.csv")},
      {"overlap", a, b, "-o", at("no." + kHostile)},
      {"convert", a, at(kHostile + ".stl")},
      {"convert", a, at(kHostile + ".ply"), "--json"},
      {"convert", a, at("a." + kHostile)},
      {"generate", "sphere", "--triangles", "20", "-o", at(kHostile + ".off")},
      {"generate", kHostile, "-o", at("g.off")},
      {"simulate", a, "--count", "2", "--frames", "3", "-o", at(kHostile + "e.csv")},
      {"simulate", a, "--count", "2", "--frames", "3", "--json"},
      {"simulate", "--mover", none},
      {"simulate", a, "--route", rows},
      {"bench", a, none},
      {"bench", a, b, "--" + kHostile},
      {"render", none, "-o", at("r.png")},
      {"view", none},
      {"reproduce", "--item", kHostile, "-o", at("out")},
      {"reproduce", "--item", "5.3", "-o", at("in/" + kHostile + ".ply/out")},
      {kHostile},
      {"help", kHostile},
      {"completion", kHostile},
      {"man", kHostile}};
  for (const std::vector<std::string>& words : lines) {
    std::string line;
    for (const std::string& word : words) {
      line += printable(word) + " ";
    }
    const test::RunResult run = test::soms_run(words);
    EXPECT_LT(run.status, 128) << line;
    EXPECT_EQ(unfit(run.out), "") << line;
    EXPECT_EQ(unfit(run.err), "") << line;
  }
}

/// The fields of a CSV file's rows, without quotes, as a reader returns them.
std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"' && quoted && k + 1 < text.size() && text[k + 1] == '"') {
      rows.back().back() += text[++k];
    } else if (text[k] == '"') {
      quoted = !quoted;
    } else if (text[k] == ',' && !quoted) {
      rows.back().emplace_back();
    } else if (text[k] == '\n' && !quoted) {
      rows.emplace_back(1);
    } else {
      rows.back().back() += text[k];
    }
  }
  rows.pop_back();
  return rows;
}

TEST_F(Names, R120AreNoFormulasInCsv) {
  for (const std::string& name : std::vector<std::string>{"=1+1", "+1", "-1", "@SUM(A1)",
                                                          "=cmd|' /C calc'!A0", "a,\"b\"", "'=1"}) {
    // The city's file and its part have the name; so has what moves.
    test::write_text(at("city.obj"),
                     "v -90 -90 0\nv 90 -90 0\nv 0 90 0\no " + name +
                         "\nf 1 2 3\nv -9 0 0\nv 9 0 0\nv 0 0 50\no wall\nf 4 5 6\n");
    const std::string city = at(name[0] == '=' ? "=city.obj" : "town.obj");
    test::write_text(city, test::read_text(at("city.obj")));
    const test::RunResult run =
        test::soms_run({"overlap", city, at("city.obj"), "--by", "part", "-o", at("o.csv")});
    ASSERT_EQ(run.status, 0) << run.err;
    bool found = false;
    for (const std::vector<std::string>& row : csv_rows(test::read_text(at("o.csv")))) {
      ASSERT_EQ(row.size(), 19U);
      EXPECT_EQ(std::string_view("=+-@\t\r").find(row[2].front()), std::string_view::npos)
          << row[2];
      found = found || csv_words(row[2]) == name;
    }
    EXPECT_TRUE(found) << name;
  }
}

TEST_F(Names, R120OfEventsAreNoFormulas) {
  const std::string city = at("=city.obj");
  std::string text =
      "v -90 -90 0\nv 90 -90 0\nv 90 90 0\nv -90 90 0\no ground\nf 1 2 3\nf 1 3 4\no =1+1\n";
  for (int k = -3; k < 4; ++k) {
    text += fmt::format("v {0} -90 -1\nv {0} 90 -1\nv {0} 0 900\nf -3 -2 -1\n", 20 * k);
  }
  test::write_text(city, text);
  const std::string car = at("=car.ply");
  ASSERT_EQ(test::soms_run({"generate", "car", "-o", car, "--quiet"}).status, 0);
  ASSERT_EQ(test::soms_run({"simulate", city, "--mover", car, "--count", "8", "--frames", "400",
                            "--contacts", at("events.csv"), "--quiet"})
                .status,
            0);
  std::size_t of_wall = 0;
  const auto rows = csv_rows(test::read_text(at("events.csv")));
  ASSERT_GT(rows.size(), 1U);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    ASSERT_EQ(rows[k].size(), 8U);
    EXPECT_EQ(rows[k][1], "'=car");
    if (!rows[k][2].starts_with("mover ")) {
      EXPECT_EQ(rows[k][2], "'=city");
      of_wall += rows[k][3] == "'=1+1" ? 1U : 0U;
    }
  }
  EXPECT_GT(of_wall, 0U);
}

}  // namespace

}  // namespace soms
