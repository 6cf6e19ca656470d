// The child that reads other formats: what it may do wrong, by scripts in its place, and what it
// does right, where it was built.
#include "soms/io/detail/import/import.h"

#include "soms/base/error.h"
#include "soms/io/detail/import/import_program.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/pipe.h"
#include "tests/support/support.h"
#include "tests/support/wait.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace soms::test {
namespace {

/// What stands for soms-import while the object lives.
class InPlace {
 public:
  explicit InPlace(const std::filesystem::path& program) {
    setenv("SOMS_IMPORT", program.c_str(), 1);
  }

  ~InPlace() { unsetenv("SOMS_IMPORT"); }

  InPlace(const InPlace&) = delete;
  InPlace& operator=(const InPlace&) = delete;
};

/// A script that writes the bytes it was made with.
const std::string kWrite = "cat \"$0.answer\"";

/// Reads a model while a shell script stands for soms-import.
class ImportedBy {
 public:
  explicit ImportedBy(const std::string& script, const std::string& answer = {})
      : in_place_(folder_.path() / "fake") {
    write_content(program().string() + ".answer", answer);
    write_content(program(), "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
  }

  [[nodiscard]] Mesh read(const ReadOptions& options = {}, std::stop_token stop = {}) const {
    const std::string model = "a model";
    return read_mesh(std::as_bytes(std::span(model)), "town/a.lwo", options, {.stop = stop});
  }

  void expect_refused(ErrorKind kind, const std::string& words,
                      const ReadOptions& options = {}) const {
    SCOPED_TRACE(words);
    const auto refusal = refusal_of([&] { static_cast<void>(read(options)); });
    ASSERT_TRUE(refusal) << "nothing was refused";
    EXPECT_EQ(name(refusal->kind), name(kind)) << refusal->words;
    EXPECT_NE(refusal->words.find(words), std::string::npos) << refusal->words;
    EXPECT_NE(refusal->words.find("town/a.lwo"), std::string::npos) << refusal->words;
  }

 private:
  [[nodiscard]] std::filesystem::path program() const { return folder_.path() / "fake"; }

  TemporaryFolder folder_;
  InPlace in_place_;
};

const std::string kMagic = "soms-import 1\n";

/// A record that begins with this letter.
std::string record(char kind, const std::string& rest) {
  std::string bytes(1, kind);
  bytes += rest;
  return bytes;
}

std::string vertex(double x, double y, double z) {
  return record('v', bytes_of(x) + bytes_of(y) + bytes_of(z));
}

std::string text(char kind, const std::string& words) {
  return record(kind, bytes_of(words.size(), 4) + words);
}

std::string face(const std::vector<std::uint64_t>& corners) {
  std::string bytes = record('f', bytes_of(corners.size(), 4));
  for (const std::uint64_t corner : corners) {
    bytes += bytes_of(corner, 4);
  }
  return bytes;
}

const std::string kCorners =
    vertex(0, 0, 0) + vertex(1, 0, 0) + vertex(1, 1, 0) + vertex(0, 1, 0.25);

TEST(Import, TakesVerticesFacesPartsAndNotes) {
  const Mesh mesh =
      ImportedBy(kWrite, kMagic + text('n', "a note\n") + kCorners + text('b', "outer") +
                             face({0, 1, 2, 3}) + text('b', "empty") + "e" + text('b', "inner") +
                             face({0, 2, 3}) + "ee" + ".")
          .read();
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 3}};
  EXPECT_EQ(mesh.triangles, triangles);
  EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(mesh.vertices[3], (Vec3{0, 1, 0.25}));
  const std::vector<Part> parts = {{"outer", Part::kNoParent, 0, 3}, {"inner", 0, 2, 1}};
  EXPECT_EQ(mesh.parts, parts);
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{"a note?"}));
  EXPECT_EQ(mesh.source, "town/a.lwo");
}

TEST(Import, StrictNamesTheFirstNotesAndCountsTheOthers) {
  std::string notes;
  for (const char c : std::string("abcdefghijkl")) {
    notes += text('n', std::string("note ") + c);
  }
  ImportedBy(kWrite, kMagic + notes + kCorners + face({0, 1, 2}) + ".")
      .expect_refused(ErrorKind::bad_file,
                      "town/a.lwo: note a; note b; note c; note d; note e; note f; note g; note h; "
                      "and 4 more notes; convert the model first",
                      {.strict = true});
}

