#include "tests/commands/run.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {
namespace {

/// A box as OBJ, an object with a name.
std::string box_obj(const std::string& name, int first, const std::vector<double>& low,
                    const std::vector<double>& high) {
  std::ostringstream out;
  out << "o " << name << "\n";
  for (int k = 0; k < 8; ++k) {
    out << "v " << ((k & 1) != 0 ? high[0] : low[0]) << ' ' << ((k & 2) != 0 ? high[1] : low[1])
        << ' ' << ((k & 4) != 0 ? high[2] : low[2]) << "\n";
  }
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    out << "f " << first + a << ' ' << first + b << ' ' << first + c << ' ' << first + d << "\n";
  }
  return out.str();
}

/// A street: a road below, a house on the left whose wall is at y = 2, a sign that hangs at x = 10.
class Street {
 public:
  Street() {
    write_text(file("street.obj"), box_obj("house 7", 1, {3, 2, 0}, {8, 6, 5}) +
                                       box_obj("sign", 9, {10, -1, 1.5}, {10.1, 1, 3}) +
                                       box_obj("road", 17, {-5, -4, -1}, {25, 4, 0}));
    write_text(file("van.obj"), box_obj("van", 1, {-2, -1, 0}, {2, 1, 2}));
    write_text(file("low.obj"), box_obj("low", 1, {-2, -1, 0}, {2, 1, 1}));
    write_text(file("tall.obj"), box_obj("tall", 1, {-1, -2, 0}, {1, 2, 1}));
    write_text(file("path.csv"), "x,y,z\n0,0,0.1\n20,0,0.1\n");
  }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] RunResult run(std::vector<std::string> more, const std::string& profile = "van.obj",
                              const std::string& path = "path.csv") const {
    std::vector<std::string> words{"clearance",   file("street.obj"), "--profile",
                                   file(profile), "--path",           file(path)};
    words.insert(words.end(), more.begin(), more.end());
    return soms_run(std::move(words));
  }

 private:
  TemporaryFolder folder_;
};

/// The objects of the stations, and the last one.
std::pair<std::vector<Json>, Json> stations_of(const RunResult& result) {
  std::vector<Json> lines = json_lines(result.out);
  if (lines.empty()) {
    return {};
  }
  Json totals = lines.back();
  lines.pop_back();
  return {lines, totals};
}

TEST(ClearanceVerb, NamesTheRowOfACoordinateThatIsTooLarge) {
  const Street street;
  const std::string path = street.file("far.csv");
  for (const char* const rows :
       {"x,y,z\n0,0,0\n1e300,0,0\n", "x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,-1e91,1,0,0,0\n"}) {
    write_text(path, rows);
    for (const RunResult& result :
         {street.run({}, "van.obj", "far.csv"),
          soms_run({"simulate", street.file("street.obj"), "--mover", street.file("van.obj"),
                    "--route", path, "--frames", "1"})}) {
      EXPECT_EQ(result.status, 3) << result.out;
      EXPECT_NE(result.err.find(path + ", line 3: a coordinate exceeds 2^300"), std::string::npos)
          << result.err;
    }
  }
}

TEST(ClearanceVerb, AnswersInTheSchema) {
  const Street street;
  const RunResult result = street.run(
      {"--ignore", "road", "--every", "2", "--clearance", "1.5", "--verify", "--json"}, "low.obj");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto [stations, totals] = stations_of(result);
  ASSERT_EQ(stations.size(), 11U);
  const Json& first = stations[0];
  EXPECT_EQ(first.at("schema"), "soms.clearance/1");
  EXPECT_EQ(first.at("station"), 0);
  EXPECT_EQ(first.at("chainage"), 0);
  EXPECT_EQ(first.at("row"), 0);
  EXPECT_EQ(first.at("at"), Json::array({0, 0, 0.1}));
  EXPECT_TRUE(stations[1].at("row").is_null());
  EXPECT_EQ(stations[10].at("row"), 1);
  EXPECT_TRUE(stations[10].at("to_next").is_null());
  // Beside the house: its wall is 1 away. Its triangles are the first of the file.
  const Json& beside = stations[2];
  EXPECT_EQ(beside.at("lower"), 1.0);
  EXPECT_EQ(beside.at("nearest").at("part"), "house 7");
  EXPECT_EQ(beside.at("nearest").at("file"), street.file("street.obj"));
  EXPECT_LT(beside.at("triangles")[1], 12);
  EXPECT_EQ(beside.at("verdict"), "below");
  EXPECT_EQ(beside.at("to_next").at("verdict"), "below");
  EXPECT_EQ(totals.at("verdict"), "below");
  EXPECT_EQ(totals.at("stations"), 11);
  EXPECT_EQ(totals.at("length"), 20.0);
  EXPECT_EQ(totals.at("verified"), true);
  EXPECT_EQ(totals.at("coverage"), "complete");
  EXPECT_TRUE(totals.at("first_contact").is_null());
  // The sign is 0.4 above the profile, and nearer than the wall.
  EXPECT_NEAR(totals.at("least").at("lower"), 0.4, 1e-12);
  EXPECT_EQ(totals.at("least").at("nearest").at("part"), "sign");
  EXPECT_GT(totals.at("at_least"), 0.38);
}

