#include "soms/io/poses.h"

#include "soms/base/error.h"
#include "soms/io/detail/file.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/pipe.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// Poses of a file of this content.
std::vector<Pose> read(const std::string& content) {
  const TemporaryFolder folder;
  write_content(folder.path() / "poses.csv", content);
  return read_poses(folder.path() / "poses.csv");
}

void expect_no_poses(const std::string& content, ErrorKind kind, const std::string& words) {
  SCOPED_TRACE(content);
  expect_refused([&] { static_cast<void>(read(content)); }, kind, "poses.csv");
  expect_refused([&] { static_cast<void>(read(content)); }, kind, words);
}

TEST(PoseReader, TellsShiftsFromPosesByTheHeader) {
  const TemporaryFolder folder;
  const auto shifts_only = [&](const std::string& header) {
    write_content(folder.path() / "poses.csv", header);
    return PoseReader(folder.path() / "poses.csv").shifts_only();
  };
  EXPECT_TRUE(shifts_only("x,y,z\n"));
  EXPECT_TRUE(shifts_only("   \n # a\r z , y,x"));
  EXPECT_FALSE(shifts_only("# a, b, c\n  # a, b, c\nx,y,z,qw,qx,qy,qz\n"));
  EXPECT_FALSE(shifts_only("r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n"));
}

TEST(ParsePose, TakesThreeOrSevenNumbersPartedByBlanksOrCommas) {
  const Pose shift = Pose::translation(1, -2.5, 3e2);
  for (const std::string text : {"1 -2.5 3e2", "1,-2.5,300", " 1 , -2.5 ,\t+300 "}) {
    EXPECT_EQ(parse_pose(text), shift) << text;
  }
  EXPECT_EQ(parse_pose("1 2 3 1 0 0 0"), Pose::translation(1, 2, 3));
  EXPECT_EQ(parse_pose("1 2 3 0 0 0 1"), Pose::from_quaternion(0, 0, 0, 1, {1, 2, 3}));
}

TEST(ParsePose, NamesWhatIsWrong) {
  const auto refuse = [](const std::string& text, ErrorKind kind, const std::string& words) {
    SCOPED_TRACE(text);
    expect_refused([&] { static_cast<void>(parse_pose(text)); }, kind, words);
  };
  for (const std::string text : {"", " ", "1", "1 2", "1 2 3 4", "1 2 3 1 0 0", "1 2 3,"}) {
    refuse(text, ErrorKind::usage, "give \"x y z\" or \"x y z qw qx qy qz\"");
  }
  refuse("1 2 3 1 0 0 0 0", ErrorKind::usage, "more than 7 numbers");
  refuse("1,,2", ErrorKind::usage, "a comma without a number");
  refuse(",1 2 3", ErrorKind::usage, "a comma without a number");
  refuse("1 two 3", ErrorKind::usage, "y is \"two\", not a number");
  refuse("1 2 3m", ErrorKind::usage, "z is \"3m\", not a number");
  refuse("1 inf 3", ErrorKind::not_finite, "y is \"inf\"");
  refuse("1 1e999 3", ErrorKind::not_finite, "y is \"1e999\"");
  refuse("1 2 3 1 1 0 0", ErrorKind::not_rigid, "quaternion");
  // Six digits, as people type them, are close enough to length 1.
  EXPECT_NO_THROW(static_cast<void>(parse_pose("1 2 3 0.707107 0 0 0.707107")));
  EXPECT_NO_THROW(static_cast<void>(parse_pose("1 2 3 0.70710678 0 0 0.70710678")));
}

TEST(PoseReader, ReadsShiftsQuaternionsAndMatrices) {
  EXPECT_EQ(read("x,y,z\n1,2,3\n\n# why\n -4 , 5e0,+6\r\n"),
            (std::vector<Pose>{Pose::translation(1, 2, 3), Pose::translation(-4, 5, 6)}));
  EXPECT_EQ(read("x,y,z,qw,qx,qy,qz\n1,2,3,0,1,0,0"),
            (std::vector<Pose>{Pose::from_quaternion(0, 1, 0, 0, {1, 2, 3})}));
  Pose quarter;
  quarter.m = {0, -1, 0, 7, 1, 0, 0, 8, 0, 0, 1, 9};
  EXPECT_EQ(
      read("# matrices\nr00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n0,-1,0,7,1,0,0,8,0,0,1,9\n"),
      (std::vector<Pose>{quarter}));
}