TEST(Import, TakesUnitAndAxis) {
  const Mesh mesh = ImportedBy(kWrite, kMagic + record('u', bytes_of(0.0254)) + "ax" + kCorners +
                                           face({0, 1, 2}) + ".")
                        .read();
  EXPECT_EQ(mesh.unit, 0.0254);
  EXPECT_EQ(mesh.up, UpAxis::x);
}

/// The record of a georeference with these numbers of a map conversion.
std::string georeference(const std::string& crs, const std::string& datum,
                         const std::vector<double>& map) {
  std::string bytes = text('g', crs) + bytes_of(datum.size(), 4) + datum;
  bytes += bytes_of(map.empty() ? 0 : 1, 4);
  for (const double number : map) {
    bytes += bytes_of(number);
  }
  return bytes;
}

Mesh imported_in(const std::string& place) {
  return ImportedBy(kWrite, kMagic + place + kCorners + face({0, 1, 2}) + ".").read();
}

TEST(Import, TakesAGeoreference) {
  EXPECT_TRUE(imported_in("").georeference.empty());
  EXPECT_EQ(imported_in(georeference("epsg:25833", "DHHN2016", {})).georeference,
            (Georeference{.crs = "EPSG:25833", .vertical_datum = "DHHN2016"}));
  const Georeference whole =
      imported_in(georeference("EPSG:2263", "", {1, 2, 3, 0.6, 0.8, 5, 6, 7, 8, 0})).georeference;
  EXPECT_EQ(whole.map_conversion, (MapConversion{1, 2, 3, 0.6, 0.8, 5, {6, 7, 8}, 1200.0 / 3937}))
      << "the unit of the system, as none is stated";
  EXPECT_EQ(imported_in(georeference("EPSG:2263", "", {0, 0, 0, 1, 0, 1, 1, 1, 1, 0.3048}))
                .georeference.map_conversion->unit,
            0.3048);
  const ImportedBy cut(kWrite, kMagic + georeference("EPSG:2263", "", {1, 2, 3}));
  cut.expect_refused(ErrorKind::bad_file, "it is cut off");
  const ImportedBy infinite(kWrite,
                            kMagic + georeference("", "", {1, 2, 3, 4, 5, 6, 7, 8, HUGE_VAL, 0}));
  infinite.expect_refused(ErrorKind::bad_file, "not finite");
}

TEST(Import, GivesTheModelAndItsExtensionAndNothingElse) {
  // The script fails unless all is as it should be: one argument, the model, no more open files.
  const ImportedBy imported(R"sh([ "$*" = .lwo ] || exit 10
[ "$(cat)" = "a model" ] || exit 11
[ ! -e /proc/self/fd/3 ] || exit 12
[ "$(ulimit -c)" = 0 ] || exit 13
echo "all is well"; exit 1)sh");
  imported.expect_refused(ErrorKind::bad_file,
                          "town/a.lwo: soms-import cannot read it as .lwo: all is well; check");
}

TEST(Import, TurnsACrashOrNonsenseIntoAnError) {
  ImportedBy("kill -SEGV $$")
      .expect_refused(ErrorKind::bad_file, "crashed (signal 11, memory limit");
  ImportedBy("exit 4").expect_refused(ErrorKind::out_of_memory, "exceeds its memory limit of");
  ImportedBy("exit 9").expect_refused(ErrorKind::bad_file, "ended with status 9");
  ImportedBy("true").expect_refused(ErrorKind::bad_file,
                                    "does not begin with the expected signature");
  ImportedBy("echo '<html>'")
      .expect_refused(ErrorKind::bad_file, "gave an invalid answer at byte 0");
  const auto refuse = [](const std::string& records, ErrorKind kind, const std::string& words) {
    ImportedBy(kWrite, kMagic + records).expect_refused(kind, words);
  };
  refuse(kCorners + face({0, 1, 4}) + ".", ErrorKind::bad_file,
         "vertex 4, but vertices are 0 to 3");
  refuse(kCorners + face({0, 1, 2}), ErrorKind::bad_file, "cut off");
  refuse(record('f', bytes_of(0xffffffff, 4)) + ".", ErrorKind::bad_file, "cut off");
  refuse(text('b', "a") + ".", ErrorKind::bad_file, "inside a part");
  refuse(kCorners + face({0, 1, 2}) + ".x", ErrorKind::bad_file, "continues after its end");
  refuse("e.", ErrorKind::bad_file, "has not begun");
  refuse("aw.", ErrorKind::bad_file, "the up axis must be x, y or z");
  for (const double unit : {0.0, -1.0, std::nan("")}) {
    refuse(record('u', bytes_of(unit)) + ".", ErrorKind::bad_file,
           "the unit is not a positive number");
  }
  refuse("?", ErrorKind::bad_file, "unknown kind");
  refuse(vertex(0, std::nan(""), 0), ErrorKind::not_finite, "vertex 0: y of a vertex");
  refuse(vertex(0, 0, 1e200), ErrorKind::out_of_range, "z of a vertex exceeds 2^300");
  refuse(kCorners + ".", ErrorKind::empty_mesh, "no triangles (4 vertices)");
}

