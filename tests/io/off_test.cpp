#include "soms/io/detail/simple/off.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms::test {
namespace {

const std::string kBody = "0 0 0.1\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(Off, ReadsWhateverTheMagicWordPromisesBehindTheCoordinates) {
  for (const std::string magic : {"OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF"}) {
    SCOPED_TRACE(magic);
    const Mesh mesh = read_text(
        magic + "\n3 1 0\n0 0 .1 1 2 3 4\n1 0 0 9 9 9 # why\n0 1 0\n3 0 1 2 255 0 0\n", "a.off");
    EXPECT_EQ(mesh.vertices[0].z, 0.1);
    EXPECT_EQ(mesh.vertices[2], (Vec3{0, 1, 0}));
    EXPECT_EQ(mesh.triangles.size(), 1U);
  }
}

TEST(Off, TakesCountsFromAnyPlaceBehindTheMagicWord) {
  for (const std::string head :
       {"OFF\n3 1 3\n", "OFF 3 1 0\n", "3 1 0\n", "# a\n\nOFF # b\n# c\n3 1 # d\n",
        "OFF\r\n3 1\r\n", "OFF\r3 1 0\r"}) {
    SCOPED_TRACE(head);
    EXPECT_EQ(read_text(head + kBody, "a.off").triangles.size(), 1U);
  }
}

// ModelNet40 has hundreds of such files.
TEST(Off, TakesTheFirstCountWithoutABlankBeforeIt) {
  for (const std::string head : {"OFF3 1 0\n", "COFF3 1\n", "# a\nSTCNOFF3 1 9 # b\r\n"}) {
    SCOPED_TRACE(head);
    EXPECT_EQ(read_text(head + kBody, "a.off").triangles.size(), 1U);
    EXPECT_EQ(read_text(head + kBody, "a").triangles.size(), 1U);
  }
  EXPECT_EQ(read_mesh(data("reports/off_glued.off")).triangles.size(), 12U);
  for (const std::string head : {"OFFx 3 1 0\n", "OFF3x 1 0\n", "OFF-3 1 0\n", "OFF3.5 1 0\n"}) {
    expect_refused(head + kBody, "a.off", ErrorKind::bad_file, "not OFF");
  }
  expect_refused("4OFF3 1 0\n" + kBody, "a.off", ErrorKind::unsupported, "three dimensions");
  expect_refused("OFF9999999999 1 0\n" + kBody, "a.off", ErrorKind::bad_file, "bytes are left");
}

TEST(Off, RefusesMoreBehindTheCounts) {
  expect_refused("OFF\n3 1 0 0 0 0.1\n" + kBody, "a.off", ErrorKind::bad_file,
                 "line 2: \"0\" follows the counts");
}

TEST(Off, NotesWhatTheMagicWordDoesNotAnnounce) {
  const auto notes_of = [](const std::string& magic, const std::string& behind) {
    return read_text(magic + "\n3 1 0\n0 0 0 " + behind + "\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off")
        .notes;
  };
  const std::vector<std::string> long_row = {
      "vertex rows with more values after z than the keyword of the file declares: 1, in line "
      "3"};
  EXPECT_EQ(notes_of("OFF", "1"), long_row);
  EXPECT_EQ(notes_of("NOFF", "1 0 0 9"), long_row);
  EXPECT_EQ(notes_of("STCNOFF", "1 2 3 4 5 6 7 8 9 10"), long_row);
  for (const std::string magic : {"NOFF", "COFF", "STCNOFF"}) {
    EXPECT_TRUE(notes_of(magic, "0 0 1").empty()) << magic;
  }
  EXPECT_TRUE(notes_of("STCNOFF", "1 2 3 4 5 6 7 8 9 # all").empty());
}

TEST(Off, RefusesARowThatIsCutShort) {
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.off", ErrorKind::bad_file,
                 "line 4: z of a vertex is missing: the line ends");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", ErrorKind::bad_file,
                 "line 6: vertex 3, but vertices are 0 to 2");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a.off", ErrorKind::bad_file,
                 "line 6: a vertex number is missing: the line ends");
}

TEST(Off, RefusesTwoRowsInOneLine) {
  expect_refused("OFF\n3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2\n", "a.off", ErrorKind::bad_file,
                 "the file ends, but a face is missing");
}

TEST(Off, RefusesHugeCountsBeforeAllocating) {
  const AllocationWatch watch;
  for (const std::string count : {"2147483648", "4294967299", "9223372036854775807"}) {
    expect_refused("OFF\n" + count + " 1 0\n" + kBody, "a.off", ErrorKind::bad_file, "line 2");
    expect_refused("OFF\n3 " + count + " 0\n" + kBody, "a.off", ErrorKind::bad_file, "line 2");
  }
  expect_refused("OFF\n3 18446744073709551617 0\n" + kBody, "a.off", ErrorKind::bad_file,
                 "not a whole number");
  EXPECT_LT(watch.peak(), std::uint64_t{1} << 20);
}

TEST(Off, NamesWhatIsNotRead) {
  expect_refused("4OFF\n3 1 0\n" + kBody, "a.off", ErrorKind::unsupported, "three dimensions");
  expect_refused("nOFF\n3\n3 1 0\n" + kBody, "a.off", ErrorKind::unsupported, "three dimensions");
  expect_refused("OFF BINARY\n", "a.off", ErrorKind::unsupported, "binary OFF is not read");
}

}  // namespace
}  // namespace soms::test