TEST(PoseReader, TakesColumnsInAnyOrderAndLinesOfAnyEnd) {
  const std::vector<Pose> expected = {Pose::translation(1, 2, 3), Pose::translation(4, 5, 6)};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    EXPECT_EQ(read("\xef\xbb\xbfz,x,y" + end + "3,1,2" + end + "6,4,5" + end), expected);
  }
  EXPECT_TRUE(read("x,y,z\n").empty());
}

TEST(PoseReader, NamesFileAndLine) {
  expect_no_poses("", ErrorKind::bad_file, "no header and no poses; begin with x,y,z");
  expect_no_poses("\n# nothing\n", ErrorKind::bad_file, "no header and no poses");
  for (const std::string header :
       {"1,2,3", "x,y", "x,y,z,w", "x,y,z,qw", "x,x,z", "x y z", "x,y,z,", "X,Y,Z"}) {
    expect_no_poses("\n" + header + "\n1,2,3\n", ErrorKind::bad_file, "line 2: the header");
  }
  expect_no_poses("t,x,y,z\n0,1,2,3\n", ErrorKind::bad_file,
                  "remove the column \"t\", or begin with x,y,z");
  expect_no_poses("x,y,z\n1,2,3\n1,2\n", ErrorKind::bad_file,
                  "line 3: 2 numbers, but the header has 3");
  expect_no_poses("x,y,z\r\n1,2,3\r\n1,2,3,4\r\n", ErrorKind::bad_file, "line 3: 4 numbers");
  expect_no_poses("x,y,z\n1,b,3\n", ErrorKind::bad_file, "line 2: y is \"b\", not a number");
  expect_no_poses("x,y,z\n1,,3\n", ErrorKind::bad_file, "line 2: y is \"\", not a number");
  expect_no_poses("x,y,z\n1,2,3 4\n", ErrorKind::bad_file, "line 2: z is \"3 4\"");
  expect_no_poses("z,y,x\n1,2,nan\n", ErrorKind::not_finite, "line 2: x is \"nan\"");
  expect_no_poses("x,y,z,qw,qx,qy,qz\n\n1,2,3,2,0,0,0\n", ErrorKind::not_rigid, "line 3: pose:");
  expect_no_poses("r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n2,0,0,0,0,1,0,0,0,0,1,0\n",
                  ErrorKind::not_rigid, "line 2: pose: entry 0,0");
  // 39.52 degrees about z as printf's %.6f prints it.
  expect_no_poses(
      "r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz\n"
      "0.771403,-0.636348,0,0,0.636348,0.771403,0,0,0,0,1,0\n",
      ErrorKind::not_rigid, "print the rotation with more digits");
  expect_no_poses("x,y,z\n" + std::string(1100000, '1') + ",2,3\n", ErrorKind::bad_file,
                  "line 2: longer than 1 MiB");
}

TEST(PoseReader, NamesWhatCannotBeOpened) {
  const TemporaryFolder folder;
  expect_refused([&] { static_cast<void>(PoseReader(folder.path() / "missing.csv")); },
                 ErrorKind::cannot_open, "missing.csv: No such file");
  expect_refused([&] { static_cast<void>(PoseReader(folder.path())); }, ErrorKind::cannot_open,
                 "a folder");
}

TEST(PoseReader, NeedsNoMoreMemoryForManyRows) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "poses.csv";
  {
    std::ofstream out(path);
    out << "x,y,z\n";
    for (int i = 0; i < 200000; ++i) {
      out << i << ",0.5,-1\n";
    }
  }
  const AllocationWatch watch;
  PoseReader reader(path);
  int count = 0;
  while (const auto pose = reader.next()) {
    ASSERT_EQ(*pose, Pose::translation(count, 0.5, -1));
    ++count;
  }
  EXPECT_EQ(count, 200000);
  EXPECT_LT(watch.peak(), 200000U);
}

TEST(PoseReader, GivesTheSameRowsWhereverTheBufferEnds) {
  // Rows of many lengths, so that ends and CRLF pairs fall on every place of the reader's buffer.
  std::string content = "x,y,z\r\n";
  std::vector<Pose> expected;
  for (int i = 0; i < 20000; ++i) {
    const std::string digits(static_cast<std::size_t>(1 + i % 13), '7');
    content += digits + "," + std::to_string(i) + ",0\r\n";
    expected.push_back(Pose::translation(std::stod(digits), i, 0));
  }
  EXPECT_EQ(read(content), expected);
  const TemporaryFolder folder;
  write_content(folder.path() / "poses.csv", content);
  PoseReader reader(folder.path() / "poses.csv");
  std::vector<Pose> rows;
  while (reader.ready()) {
    const auto row = reader.next();
    if (!row) {
      break;
    }
    rows.push_back(*row);
  }
  EXPECT_EQ(rows, expected);
}