TEST(Import, EndsAChildThatHangs) {
  // Its own child would keep the pipe open.
  ImportedBy("sleep infinity")
      .expect_refused(ErrorKind::timed_out, "within 0.2 s", {.import_seconds = 0.2});
  ImportedBy("exec >&-; sleep infinity")
      .expect_refused(ErrorKind::timed_out, "did not end", {.import_seconds = 0.2});
}

TEST(Import, TakesATimeThatIsNoNumberForNone) {
  for (const double seconds : {std::nan(""), -1.0, 0.0}) {
    ImportedBy("sleep infinity")
        .expect_refused(ErrorKind::timed_out, "did not end within 0 s",
                        {.import_seconds = seconds});
  }
}

// Ended children are collected by the system then: their numbers may soon be those of others.
TEST(Import, KillsNothingByTheNumberOfAChildThatTheSystemCollected) {
  const TemporaryFolder folder;
  const std::filesystem::path alive = folder.path() / "alive";
  const Pipe sign(folder.path() / "sign");

  struct sigaction ignore {};

  ignore.sa_handler = SIG_IGN;

  struct sigaction before {};

  ASSERT_EQ(sigaction(SIGCHLD, &ignore, &before), 0);
  const auto refusal = refusal_of([&] {
    const Mesh mesh = ImportedBy(kWrite + "\n(read word < '" + sign.path() + "'; : > '" +
                                     alive.string() + "') > /dev/null 2>&1 &",
                                 kMagic + kCorners + face({0, 1, 2}) + ".")
                          .read();
    EXPECT_EQ(mesh.triangles.size(), 1U);
  });
  sigaction(SIGCHLD, &before, nullptr);
  EXPECT_FALSE(refusal) << refusal->words;
  sign.give("go\n");
  wait_until([&] { return std::filesystem::exists(alive); });
}

TEST(Import, LooksForTheProgramInNoFolderThatIsNotKnown) {
  using Folders = std::vector<std::filesystem::path>;
  EXPECT_EQ(detail::import_folders("", ""), Folders());
  EXPECT_EQ(detail::import_folders("soms", "lib/libsoms.so"), Folders());
  EXPECT_EQ(detail::import_folders("/a/bin/soms", ""), (Folders{"/a/bin", "/a/libexec/soms"}));
  EXPECT_EQ(detail::import_folders("", "/a/lib/x86/libsoms.so"), (Folders{"/a/libexec/soms"}));
  EXPECT_EQ(detail::import_folders("", "/a/lib/libsoms.so"), (Folders{"/a/libexec/soms"}));
}

TEST(Import, EndsAChildWhenRequestedToStop) {
  const TemporaryFolder folder;
  const std::filesystem::path started = folder.path() / "started";
  const ImportedBy imported(": > '" + started.string() + "'; sleep infinity");
  std::stop_source stop;
  const std::jthread later([&] {
    wait_until([&] { return std::filesystem::exists(started); });
    stop.request_stop();
  });
  expect_refused([&] { static_cast<void>(imported.read({}, stop.get_token())); },
                 ErrorKind::cancelled, "");
}

TEST(Import, BoundsTheMemoryOfTheChildAndOfItsAnswer) {
  ImportedBy("a=aaaaaaaaaaaaaaaa; while :; do a=$a$a; done")
      .expect_refused(ErrorKind::bad_file, "memory limit 287 MiB", {.max_memory = 32 << 20});
  ImportedBy("yes").expect_refused(ErrorKind::out_of_memory, "exceeds the memory limit by",
                                   {.max_memory = 1 << 20});
}

TEST(Import, CountsNotesTowardsTheMemory) {
  std::string notes;  // of no words, each five bytes of the answer
  for (int i = 0; i < 50'000; ++i) {
    notes += text('n', "");
  }
  ImportedBy(kWrite, kMagic + notes + kCorners + face({0, 1, 2}) + ".")
      .expect_refused(ErrorKind::out_of_memory, "exceeds the memory limit by",
                      {.max_memory = 2 << 20});
}

TEST(Import, SaysHowToGetAProgramThatIsMissing) {
  const InPlace nothing("/nonexistent/soms-import");
  expect_refused("a model", "a.fbx", ErrorKind::unsupported, "SOMS_IMPORT does not name a program");
}

