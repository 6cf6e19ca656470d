// R117: two files whose numbers do not mean the same, and "no overlap" is no "free".
#include "tests/commands/run.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace soms::test {
namespace {

/// z up and in meters, as its file does not say.
std::string hall() {
  return data("frames/hall.obj").string();
}

/// y up and in meters.
std::string duct() {
  return data("frames/duct.gltf").string();
}

RunResult overlap_run(std::vector<std::string> words) {
  words.insert(words.begin(), {"overlap", hall(), duct()});
  return soms_run(std::move(words));
}

/// Kinds of the warnings of an answer, in their order.
std::vector<std::string> kinds(const Json& answer) {
  std::vector<std::string> found;
  for (const Json& warning : answer.value("warnings", Json::array())) {
    found.push_back(warning.at("kind"));
  }
  return found;
}

using Kinds = std::vector<std::string>;

/// As a remedy calls a file whose path stands before it.
std::string named(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

const std::string kAxis = "the up axis is y in " + duct() + ", and unknown in " + hall();
const std::string kUnit = "the unit is 1 m in " + duct() + ", and unknown in " + hall();

TEST(FrameRegressions, R117OverlapWarnsWhereAxesOrUnitsMayDiffer) {
  const RunResult text = overlap_run({});
  EXPECT_EQ(text.status, 0);
  EXPECT_EQ(text.out, "no triangles overlap: the boxes of the models are 1.5 apart\n");
  EXPECT_EQ(text.err, "warning: " + kAxis + "; give --up-b y if z is up in " + named(hall()) +
                          ", and also --up y if y is\nwarning: " + kUnit + "; give --scale 1 if " +
                          named(hall()) +
                          " is in the same unit, or the --scale that converts it (0.001 if it is "
                          "in millimeters)\n");
  const Json answer = json_lines(overlap_run({"--json"}).out).at(0);
  EXPECT_EQ(kinds(answer), (Kinds{"axis_unknown", "unit_unknown"}));
  EXPECT_NE(answer["warnings"][0]["message"].get<std::string>().find(kAxis), std::string::npos);
}

TEST(FrameRegressions, R117WhatTheUserStatesIsNotWarnedOf) {
  const RunResult turned = overlap_run({"--up-b", "y", "--json"});
  EXPECT_EQ(json_lines(turned.out).at(0).at("count"), 16);
  EXPECT_EQ(kinds(json_lines(turned.out).at(0)), Kinds{"unit_unknown"});
  EXPECT_EQ(turned.err.find("up axis"), std::string::npos) << turned.err;
  for (const char* const scale : {"--scale", "--scale-b"}) {
    const RunResult settled = overlap_run({"--up-b", "y", scale, "1", "--json"});
    EXPECT_EQ(settled.err, "");
    EXPECT_FALSE(json_lines(settled.out).at(0).contains("warnings"));
  }
  // Turning both is as good, and the same pairs overlap as where neither is turned.
  const RunResult both = overlap_run({"--up", "y", "--up-b", "y", "--scale", "1", "--json"});
  EXPECT_EQ(both.err, "");
  EXPECT_EQ(json_lines(both.out).at(0).at("hash"),
            json_lines(overlap_run({"--json"}).out).at(0).at("hash"));
  // What was turned to z differs from what its file says is y up.
  EXPECT_EQ(kinds(json_lines(overlap_run({"--up", "z", "--scale", "1", "--json"}).out).at(0)),
            Kinds{"axes_differ"});
}

TEST(FrameRegressions, R117StrictRefusesWhatIsWarnedOf) {
  const RunResult refused = overlap_run({"--strict"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("soms overlap: --strict: " + kAxis + "; " + kUnit + "; give --up-b y"),
            std::string::npos)
      << refused.err;
  const RunResult unit = overlap_run({"--strict", "--up-b", "y"});
  EXPECT_EQ(unit.status, 3);
  EXPECT_NE(unit.err.find("give --scale 1"), std::string::npos) << unit.err;
  EXPECT_EQ(overlap_run({"--strict", "--up-b", "y", "--scale", "1"}).status, 0);
}

TEST(FrameRegressions, R117ModelsThatDeclareNothingOrTheSameAreNotWarnedOf) {
  EXPECT_EQ(soms_run({"overlap", hall(), hall(), "--strict"}).err, "");
  EXPECT_EQ(soms_run({"overlap", duct(), duct(), "--strict"}).err, "");
}

TEST(FrameRegressions, R117BoxesFarApartAreWarnedOf) {
  const auto at = [](const std::string& pose) {
    return std::vector<std::string>{"overlap", hall(), hall(), "--pose", pose};
  };
  // The hall is 6 m long.
  EXPECT_EQ(soms_run(at("12 0 0")).err, "");
  const RunResult far = soms_run(at("13 0 0"));
  EXPECT_NE(far.err.find("warning: the boxes of "), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("are 7 or more apart, farther than either is long"), std::string::npos);
  std::vector<std::string> strict = at("13 0 0");
  strict.emplace_back("--strict");
  EXPECT_EQ(soms_run(strict).status, 3);
  EXPECT_EQ(soms_run(strict).out, "");
}

/// JSON of a file of poses that put the hall beside itself at these places on x.
RunResult rows(const std::vector<std::string>& places, const std::vector<std::string>& more) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "poses.csv").string();
  std::string text = "x,y,z\n";
  for (const std::string& place : places) {
    text += place + ",0,0\n";
  }
  write_text(file, text);
  std::vector<std::string> words{"overlap", hall(), hall(), "--pose", file};
  words.insert(words.end(), more.begin(), more.end());
  return soms_run(words);
}

TEST(FrameRegressions, R117OfManyPosesOnlyAllFarApartAreWarnedOf) {
  const RunResult some = rows({"13", "2", "900"}, {"--json", "--no-pairs", "--strict"});
  EXPECT_EQ(some.status, 0);
  EXPECT_EQ(some.err, "");
  const std::vector<Json> answers = json_lines(some.out);
  EXPECT_EQ(kinds(answers.at(0)), Kinds{"boxes_apart"});
  EXPECT_FALSE(answers.at(1).contains("warnings"));
  EXPECT_EQ(kinds(answers.at(2)), Kinds{"boxes_apart"});
  const RunResult all = rows({"13", "900"}, {});
  EXPECT_EQ(all.status, 0);
  EXPECT_NE(all.err.find("warning: at every pose the boxes of"), std::string::npos) << all.err;
  EXPECT_EQ(std::count(all.err.begin(), all.err.end(), '\n'), 1);
  const RunResult refused = rows({"13", "900"}, {"--strict"});
  EXPECT_EQ(refused.status, 3);
}

TEST(FrameRegressions, R117TheReportSaysIt) {
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  ASSERT_EQ(overlap_run({"-o", page}).status, 0);
  const std::string text = read_text(page);
  EXPECT_NE(text.find("the up axis is y in"), std::string::npos);
  EXPECT_NE(text.find("the unit is 1 m in"), std::string::npos);
}

TEST(FrameRegressions, R117SimulateTurnsWhatStatesItsAxisAndWarnsOfWhatDoesNot) {
  const std::vector<std::string> words{"simulate", hall(), "--mover",  duct(),
                                       "--count",  "1",    "--frames", "1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return soms_run(more);
  };
  const RunResult text = with({});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.err.find(duct() + ": the up axis is y; rotated to z"), std::string::npos);
  EXPECT_NE(
      text.err.find("warning: the up axis is z in " + duct() + ", and unknown in " + hall() +
                    "; give --up z if z is also up in " + named(hall()) + ", or --up y if y is"),
      std::string::npos)
      << text.err;
  EXPECT_EQ(kinds(Json::parse(with({"--json"}).out)), (Kinds{"axis_unknown", "unit_unknown"}));
  EXPECT_EQ(with({"--strict"}).status, 3);
  const RunResult stated = with({"--up", "z", "--scale", "1", "--strict", "--json"});
  EXPECT_EQ(stated.status, 0) << stated.err;
  EXPECT_FALSE(Json::parse(stated.out).contains("warnings"));
  const TemporaryFolder folder;
  const std::string page = (folder.path() / "page.html").string();
  ASSERT_EQ(with({"-o", page}).status, 0);
  EXPECT_NE(read_text(page).find("the up axis is z in"), std::string::npos);
  // What soms makes itself is in meters, z up, and takes a city that states nothing for the same.
  EXPECT_EQ(soms_run({"simulate", hall(), "--count", "1", "--frames", "1", "--strict"}).err, "");
}