TEST(ClearanceVerb, FindsTheFirstContactBetweenStations) {
  const Street street;
  const RunResult result = street.run({"--ignore", "road", "--every", "20", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto [stations, totals] = stations_of(result);
  ASSERT_EQ(stations.size(), 2U);
  EXPECT_EQ(stations[0].at("verdict"), "ok");
  EXPECT_EQ(stations[1].at("verdict"), "ok");
  EXPECT_EQ(stations[0].at("to_next").at("verdict"), "contact");
  const Json& contact = totals.at("first_contact");
  EXPECT_LE(contact.at("free_until"), 8.0);
  EXPECT_GE(contact.at("free_until"), 7.97);
  EXPECT_GE(contact.at("chainage"), 8.0);
  EXPECT_LE(contact.at("chainage"), 8.03);
  EXPECT_EQ(contact.at("nearest").at("part"), "sign");
}

TEST(ClearanceVerb, TextSaysWhereAndWhat) {
  const Street street;
  const RunResult result = street.run({"--ignore", "road", "--clearance", "1.5"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("house 7 of street"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("first contact    at chainage 8."), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("verdict          contact: contact from"), std::string::npos)
      << result.out;
  EXPECT_NE(result.err.find("--ignore leaves 24 of 36 triangles"), std::string::npos) << result.err;
}

TEST(ClearanceVerb, TheExitStatusIsThatOfTheCondition) {
  const Street street;
  EXPECT_EQ(street.run({"--ignore", "road", "--fail-if", "contact"}).status, 1);
  const std::vector<std::string> low{"--ignore", "road", "--clearance"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> words = low;
    words.insert(words.end(), more.begin(), more.end());
    return street.run(words, "low.obj").status;
  };
  EXPECT_EQ(with({"0.3", "--fail-if", "contact"}), 0);
  EXPECT_EQ(with({"0.3", "--fail-if", "below"}), 0);
  EXPECT_EQ(with({"0.5", "--fail-if", "below"}), 1);
  EXPECT_EQ(with({"0.5", "--fail-if", "contact"}), 0);
  // Just what there is, to the last bit or so: neither is proved.
  EXPECT_EQ(
      street.run({"--ignore", "road", "--ignore", "sign", "--clearance", "1", "--fail-if", "below"})
          .status,
      4);
}

// A vehicle that is modeled along y is moved along its length by --forward alone.
TEST(ClearanceVerb, ForwardNamesTheAxisThatHeadsAlong) {
  const Street street;
  const RunResult across = street.run({"--ignore", "road", "--json"}, "tall.obj");
  EXPECT_NE(across.err.find("--forward"), std::string::npos) << across.err;
  EXPECT_EQ(stations_of(across).second.at("verdict"), "contact");
  for (const std::string axis : {"y", "-y"}) {
    const RunResult along =
        street.run({"--ignore", "road", "--forward", axis, "--json"}, "tall.obj");
    ASSERT_EQ(along.status, 0) << along.err;
    EXPECT_EQ(along.err.find("--forward"), std::string::npos) << along.err;
    EXPECT_EQ(stations_of(along).second.at("verdict"), "ok");
    EXPECT_NEAR(stations_of(along).second.at("least").at("lower"), 0.4, 1e-12);
  }
}

// A corner of the profile sweeps where neither line leads; and back along the line, it turns left.
TEST(ClearanceVerb, ACornerIsATurnOnTheSpot) {
  const Street street;
  write_text(street.file("corner.csv"), "x,y,z\n-20,-20,0\n-20,-8,0\n-20,-20,0\n");
  const RunResult result = street.run({"--json", "--every", "50"}, "van.obj", "corner.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto [stations, totals] = stations_of(result);
  // Start, end of the line, a quarter turn, the half turn, end.
  ASSERT_EQ(stations.size(), 5U);
  EXPECT_EQ(stations[1].at("chainage"), stations[3].at("chainage"));
  EXPECT_EQ(stations[1].at("at"), stations[2].at("at"));
  EXPECT_EQ(totals.at("length"), 24.0);
}

TEST(ClearanceVerb, PosesAreTakenAsTheyAre) {
  const Street street;
  write_text(street.file("poses.csv"),
             "x,y,z,qw,qx,qy,qz\n0,0,0.1,1,0,0,0\n4,0,0.1,1,0,0,0\n"
             "4,0,0.1,0.7071067811865476,0,0,0.7071067811865476\n");
  const RunResult result =
      street.run({"--ignore", "road", "--every", "4", "--json"}, "van.obj", "poses.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto [stations, totals] = stations_of(result);
  ASSERT_EQ(stations.size(), 3U);
  EXPECT_EQ(stations[1].at("lower"), 1.0);
  EXPECT_EQ(stations[2].at("row"), 2);
  EXPECT_EQ(stations[2].at("verdict"), "contact");
}

TEST(ClearanceVerb, WritesTablesMapAndPage) {
  const Street street;
  const RunResult result =
      street.run({"--ignore", "road", "--clearance", "1.2", "-o", street.file("s.csv"), "-o",
                  street.file("s.jsonl"), "-o", street.file("m.svg"), "-o", street.file("r.html")});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = read_csv(street.file("s.csv"));
  const auto text = [&](const std::string& name) {
    std::ifstream file(street.file(name));
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::vector<Json> lines = json_lines(text("s.jsonl"));
  ASSERT_EQ(rows.size(), lines.size());  // a header, and a line over all
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), rows[0].size());
  }
  EXPECT_EQ(rows[0][0], "station");
  EXPECT_EQ(rows[1][8], "ok");
  EXPECT_NE(text("m.svg").find("first contact"), std::string::npos);
  EXPECT_NE(text("m.svg").find("below 1.2"), std::string::npos);
  EXPECT_NE(text("r.html").find("Gap along the path"), std::string::npos);
  EXPECT_NE(text("r.html").find("Nearest stations"), std::string::npos);
}

TEST(ClearanceVerb, RefusesWhatMakesNoSense) {
  const Street street;
  const auto status_and = [&](std::vector<std::string> more, const std::string& words) {
    const RunResult result = street.run(std::move(more));
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    return result.status;
  };
  EXPECT_EQ(status_and({"--fail-if", "below"}, "--clearance"), 2);
  EXPECT_EQ(status_and({"--every", "0"}, "--every"), 2);
  EXPECT_EQ(status_and({"--every", "1e-9"}, "1,000,000 stations"), 2);
  EXPECT_EQ(status_and({"--ignore", "raod"}, "--ignore raod: no part fits"), 2);
  EXPECT_EQ(status_and({"--ignore", "*"}, "leaves nothing"), 2);
  EXPECT_EQ(status_and({"-o", street.file("a.txt")}, ".csv"), 2);
  EXPECT_EQ(status_and({"-o", street.file("path.csv")}, "path.csv"), 2);
  EXPECT_EQ(
      status_and({"-o", street.file("a.csv"), "-o", street.file("b.csv")}, "one file of each"), 2);
  EXPECT_EQ(soms_run({"clearance", street.file("street.obj")}).status, 2);
  write_text(street.file("bad.csv"), "x,y,z\n0,0,0\n1,nan,0\n");
  const RunResult bad = street.run({}, "van.obj", "bad.csv");
  EXPECT_EQ(bad.status, 3);
  EXPECT_NE(bad.err.find("bad.csv, line 3"), std::string::npos) << bad.err;
  EXPECT_EQ(street.run({}, "van.obj", "none.csv").status, 3);
}

TEST(ClearanceVerb, CtrlCKeepsWhatIsDone) {
  const Street street;
  TemporaryFolder folder;
  Child child({command().string(), "clearance", street.file("street.obj"), "--profile",
               street.file("van.obj"), "--path", street.file("path.csv"), "--ignore", "road",
               "--every", "0.0001", "--accuracy", "1e-12", "--json", "--threads", "1"},
              folder.path());
  ASSERT_TRUE(child.wait_for_interrupts());
  child.send_until_it_ends(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const std::vector<Json> lines = json_lines(result.out);
  if (!lines.empty()) {  // a signal during the reading of models leaves nothing
    EXPECT_EQ(lines.back().at("interrupted"), true);
    EXPECT_EQ(lines.back().at("coverage"), "cut");
    EXPECT_EQ(lines.back().at("stations"), lines.size() - 1);
  }
}

}  // namespace
}  // namespace soms::test