TEST(Import, LeavesToItsReaderWhatSomsReadsItself) {
  for (const char* own :
       {".ply", ".3ds", ".stl", ".off", ".obj", ".dae", ".gltf", ".glb", ".xyz"}) {
    EXPECT_FALSE(detail::is_imported(own)) << own;
  }
  for (const char* other : {".3d", ".fbx", ".blend", ".x", ".x3d", ".zgl"}) {
    EXPECT_TRUE(detail::is_imported(other)) << other;
  }
}

#ifdef SOMS_IMPORT_PROGRAM
/// A sheet of a quad and a triangle in AC3D, moved by (1, 2, 3), and a line.
const std::string kSheet = R"(AC3Db
MATERIAL "a" rgb 1 1 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0
OBJECT world
kids 1
OBJECT poly
name "sheet"
loc 1 2 3
numvert 5
0 0 0
1 0 0
1 1 0
0 1 0
0.5 0.5 2
numsurf 2
SURF 0x30
mat 0
refs 4
0 0 0
1 0 0
2 0 0
3 0 0
SURF 0x30
mat 0
refs 3
0 0 0
1 0 0
4 0 0
kids 0
)";

TEST(Import, ReadsAModelByAssimp) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  const Mesh mesh = read_text(kSheet, "sheet.ac");
  ASSERT_EQ(mesh.triangles.size(), 3U);
  EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(mesh.triangle(0).a, (Vec3{1, 2, 3}));
  EXPECT_EQ(mesh.triangle(0).c, (Vec3{2, 3, 3}));
  EXPECT_EQ(mesh.triangle(2).c, (Vec3{1.5, 2.5, 5}));
  ASSERT_EQ(mesh.parts.size(), 1U);
  EXPECT_EQ(mesh.parts[0].name, "sheet");
  EXPECT_EQ(mesh.notes.at(0).substr(0, 14), "read by Assimp");
}

/// The corners (1, 2, 3), (11, 2, 3) and (1, 22, 33) as DXF has them.
const std::string kDxf =
    "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\nroof\n10\n1\n20\n2\n30\n3\n11\n11\n21\n2\n31\n3\n"
    "12\n1\n22\n22\n32\n33\n13\n1\n23\n22\n33\n33\n0\nENDSEC\n0\nEOF\n";
const std::string kX =
    "xof 0303txt 0032\nMesh m {\n3;\n1.0;2.0;3.0;,\n11.0;2.0;3.0;,\n1.0;22.0;33.0;;\n"
    "1;\n3;0,1,2;;\n}\n";
/// In inches, x up.
const std::string kFbx = R"(; FBX 7.3.0 project file
FBXHeaderExtension: {
  FBXHeaderVersion: 1003
  FBXVersion: 7300
}
GlobalSettings: {
  Properties70: {
    P: "UpAxis", "int", "Integer", "",0
    P: "UnitScaleFactor", "double", "Number", "",2.5
  }
}
Definitions: {
  ObjectType: "Model" {
    Count: 1
  }
}
Objects: {
  Geometry: 100, "Geometry::m", "Mesh" {
    Vertices: *9 {
      a: 1,2,3,11,2,3,1,22,33
    }
    PolygonVertexIndex: *3 {
      a: 0,1,-3
    }
  }
  Model: 200, "Model::m", "Mesh" {
    Version: 232
  }
}
Connections: {
  C: "OO",200,0
  C: "OO",100,200
}
)";
/// In millimeters.
const std::string kIfc = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#3=IFCUNITASSIGNMENT((#1));
#4=IFCCARTESIANPOINT((0.,0.,0.));
#7=IFCAXIS2PLACEMENT3D(#4,$,$);
#8=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#7,$);
#13=IFCOWNERHISTORY($,$,$,.ADDED.,$,$,$,0);
#14=IFCPROJECT('1',#13,'p',$,$,$,$,(#8),#3);
#15=IFCLOCALPLACEMENT($,#7);
#16=IFCSITE('2',#13,'s',$,$,#15,$,$,.ELEMENT.,$,$,$,$,$);
#17=IFCRELAGGREGATES('3',#13,$,$,#14,(#16));
#20=IFCCARTESIANPOINT((1000.,2000.,3000.));
#21=IFCCARTESIANPOINT((11000.,2000.,3000.));
#22=IFCCARTESIANPOINT((1000.,22000.,33000.));
#23=IFCPOLYLOOP((#20,#21,#22));
#24=IFCFACEOUTERBOUND(#23,.T.);
#25=IFCFACE((#24));
#26=IFCCONNECTEDFACESET((#25));
#27=IFCFACEBASEDSURFACEMODEL((#26));
#28=IFCSHAPEREPRESENTATION(#8,'Body','SurfaceModel',(#27));
#29=IFCPRODUCTDEFINITIONSHAPE($,$,(#28));
#30=IFCBUILDINGELEMENTPROXY('4',#13,'m',$,$,#15,#29,$,$);
#31=IFCRELCONTAINEDINSPATIALSTRUCTURE('5',#13,$,$,(#30),#16);
ENDSEC;
END-ISO-10303-21;
)";