TEST(FrameRegressions, R117OptionsForAllFilesOfACityAreNotTheRemedyForOne) {
  const RunResult result = soms_run({"simulate", hall(), duct(), "--count", "1", "--frames", "1"});
  EXPECT_NE(result.err.find("convert hall.obj first: soms convert " + hall()), std::string::npos)
      << result.err;
  EXPECT_EQ(result.err.find("if z is up"), std::string::npos) << result.err;
}

std::string meters() {
  return data("formats/z_up.dae").string();
}

std::string centimeters() {
  return data("formats/z_up_cm.dae").string();
}

RunResult simulate_run(std::vector<std::string> words) {
  words.insert(words.begin(), "simulate");
  words.insert(words.end(), {"--frames", "1", "--count", "1"});
  return soms_run(std::move(words));
}

TEST(FrameRegressions, OneScaleForSeveralCitiesDoesNotSettleTheirUnits) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--scale", "0.01"}, {"--scale", "1"}}) {
    std::vector<std::string> words{centimeters(), meters(), "--strict"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult refused = simulate_run(words);
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("soms convert " + centimeters() + " OUT.glb --scale 0.01"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(refused.err.find("give --scale"), std::string::npos) << refused.err;
  }
  // What the message says ends it.
  const TemporaryFolder folder;
  const std::string converted = (folder.path() / "a.glb").string();
  ASSERT_EQ(soms_run({"convert", centimeters(), converted, "--scale", "0.01"}).status, 0);
  const RunResult settled = simulate_run({converted, meters(), "--strict"});
  EXPECT_EQ(settled.status, 0) << settled.err;
}

