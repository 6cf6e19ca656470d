// Rows of points, rays, poses and states: none at all, by semicolons, in archives of NumPy; and the
// tables that `contains` and `solid` write.
#include "tests/commands/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// A question of every verb that takes rows, whose rows stand in `file`.
struct RowQuestion {
  std::vector<std::string> words;
  std::string header;
  std::string row;
  bool csv = true;
  bool binary = true;
};

std::vector<RowQuestion> row_questions(const std::string& file) {
  const std::string points = "x,y,z";
  const std::string rays = "ox,oy,oz,dx,dy,dz";
  return {
      {{"contains", box(), "--points", file}, points, "0,0,0"},
      {{"contains", box(), "--winding", "--points", file}, points, "0,0,0"},
      {{"contains", box(), "--by", "connected", "--points", file}, points, "0,0,0", true, false},
      {{"closest", box(), "--points", file}, points, "0,0,0"},
      {{"closest", box(), "--nearest", "2", "--points", file}, points, "0,0,0"},
      {{"closest", box(), "--signed", "--points", file}, points, "0,0,0"},
      {{"ray", box(), "--rays", file}, rays, "-3,0,0,1,0,0"},
      {{"ray", box(), "--any", "--rays", file}, rays, "-3,0,0,1,0,0"},
      {{"ray", box(), "--all", "--rays", file}, rays, "-3,0,0,1,0,0"},
      {{"ray", box(), "--segments", file}, "x0,y0,z0,x1,y1,z1", "-3,0,0,1,0,0"},
      {{"overlap", box(), box(), "--pose", file}, points, "0.5,0,0"},
      {{"overlap", box(), box(), "--by", "part", "--pose", file}, points, "0.5,0,0"},
      {{"distance", box(), box(), "--pose", file}, points, "5,0,0"},
      {{"within", box(), box(), "--clearance", "1", "--pose", file}, points, "5,0,0"},
      {{"solid", box(), box(), "--pose", file}, points, "0.5,0,0"},
      {{"solid", box(), box(), "--by", "part", "--pose", file}, points, "0.5,0,0"},
  };
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string run_and_read(std::vector<std::string> words, const std::string& option,
                         const std::filesystem::path& target) {
  words.push_back(option);
  words.push_back(target.string());
  const RunResult result = soms_run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return read_text(target);
}

TEST(EmptyBatches, AreAnsweredByNoRows) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "rows.csv").string();
  for (RowQuestion& question : row_questions(file)) {
    SCOPED_TRACE(question.words[0] + " " + question.words[2]);
    write_text(file, question.header + "\n# none\n");
    std::vector<std::string> json = question.words;
    json.emplace_back("--json");
    const RunResult none = soms_run(json);
    EXPECT_EQ(none.status, 0) << none.err;
    EXPECT_EQ(none.out, "");
    EXPECT_NE(none.err.find("rows.csv: no rows"), std::string::npos) << none.err;
    const RunResult text = soms_run(question.words);
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_EQ(text.out.find("inf"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find('0'), std::string::npos) << text.out;
    // The same columns as of one row.
    const std::string csv =
        question.csv ? run_and_read(question.words, "-o", folder.path() / "none.csv") : "";
    const std::string npz =
        question.binary ? run_and_read(question.words, "-o", folder.path() / "none.npz") : "";
    write_text(file, question.header + "\n" + question.row + "\n");
    if (question.csv) {
      const std::string one = run_and_read(question.words, "-o", folder.path() / "one.csv");
      EXPECT_EQ(csv, first_line(one) + "\n");
    }
    if (question.binary) {
      const std::string one = run_and_read(question.words, "-o", folder.path() / "one.npz");
      const auto arrays = [](const std::string& bytes) {
        std::size_t count = 0;
        for (std::size_t at = bytes.find(".npy"); at != std::string::npos;
             at = bytes.find(".npy", at + 1)) {
          ++count;
        }
        return count;
      };
      EXPECT_EQ(arrays(npz), arrays(one));
    }
  }
}

TEST(EmptyBatches, OfStatesAreAnsweredByNoRows) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "states.csv").string();
  write_text(file, "turn,lift,wrist,grip\n");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{},
        {"--json"},
        {"--distance"},
        {"--path"},
        {"-o", (folder.path() / "states_out.csv").string()}}) {
    std::vector<std::string> words{"robot", data("robots/arm.urdf").string(), "--states", file};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = soms_run(words);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("states.csv: no rows"), std::string::npos) << result.err;
  }
}

TEST(EmptyBatches, AreNotFilesWithoutAHeader) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "rows.csv").string();
  for (const RowQuestion& question : row_questions(file)) {
    write_text(file, "");
    EXPECT_EQ(soms_run(question.words).status, 3) << question.words[0];
  }
}

TEST(Semicolons, ReadAsCommasDo) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "rows.csv").string();
  for (RowQuestion& question : row_questions(file)) {
    SCOPED_TRACE(question.words[0] + " " + question.words[2]);
    std::vector<std::string> words = question.words;
    words.emplace_back("--json");
    std::string text = question.header + "\n" + question.row + "\n" + question.row + "\n";
    write_text(file, text);
    const RunResult commas = soms_run(words);
    EXPECT_EQ(commas.status, 0) << commas.err;
    std::replace(text.begin(), text.end(), ',', ';');
    write_text(file, text);
    const RunResult semicolons = soms_run(words);
    EXPECT_EQ(semicolons.status, 0) << semicolons.err;
    EXPECT_EQ(semicolons.out, commas.out);
  }
}

