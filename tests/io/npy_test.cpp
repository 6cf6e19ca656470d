// Rows of NumPy arrays, by `RowReader` and `PoseReader`.
#include "soms/base/error.h"
#include "soms/io/poses.h"
#include "soms/io/rows.h"

#include "tests/io/files.h"
#include "tests/support/pipe.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace soms::test {
namespace {

const std::vector<std::vector<Column>> kNpyHeaders{{{"x"}, {"y"}, {"z"}},
                                                   {{"x"}, {"y"}, {"z"}, {"length", true}}};

/// The header of format version 1.0 with this text, or of another.
std::string npy_start(const std::string& text, int version = 1) {
  return std::string("\x93NUMPY") + static_cast<char>(version) + '\0' +
         bytes_of(text.size(), version == 1 ? 2 : 4) + text;
}

std::string npy_text(const std::string& type, const std::string& shape,
                     const std::string& fortran_order = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + fortran_order + ", 'shape': " + shape +
         ", }\n";
}

template <class T = double>
std::string numbers(const std::vector<T>& values) {
  std::string bytes;
  for (const T value : values) {
    bytes += bytes_of(value);
  }
  return bytes;
}

/// All rows of a file of this content.
std::vector<std::vector<double>> npy_rows(const std::string& content) {
  const TemporaryFolder folder;
  write_content(folder.path() / "rows.npy", content);
  RowReader reader(folder.path() / "rows.npy", "things", kNpyHeaders);
  std::vector<std::vector<double>> rows;
  while (const auto row = reader.next()) {
    rows.emplace_back(row->begin(), row->end());
  }
  return rows;
}

void expect_refused_array(const std::string& content, ErrorKind kind, const std::string& words) {
  SCOPED_TRACE(words);
  expect_refused([&] { static_cast<void>(npy_rows(content)); }, kind, "rows.npy");
  expect_refused([&] { static_cast<void>(npy_rows(content)); }, kind, words);
}

const std::vector<std::vector<double>> kTwoRows{{1, 2.5, -3}, {0, 1e300, 0x1p-1074}};

TEST(NpyRows, AreRead) {
  const std::string values = numbers({1.0, 2.5, -3.0, 0.0, 1e300, 0x1p-1074});
  EXPECT_EQ(npy_rows(npy_start(npy_text("<f8", "(2, 3)")) + values), kTwoRows);
  EXPECT_EQ(npy_rows(npy_start(npy_text("<f8", "(2, 3)"), 2) + values), kTwoRows);
  // Keys in any order, other quotes, no last comma, blanks as numpy.save adds them.
  EXPECT_EQ(
      npy_rows(npy_start("{\"shape\": (2,3), \"fortran_order\":False,'descr':\"<f8\"}      \n") +
               values),
      kTwoRows);
  EXPECT_TRUE(npy_rows(npy_start(npy_text("<f8", "(0, 3)"))).empty());
}

TEST(NpyRows, OfFloatsAreTheSameNumbers) {
  EXPECT_EQ(npy_rows(npy_start(npy_text("<f4", "(1, 3)")) + numbers<float>({0.1F, -0.0F, 3e38F})),
            (std::vector<std::vector<double>>{{0.1F, -0.0F, 3e38F}}));
}

TEST(NpyRows, TakeInfinityWhereAColumnMayBeInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto file = [](const std::vector<double>& row) {
    return npy_start(npy_text("<f8", "(1, 4)")) + numbers(row);
  };
  EXPECT_EQ(npy_rows(file({1, 2, 3, kInfinity})),
            (std::vector<std::vector<double>>{{1, 2, 3, kInfinity}}));
  expect_refused_array(file({1, -kInfinity, 3, 4}), ErrorKind::not_finite,
                       "rows.npy, row 0: y is infinite, not a finite number");
  expect_refused_array(file({1, 2, 3, std::numeric_limits<double>::quiet_NaN()}),
                       ErrorKind::not_finite, "row 0: length is nan");
}

TEST(NpyRows, AreRefusedWhereTheyAreOfAnotherKind) {
  const auto refused = [](const std::string& text, const std::string& words) {
    expect_refused_array(npy_start(text), ErrorKind::bad_file, words);
  };
  refused(npy_text(">f8", "(2, 3)"), "\">f8\", which is big-endian; save array.astype('<f8')");
  refused(npy_text(">f4", "(2, 3)"), "big-endian");
  refused(npy_text("|O", "(2, 3)"), "it holds objects of Python");
  refused(npy_text("<i8", "(2, 3)"), "\"<i8\", not little-endian floats of 4 or 8 bytes");
  refused(npy_text("<f8", "(2, 3)", "True"),
          "Fortran order, column by column; save numpy.ascontiguousarray(array)");
  refused("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (2,), }\n",
          "an array of records");
  refused(npy_text("<f8", "(2, 5)"),
          "the array has the shape (2, 5); give things as (N, 3), (N, 4)");
  refused(npy_text("<f8", "(3,)"), "the shape (3,)");
  refused(npy_text("<f8", "()"), "the shape ()");
  refused(npy_text("<f8", "(2, 3, 1)"), "the shape (2, 3, 1)");
  refused(npy_text("<f8", "(2, -3)"), "whole numbers");
  refused(npy_text("<f8", "(99999999999999999999, 3)"), "whole numbers");
  refused(npy_text("<f8", "(2, 3)", "None"), "neither True nor False");
  refused("{'descr': '<f8', 'shape': (2, 3), }", "lacks descr, fortran_order or shape");
  refused("{'descr': '<f8', 'size': 1}", "the unknown key \"size\"");
  refused("hello", "its header is \"hello\"");
  refused("{'descr", "not that of a NumPy array");
  refused("", "not that of a NumPy array");
}

TEST(NpyRows, AreRefusedWhereTheFileIsCut) {
  const std::string whole =
      npy_start(npy_text("<f8", "(2, 3)")) + numbers({1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  for (std::size_t size = 6; size < whole.size(); ++size) {
    expect_refused_array(whole.substr(0, size), ErrorKind::bad_file, "ends ");
  }
  expect_refused_array(whole.substr(0, whole.size() - 1), ErrorKind::bad_file,
                       "ends after 1 of 2 rows");
  expect_refused_array(whole + "x", ErrorKind::bad_file, "more bytes follow the 2 rows");
  expect_refused_array(npy_start(npy_text("<f8", "(2, 3)"), 4), ErrorKind::bad_file,
                       "format version 4 is not known");
  // An array that states more than any file holds is read row by row, too.
  expect_refused_array(npy_start(npy_text("<f8", "(18446744073709551615, 3)")), ErrorKind::bad_file,
                       "ends after 0 of 18446744073709551615 rows");
  expect_refused_array("\x93NUMPY\x02" + std::string("\0\xff\xff\xff\xff", 5), ErrorKind::bad_file,
                       "a header of 4294967295 bytes");
}

TEST(NpyRows, AreKnownByTheirFirstBytes) {
  const TemporaryFolder folder;
  write_content(folder.path() / "rows.csv",
                npy_start(npy_text("<f8", "(1, 3)")) + numbers({1.0, 2.0, 3.0}));
  RowReader reader(folder.path() / "rows.csv", "things", kNpyHeaders);
  EXPECT_EQ(reader.columns(), kNpyHeaders[0]);
  EXPECT_EQ((*reader.next())[2], 3);
  const Error fault = reader.fault(Error(ErrorKind::usage, "x is odd", "give another"));
  EXPECT_NE(fault.place().find("rows.csv, row 0: x is odd"), std::string::npos);
  write_content(folder.path() / "rows.npy", "x,y,z\n1,2,3\n");
  EXPECT_EQ((*RowReader(folder.path() / "rows.npy", "things", kNpyHeaders).next())[2], 3);
}

TEST(NpyRows, OfAPipeAreReadyWhenTheyAreWhole) {
  const TemporaryFolder folder;
  Pipe pipe(folder.path() / "rows", npy_start(npy_text("<f8", "(2, 3)")));
  RowReader reader(pipe.path(), "things", kNpyHeaders);
  EXPECT_FALSE(reader.ready());
  pipe.give(numbers({1.0, 2.5}));
  EXPECT_FALSE(reader.ready());
  pipe.give(numbers({-3.0}));
  EXPECT_TRUE(reader.ready());
  EXPECT_EQ((*reader.next())[1], 2.5);
  EXPECT_FALSE(reader.ready());
}

TEST(NpyRows, NeedNoMoreMemoryForManyRows) {
  const TemporaryFolder folder;
  constexpr std::size_t kRows = 200000;  // many buffers, and rows that lie across their ends
  std::string content = npy_start(npy_text("<f4", "(" + std::to_string(kRows) + ", 3)"));
  for (std::size_t i = 0; i < kRows; ++i) {
    content += numbers<float>({static_cast<float>(i), 1, 2});
  }
  write_content(folder.path() / "rows.npy", content);
  RowReader reader(folder.path() / "rows.npy", "things", kNpyHeaders);
  for (std::size_t i = 0; i < kRows; ++i) {
    ASSERT_EQ((*reader.next())[0], static_cast<double>(i));
  }
  EXPECT_FALSE(reader.next());
}

/// The poses of an array of this shape.
std::vector<Pose> npy_poses(const std::string& shape, const std::vector<double>& values) {
  const TemporaryFolder folder;
  write_content(folder.path() / "poses.npy", npy_start(npy_text("<f8", shape)) + numbers(values));
  return read_poses(folder.path() / "poses.npy");
}

TEST(NpyPoses, AreShiftsQuaternionsOrMatrices) {
  const Pose shift = Pose::translation(1, 2, 3);
  const std::vector<double> lines{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3};
  std::vector<double> whole = lines;
  whole.insert(whole.end(), {0, 0, 0, 1});
  EXPECT_EQ(npy_poses("(1, 3)", {1, 2, 3}), std::vector{shift});
  EXPECT_EQ(npy_poses("(1, 7)", {1, 2, 3, 1, 0, 0, 0}), std::vector{shift});
  EXPECT_EQ(npy_poses("(1, 12)", lines), std::vector{shift});
  EXPECT_EQ(npy_poses("(1, 3, 4)", lines), std::vector{shift});
  EXPECT_EQ(npy_poses("(1, 4, 4)", whole), std::vector{shift});
  whole[14] = 0.5;
  expect_refused([&] { static_cast<void>(npy_poses("(1, 4, 4)", whole)); }, ErrorKind::bad_file,
                 "row 0: the last line of the matrix is not 0, 0, 0, 1");
  expect_refused([&] { static_cast<void>(npy_poses("(1, 4, 3)", lines)); }, ErrorKind::bad_file,
                 "give poses as (N, 3), (N, 7), (N, 12), (N, 3, 4), (N, 4, 4)");
  expect_refused([&] { static_cast<void>(npy_poses("(1, 3, 4)", std::vector<double>(12, 0.5))); },
                 ErrorKind::not_rigid, "row 0");
}

/// CRC-32, bit by bit.
std::uint32_t checksum_of(const std::string& bytes) {
  std::uint32_t state = 0xffffffffU;
  for (const char c : bytes) {
    state ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) {
      state = (state >> 1) ^ ((state & 1U) != 0 ? 0xedb88320U : 0U);
    }
  }
  return ~state;
}

/// A file of an archive, and how it is stored.
struct Stored {
  std::string name;
  std::string content;
  std::uint64_t method = 0;
};

/// An archive of these files; `wide`: with sizes and places in 64 bits, as soms itself writes.
std::string npz(const std::vector<Stored>& files, bool wide = false) {
  std::string bytes;
  std::string directory;
  for (const auto& [name, content, method] : files) {
    const std::string sizes = bytes_of(content.size(), 8) + bytes_of(content.size(), 8);
    const std::string local = wide ? bytes_of(1, 2) + bytes_of(16, 2) + sizes : "";
    const std::string extra =
        wide ? bytes_of(1, 2) + bytes_of(24, 2) + sizes + bytes_of(bytes.size(), 8) : "";
    const std::uint64_t size = wide ? 0xffffffffU : content.size();
    const std::string shared = bytes_of(0, 2) + bytes_of(method, 2) + bytes_of(0, 4) +
                               bytes_of(checksum_of(content), 4) + bytes_of(size, 4) +
                               bytes_of(size, 4) + bytes_of(name.size(), 2);
    directory += "PK\x01\x02" + bytes_of(45, 2) + bytes_of(45, 2) + shared +
                 bytes_of(extra.size(), 2) + bytes_of(0, 10) +
                 bytes_of(wide ? 0xffffffffU : bytes.size(), 4) + name + extra;
    bytes += "PK\x03\x04" + bytes_of(45, 2) + shared + bytes_of(local.size(), 2) + name + local +
             content;
  }
  const std::size_t at = bytes.size();
  bytes += directory;
  if (wide) {
    const std::size_t record = bytes.size();
    bytes += "PK\x06\x06" + bytes_of(44, 8) + bytes_of(45, 2) + bytes_of(45, 2) + bytes_of(0, 8) +
             bytes_of(files.size(), 8) + bytes_of(files.size(), 8) + bytes_of(directory.size(), 8) +
             bytes_of(at, 8);
    bytes += "PK\x06\x07" + bytes_of(0, 4) + bytes_of(record, 8) + bytes_of(1, 4);
  }
  return bytes + "PK\x05\x06" + bytes_of(0, 4) + bytes_of(wide ? 0xffffU : files.size(), 2) +
         bytes_of(wide ? 0xffffU : files.size(), 2) + bytes_of(directory.size(), 4) +
         bytes_of(wide ? 0xffffffffU : at, 4) + bytes_of(0, 2);
}

const std::string& array_of_two() {
  static const std::string array =
      npy_start(npy_text("<f8", "(2, 3)")) + numbers({1.0, 2.5, -3.0, 0.0, 1e300, 0x1p-1074});
  return array;
}

TEST(NpzArray, IsReadIfItIsTheOnlyOne) {
  for (const bool wide : {false, true}) {
    EXPECT_EQ(npy_rows(npz({{"arr_0.npy", array_of_two()}}, wide)), kTwoRows);
    EXPECT_EQ(npy_rows(npz({{"readme.txt", "x"}, {"any.npy", array_of_two()}}, wide)), kTwoRows);
  }
  EXPECT_TRUE(npy_rows(npz({{"arr_0.npy", npy_start(npy_text("<f8", "(0, 3)"))}})).empty());
}

TEST(NpzArray, IsChosenByItsNameAmongOthers) {
  const std::string other = npy_start(npy_text("<f8", "(1, 3)")) + numbers({7.0, 8.0, 9.0});
  EXPECT_EQ(npy_rows(npz({{"a.npy", other}, {"things.npy", array_of_two()}})), kTwoRows);
  expect_refused_array(npz({{"a.npy", other}, {"b.npy", array_of_two()}}), ErrorKind::bad_file,
                       "several arrays: \"a\", \"b\"; save one array, or name it \"things\"");
}

TEST(NpzArray, SaysWhatIsWrong) {
  expect_refused_array(npz({{"a.npy", array_of_two(), 8}}), ErrorKind::unsupported,
                       "\"a.npy\": a compressed array; save it with numpy.savez");
  expect_refused_array(npz({{"a.txt", "x"}}), ErrorKind::bad_file, "without an array of NumPy");
  expect_refused_array(npz({{"a.npy", "x"}}), ErrorKind::bad_file, "\"a.npy\": no array of NumPy");
  expect_refused_array(npz({{"a.npy", array_of_two() + "x"}}), ErrorKind::bad_file,
                       "more bytes follow the 2 rows");
  const std::string whole = npz({{"a.npy", array_of_two()}});
  expect_refused_array(whole.substr(0, whole.size() / 2), ErrorKind::bad_file,
                       "cut off or damaged");
}

TEST(NpzArray, IsRefusedWhereAMemberIsDamaged) {
  for (const bool wide : {false, true}) {
    const std::string whole =
        npz({{"things.npy", array_of_two()}, {"note.txt", "words of somebody"}}, wide);
    for (const auto& [content, member] : {std::pair(array_of_two(), "things.npy"),
                                          {std::string("words of somebody"), "note.txt"}}) {
      const std::size_t begin = whole.find(content);
      for (std::size_t at = begin; at < begin + content.size(); ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        expect_refused_array(changed, ErrorKind::bad_file,
                             "\"" + std::string(member) + "\": its checksum (CRC-32) is wrong");
      }
    }
  }
}

TEST(NpzArray, IsRefusedWhereANameStandsTwice) {
  const std::string other = npy_start(npy_text("<f8", "(1, 3)")) + numbers({7.0, 8.0, 9.0});
  for (const std::string& second : {other, array_of_two()}) {
    expect_refused_array(npz({{"things.npy", array_of_two()}, {"things.npy", second}}),
                         ErrorKind::bad_file, "\"things.npy\": two members have this name");
  }
}

TEST(NpzArray, ThatIsDamagedGivesATypedError) {
  for_each_case("io/npz", 3000, [](Rng& rng) {
    const std::string content = damaged(
        npz({{"a.npy", array_of_two()}, {"things.npy", array_of_two()}}, rng.below(2) == 0), rng);
    try {
      for (const std::vector<double>& row : npy_rows(content)) {
        EXPECT_EQ(row.size(), 3U);
      }
    } catch (const Error& error) {
      EXPECT_NE(error.kind(), ErrorKind::usage);
    }
  });
}

}  // namespace
}  // namespace soms::test