TEST(FrameRegressions, AScaleStatesAnUnknownUnitOfSeveralCitiesOnlyWhereItIsOne) {
  const std::vector<std::string> words{hall(), meters(), "--up", "z", "--strict", "--scale"};
  const auto with = [&](const char* scale) {
    std::vector<std::string> all = words;
    all.emplace_back(scale);
    return simulate_run(all);
  };
  EXPECT_EQ(with("0.01").status, 3);
  EXPECT_EQ(with("1").status, 0) << with("1").err;
}

TEST(FrameRegressions, OneScaleForSeveralMoversDoesNotSettleTheirUnits) {
  const std::vector<std::string> words{
      "simulate", hall(), "--up",          "z",    "--mover",  meters(), "--mover", centimeters(),
      "--count",  "2",    "--mover-scale", "0.01", "--frames", "1",      "--strict"};
  const RunResult refused = soms_run(words);
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("OUT.glb --scale 0.01) and leave out --mover-scale"),
            std::string::npos)
      << refused.err;
}

TEST(FrameRegressions, AScaleThatDoesNotFitBothUnitsIsWarnedOf) {
  const auto strict = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"overlap", centimeters(), meters(), "--strict"});
    return soms_run(std::move(more));
  };
  EXPECT_EQ(strict({"--scale", "0.01"}).status, 0);
  EXPECT_EQ(strict({"--scale", "1"}).status, 0);
  EXPECT_EQ(strict({"--scale-b", "100"}).status, 0);
  const RunResult wrong = strict({"--scale", "0.1"});
  EXPECT_EQ(wrong.status, 3);
  EXPECT_NE(wrong.err.find("; give --scale 0.01 to convert " + named(centimeters()) +
                           ", or give --scale-b 1 to keep the numbers"),
            std::string::npos)
      << wrong.err;
  EXPECT_NE(strict({"--scale-b", "10"}).err.find("give --scale-b 100"), std::string::npos);
  EXPECT_EQ(strict({"--scale", "0.1", "--scale-b", "1"}).status, 0);
}