TEST(PoseReader, IsReadyWhereNextWillNotWait) {
  const TemporaryFolder folder;
  Pipe pipe(folder.path() / "poses", "x,y,z\n");
  PoseReader reader(pipe.path());
  for (const char* part : {"", "1,2", ",3"}) {
    pipe.give(part);
    EXPECT_FALSE(reader.ready()) << part;
  }
  pipe.give("\r");
  EXPECT_TRUE(reader.ready());
  EXPECT_TRUE(reader.ready());
  EXPECT_EQ(reader.next(), Pose::translation(1, 2, 3));
  for (const char* part : {"", "\n", "# why\n", " \n\r\n"}) {
    pipe.give(part);
    EXPECT_FALSE(reader.ready()) << part;
  }
  pipe.give("4,b,6\n7,8,9\n# more");
  EXPECT_TRUE(reader.ready());
  expect_refused([&] { static_cast<void>(reader.next()); }, ErrorKind::bad_file, "line 6: y is");
  EXPECT_EQ(reader.next(), Pose::translation(7, 8, 9));
  EXPECT_FALSE(reader.ready());
  pipe.end();
  EXPECT_TRUE(reader.ready());
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_TRUE(reader.ready());
}

TEST(PoseReader, GivesTheSameRowsHoweverAPipeIsFilled) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string content;
    std::vector<Pose> expected;
    for (int i = 0; i < 40; ++i) {
      content += std::to_string(i) + ",0," + std::string(static_cast<std::size_t>(i % 5), ' ') +
                 "7" + end + (i % 3 == 0 ? end : "") + (i % 4 == 0 ? " # why" + end : "");
      expected.push_back(Pose::translation(i, 0, 7));
    }
    content.resize(content.size() - end.size());  // the last line lacks its end
    for (const std::size_t step : {1U, 2U, 3U, 7U, 100U}) {
      const TemporaryFolder folder;
      Pipe pipe(folder.path() / "poses", "x,y,z" + end);
      PoseReader reader(pipe.path());
      std::vector<Pose> rows;
      for (std::size_t at = 0; at < content.size(); at += step) {
        pipe.give(content.substr(at, step));
        while (reader.ready()) {
          rows.push_back(reader.next().value());
        }
      }
      EXPECT_GE(rows.size() + 1, expected.size());
      pipe.end();
      EXPECT_TRUE(reader.ready());
      while (const auto row = reader.next()) {
        rows.push_back(*row);
      }
      EXPECT_EQ(rows, expected);
    }
  }
}

TEST(PoseReader, LeavesFaultsToNextWhenRequestedWhetherItIsReady) {
  const TemporaryFolder folder;
  write_content(folder.path() / "poses.csv", "x,y,z\n1,2,3\n" + std::string(1100000, '1'));
  PoseReader reader(folder.path() / "poses.csv");
  EXPECT_TRUE(reader.ready());
  EXPECT_EQ(reader.next(), Pose::translation(1, 2, 3));
  EXPECT_TRUE(reader.ready());
  expect_refused([&] { static_cast<void>(reader.next()); }, ErrorKind::bad_file,
                 "line 3: longer than 1 MiB");
}

TEST(PoseReader, ReadsASocketThatIsOpenAlready) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const detail::Descriptor ours(ends[0]);
  const detail::Descriptor theirs(ends[1]);
  ASSERT_EQ(write(theirs.get(), "x,y,z\n1,2,3\n", 12), 12);
  PoseReader reader("/dev/fd/" + std::to_string(ours.get()));
  EXPECT_EQ(reader.next(), Pose::translation(1, 2, 3));
  EXPECT_FALSE(reader.ready());
  ASSERT_EQ(shutdown(theirs.get(), SHUT_WR), 0);
  EXPECT_TRUE(reader.ready());
  EXPECT_EQ(reader.next(), std::nullopt);
}

TEST(PoseReader, EndsByAStopWhileItWaitsForARow) {
  const TemporaryFolder folder;
  const Pipe pipe(folder.path() / "poses", "x,y,z\n1,2,3\n");
  std::stop_source stop;
  PoseReader reader(pipe.path(), {.stop = stop.get_token()});
  EXPECT_EQ(reader.next(), Pose::translation(1, 2, 3));
  stop.request_stop();
  expect_refused([&] { static_cast<void>(reader.next()); }, ErrorKind::cancelled,
                 "stopped on request");
}

}  // namespace
}  // namespace soms::test