TEST(NumpyArchives, AreRowsAsTheirArrayIs) {
  const TemporaryFolder folder;
  const std::string points = (folder.path() / "points.csv").string();
  write_text(points, "x,y,z\n0,0,0\n3,0.5,0\n");
  // An archive of soms itself, of which the array `point` has three columns.
  const std::string archive = (folder.path() / "nearest.npz").string();
  ASSERT_EQ(soms_run({"closest", box(), "--points", points, "-o", archive}).status, 0);
  const RunResult several = soms_run({"contains", box(), "--points", archive});
  EXPECT_EQ(several.status, 3);
  EXPECT_NE(several.err.find("several arrays: "), std::string::npos) << several.err;
  EXPECT_NE(several.err.find("\"point\""), std::string::npos) << several.err;
}

/// Cells of each line of a table.
std::vector<std::vector<std::string>> cells_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

/// A value of JSON as a cell holds it.
std::string cell_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Expects each cell of a table to be the value of that name in the objects of the same run.
void expect_as_json(const std::string& csv, const std::vector<Json>& objects) {
  const auto rows = cells_of(csv);
  ASSERT_EQ(rows.size(), objects.size() + 1);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    ASSERT_EQ(rows[k + 1].size(), rows[0].size());
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      const std::string& column = rows[0][i];
      const std::string expected =
          objects[k].contains(column) ? cell_of(objects[k].at(column)) : "";
      EXPECT_EQ(rows[k + 1][i], expected) << column;
    }
  }
}

TEST(ContainsVerb, WritesATable) {
  const TemporaryFolder folder;
  const std::string points = (folder.path() / "points.csv").string();
  const std::string csv = (folder.path() / "sides.csv").string();
  write_text(points, "x,y,z\n0,0,0\n3,0,0\n1,0,0\n");
  const RunResult plain = soms_run({"contains", box(), "--points", points, "-o", csv, "--json"});
  ASSERT_EQ(plain.status, 0) << plain.err;
  EXPECT_EQ(first_line(read_text(csv)), "row,side,coverage");
  expect_as_json(read_text(csv), json_lines(plain.out));
  const RunResult winding =
      soms_run({"contains", box(), "--winding", "--points", points, "-o", csv, "--json"});
  ASSERT_EQ(winding.status, 0) << winding.err;
  const std::vector<Json> objects = json_lines(winding.out);
  const auto rows = cells_of(read_text(csv));
  EXPECT_EQ(first_line(read_text(csv)), "row,side,lower,upper,coverage");
  ASSERT_EQ(rows.size(), objects.size() + 1);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    EXPECT_EQ(rows[k + 1][1], objects[k].at("side"));
    EXPECT_EQ(std::stod(rows[k + 1][2]), objects[k].at("lower").get<double>());
    EXPECT_EQ(std::stod(rows[k + 1][3]), objects[k].at("upper").get<double>());
  }
}

TEST(ContainsVerb, WritesARowForEachPartThatHoldsAPoint) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "rooms.obj").string();
  const std::string solid = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n";
  write_text(model, solid +
                        "o house\ng room\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\no copy\n"
                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string csv = (folder.path() / "parts.csv").string();
  const RunResult result = soms_run({"contains", model, "--by", "part", "--points", "-", "-o", csv},
                                    "x,y,z\n1,1,1\n-1,0,0\n0,1,1\n");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_text(csv),
            "row,part,name,path,first,side,coverage\n"
            "0,1,room,house/room,0,inside,complete\n"
            "0,2,copy,copy,4,inside,complete\n"
            "2,1,room,house/room,0,on,complete\n"
            "2,2,copy,copy,4,on,complete\n");
}

TEST(SolidVerb, WritesATable) {
  const TemporaryFolder folder;
  const std::string poses = (folder.path() / "poses.csv").string();
  const std::string csv = (folder.path() / "relations.csv").string();
  write_text(poses, "x,y,z\n0,0,0\n0.5,0,0\n2,0,0\n9,0,0\n");
  const RunResult result = soms_run({"solid", box(), box(), "--pose", poses, "-o", csv, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_text(csv),
            "pose,relation,surfaces_meet,why,coverage\n0,same,true,none,complete\n"
            "1,crossing,true,none,complete\n2,touching,true,none,complete\n3,clear,false,none,"
            "complete\n");
  expect_as_json(read_text(csv), json_lines(result.out));
}

TEST(SolidVerb, WritesARowForEachPairOfParts) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "two.obj").string();
  write_text(model,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\n"
             "o left\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\no flag\nf 5 6 7\n");
  const std::string csv = (folder.path() / "pairs.csv").string();
  const RunResult result = soms_run({"solid", model, box(), "--by", "part", "--pose", "4.5 0 0",
                                     "--pose-b", "4.5 0 0", "-o", csv});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = cells_of(read_text(csv));
  EXPECT_EQ(first_line(read_text(csv)),
            "pose,part_a,name_a,path_a,part_b,name_b,path_b,relation,surfaces_meet,why,odd_edges_a,"
            "odd_edges_b,coverage");
  ASSERT_GE(rows.size(), 2U);
  EXPECT_EQ(rows[1][1], "0");
  EXPECT_EQ(rows[1][2], "left");
  EXPECT_EQ(rows[1][7], "a_in_b");
  EXPECT_EQ(rows[1][10], "0");
}

}  // namespace
}  // namespace soms::test