TEST(FrameRegressions, InAWorldWhatIsNotInMetersIsToBeScaled) {
  const RunResult mover = simulate_run({meters(), "--mover", centimeters(), "--strict"});
  EXPECT_NE(mover.err.find("; give --mover-scale 0.01 to convert"), std::string::npos) << mover.err;
  const RunResult city = simulate_run({centimeters(), "--mover", meters(), "--strict"});
  EXPECT_NE(city.err.find("; give --scale 0.01 to convert"), std::string::npos) << city.err;
}

TEST(FrameRegressions, RemarksOfAWorldAreInItsJson) {
  const RunResult result =
      simulate_run({duct(), "--mover", centimeters(), "--json", "--mover-scale", "0.01"});
  const Json notes = Json::parse(result.out).at("notes");
  ASSERT_EQ(notes.size(), 1U) << notes;
  EXPECT_EQ(notes.at(0), duct() + ": the up axis is y; rotated to z (give --up z to keep it)");
  const Json unit = Json::parse(simulate_run({meters(), "--mover", centimeters(), "--json"}).out);
  EXPECT_EQ(
      unit.at("notes").at(0),
      centimeters() + ": the unit is 0.01 m; assuming meters (--mover-scale 0.01 converts it)");
}

TEST(FrameRegressions, TheSizeOfAMoverIsQuestionedOnlyWhereItsUnitIsUnknown) {
  const TemporaryFolder folder;
  const std::string large = (folder.path() / "large.off").string();
  write_text(large, triangle_off("0 0 0", "100 0 0", "0 0 100"));
  const std::string words = "100 across, assuming meters; --mover-scale rescales it";
  const RunResult unknown = simulate_run({hall(), "--mover", large, "--json"});
  EXPECT_EQ(Json::parse(unknown.out).at("notes").at(0), large + ": " + words);
  EXPECT_EQ(simulate_run({hall(), "--mover", large, "--mover-scale", "1"}).err.find("across"),
            std::string::npos);
  EXPECT_EQ(simulate_run({meters(), "--mover", meters(), "--mover-scale", "20"}).err.find("across"),
            std::string::npos);
}

TEST(FrameRegressions, AMoverLargerThanTheCityIsRemarkedOn) {
  const TemporaryFolder folder;
  const std::string large = (folder.path() / "large.off").string();
  write_text(large, triangle_off("0 0 0", "100 0 0", "0 0 100"));
  const RunResult result = simulate_run({hall(), "--mover", large, "--json"});
  const Json notes = Json::parse(result.out).at("notes");
  ASSERT_EQ(notes.size(), 2U) << notes;
  const std::string note = notes.at(1);
  EXPECT_TRUE(note.starts_with(large + ": 100 long, larger than the city (")) << note;
  EXPECT_NE(result.err.find(note), std::string::npos) << result.err;
  EXPECT_EQ(simulate_run({hall(), "--mover", large, "--mover-scale", "1"}).err.find("larger"),
            std::string::npos);
}