/// `text` with `word` replaced.
std::string with(std::string text, const std::string& word, const std::string& other) {
  return text.replace(text.find(word), word.size(), other);
}

TEST(Import, FbxKeepsItsUnitWhereItsUpAxisPointsDown) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  const Mesh mesh =
      read_text(with(kFbx, "    P: \"UnitS",
                     "    P: \"UpAxisSign\", \"int\", \"Integer\", \"\",-1\n    P: \"UnitS"),
                "a.fbx");
  EXPECT_EQ(mesh.unit, 0.025);
  EXPECT_EQ(mesh.up, UpAxis::unknown);
  EXPECT_NE(mesh.notes.at(0).find("declares that x points down"), std::string::npos)
      << mesh.notes.at(0);
}

TEST(Import, FbxUnitIsTheDecimalThatTheFileHolds) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  const std::string millimeters = with(kFbx, "2.5", "0.1");
  EXPECT_EQ(read_text(millimeters, "a.fbx").unit, 0.001);
  const std::string rough = with(millimeters, "\"double\"", "\"float\"");
  EXPECT_EQ(read_text(rough, "a.fbx").unit, 0.001);
}

TEST(Import, StrictSaysToConvertWhatAlwaysHasANote) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  expect_refused(
      [] { (void)read_text(kFbx, "a.fbx", {.strict = true}); }, ErrorKind::bad_file,
      "; convert the model first (soms convert IN OUT.glb), or read it without `strict`");
}

TEST(Import, SaysThatAUnitIsNotRead) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  EXPECT_NE(read_text(kDxf, "a.dxf").notes.at(0).find("the unit is not read"), std::string::npos);
}

TEST(Import, SaysOrUndoesWhatAssimpDoesToAxesAndUnits) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  const Triangle stored{{1, 2, 3}, {11, 2, 3}, {1, 22, 33}};
  const Mesh drawing = read_text(kDxf, "a.dxf");
  EXPECT_EQ(drawing.triangle(0), stored);
  EXPECT_EQ(drawing.up, UpAxis::unknown);
  EXPECT_NE(drawing.notes.at(0).find("its rotation from z up to y up was undone"),
            std::string::npos);
  const Mesh left_handed = read_text(kX, "a.x");
  EXPECT_EQ(left_handed.triangle(0), (Triangle{{1, 22, -33}, {11, 2, -3}, {1, 2, -3}}));
  EXPECT_NE(left_handed.notes.at(0).find("z is negated"), std::string::npos);
  const Mesh stated = read_text(kFbx, "a.fbx");
  EXPECT_EQ(stated.triangle(0), stored);
  EXPECT_EQ(stated.up, UpAxis::x);
  EXPECT_EQ(stated.unit, 0.025);
  const Mesh building = read_text(kIfc, "a.ifc");
  EXPECT_EQ(building.up, UpAxis::z);
  EXPECT_EQ(building.unit, 1);
  ASSERT_EQ(building.triangles.size(), 1U);
  EXPECT_NEAR(building.triangle(0).c.z, 33, 1e-5);
  EXPECT_NEAR(building.triangle(0).c.y, 22, 1e-5);
}

TEST(Import, NamesTheFileThatAssimpCannotRead) {
  const InPlace program(SOMS_IMPORT_PROGRAM);
  expect_refused("no model", "sheet.ac", ErrorKind::bad_file, "sheet.ac: soms-import cannot read");
  // A cut file is refused or gives a sound mesh of what is left.
  for (std::size_t size = 1; size < kSheet.size(); size += 97) {
    const auto refusal = refusal_of(
        [&] { check(read_text(kSheet.substr(0, size), "sheet.ac", {.allow_empty = true})); });
    EXPECT_TRUE(!refusal || refusal->kind == ErrorKind::bad_file) << refusal->words;
  }
}
#else
TEST(Import, ReadsAModelByAssimp) {
  GTEST_SKIP() << "soms-import was not built: Assimp is missing";
}
#endif

}  // namespace
}  // namespace soms::test