TEST(FrameRegressions, AnAxisThatContradictsTheFileHasAWayOut) {
  const RunResult refused = soms_run({"info", duct(), "--up", "z", "--strict"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("soms convert " + duct() + " OUT.glb --up z"), std::string::npos)
      << refused.err;
  const TemporaryFolder folder;
  const std::string converted = (folder.path() / "a.glb").string();
  ASSERT_EQ(soms_run({"convert", duct(), converted, "--up", "z"}).status, 0);
  EXPECT_EQ(soms_run({"info", converted, "--strict"}).status, 0);
}

TEST(FrameRegressions, R117SimulateWarnsOfMoversThatNeverComeNear) {
  const TemporaryFolder folder;
  const auto route = [&](const std::string& rows) {
    const std::string file = (folder.path() / "route.csv").string();
    write_text(file, "x,y,z,qw,qx,qy,qz\n" + rows);
    return std::vector<std::string>{"simulate", hall(),     "--mover", hall(),     "--route",
                                    file,       "--frames", "3",       "--strict", "--json"};
  };
  const std::string far = "500000,0,0,1,0,0,0\n";
  const RunResult refused = soms_run(route(far));
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("--strict: in every frame the boxes of the movers and hall are"),
            std::string::npos)
      << refused.err;
  const RunResult near = soms_run(route(far + "8,0,0,1,0,0,0\n" + far));
  EXPECT_EQ(near.status, 0) << near.err;
  EXPECT_FALSE(Json::parse(near.out).contains("warnings"));
}

/// A run of movers that are far from the city in every frame.
std::vector<std::string> far_run(const TemporaryFolder& folder, const std::string& frames) {
  const std::string route = (folder.path() / "far.csv").string();
  write_text(route, "x,y,z,qw,qx,qy,qz\n500000,0,0,1,0,0,0\n");
  return {"simulate", hall(),   "--mover",  hall(), "--route",
          route,      "--json", "--frames", frames, "--strict"};
}

TEST(FrameRegressions, StrictRefusesMoversThatStayAwayAfterAllThatWasFoundIsWritten) {
  const TemporaryFolder folder;
  std::vector<std::string> words = far_run(folder, "3");
  for (const auto& [option, file] :
       {std::pair("-o", "events.csv"), std::pair("-o", "map.svg"), std::pair("-o", "page.html"),
        std::pair("--record", "run.somsrec")}) {
    words.insert(words.end(), {option, (folder.path() / file).string()});
  }
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 3) << result.err;
  EXPECT_EQ(kinds(Json::parse(result.out)), Kinds{"boxes_apart"});
  EXPECT_EQ(files_in(folder.path()), (std::vector<std::string>{"events.csv", "far.csv", "map.svg",
                                                               "page.html", "run.somsrec"}));
}

TEST(FrameRegressions, AnInterruptedRunIsNotRefusedForMoversThatStayedAway) {
  const TemporaryFolder folder;
  const TemporaryFolder streams;
  std::vector<std::string> words = far_run(folder, "100000000");
  words.insert(words.begin(), command().string());
  words.insert(words.end(), {"--record", (folder.path() / "run.somsrec").string()});
  Child child(words, streams.path());
  ASSERT_TRUE(child.wait_for_writing(100'000));  // the recording, so frames have been made
  child.send(SIGINT);
  const RunResult result = child.wait();
  EXPECT_EQ(result.status, 130) << result.err;
  const Json answer = Json::parse(result.out);
  EXPECT_EQ(answer["interrupted"], true);
  EXPECT_FALSE(answer.contains("warnings"));
}

TEST(FrameRegressions, R117StrictMakesAnErrorOfWhatReadingNotes) {
  const TemporaryFolder folder;
  const std::string noted = data("formats/groups.obj").string();
  ASSERT_NE(soms_run({"info", noted, "--no-trees"}).out.find("  note "), std::string::npos);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", noted, "--no-trees"},
        std::vector<std::string>{"convert", noted, (folder.path() / "a.ply").string()},
        std::vector<std::string>{"overlap", noted, noted},
        std::vector<std::string>{"simulate", noted, "--count", "1", "--frames", "1"}}) {
    EXPECT_EQ(soms_run(words).status, 0) << words[0];
    std::vector<std::string> strict = words;
    strict.emplace_back("--strict");
    const RunResult refused = soms_run(strict);
    EXPECT_EQ(refused.status, 3) << words[0];
    EXPECT_NE(refused.err.find("without --strict"), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace soms::test
