// SPDX-License-Identifier: LGPL-2.1-or-later
// Models through files: nothing of them is lost, and files are whole or not there.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::volume;

namespace fs = std::filesystem;
using testing::Folder;
using testing::story;

int solids(const TopoDS_Shape& shape) {
  int count = 0;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) ++count;
  return count;
}

template <class Work>
std::string failure_of(Work&& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no failure";
}

Model box_model() {
  Model model;
  model.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box", {1, 0, 0});
  return model;
}

class StepUnits : public ::testing::TestWithParam<const char*> {};

TEST_P(StepUnits, StayWithNamesColoursLayersAndAssembly) {
  const Folder folder;
  testing::write_machine(folder / "in.step", GetParam());
  const Model model = read_model(folder / "in.step");
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_NEAR(volume(model.shape()), 40 * 30 * 10 + 2 * 8 * 8 * 20, 1e-6);

  write_model(model, folder / "out.stp");

  EXPECT_EQ(story(folder / "out.stp"), story(folder / "in.step"));
  EXPECT_NE(story(folder / "out.stp").find("Machine 0.000..40.000"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, StepUnits, ::testing::Values("MM", "INCH", "M", "CM", "FT"));

TEST(StepFiles, StayTheSameWhenTheUnitsOfOtherFilesCameBetween) {
  const Folder folder;
  testing::write_machine(folder / "inch.step", "INCH");
  testing::write_machine(folder / "metre.step", "M");
  const Model inch = read_model(folder / "inch.step"), metre = read_model(folder / "metre.step");
  write_model(inch, folder / "inch2.step");
  write_model(metre, folder / "metre2.step");
  EXPECT_EQ(story(folder / "inch2.step"), story(folder / "inch.step"));
  EXPECT_EQ(story(folder / "metre2.step"), story(folder / "metre.step"));
}

TEST(StepFiles, AreReadAndWrittenByThreadsOneAfterTheOther) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  std::vector<std::thread> threads;
  std::atomic<int> good = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for (int k = 0; k < 3; ++k) {
        const Model model = read_model(folder / "in.step");
        write_model(model, folder / ("out" + std::to_string(i) + ".step"));
        good += model.face_count() == 18;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 12);
}

TEST(StepFiles, KeepDimensionsOfFacesThatStay) {
  const Folder folder;
  testing::write_gauge(folder / "in.step");
  Model gauge = read_model(folder / "in.step");
  write_model(gauge, folder / "out.step");
  const std::string told = testing::story(folder / "out.step");
  EXPECT_EQ(told, testing::story(folder / "in.step"));
  const std::string dimension = "dimension 40 +0.1 -0.2 Left Right\n";
  EXPECT_NE(told.find(dimension), std::string::npos) << told;
  // The file of another model has the schema that most programs read.
  testing::write_machine(folder / "machine.step");
  write_model(read_model(folder / "machine.step"), folder / "other.step");
  EXPECT_NE(testing::content(folder / "other.step").find("AUTOMOTIVE_DESIGN"), std::string::npos);
  // Without another of its faces it still has it.
  gauge.replace_faces({{6, {}}});
  write_model(gauge, folder / "open.step");
  EXPECT_NE(testing::story(folder / "open.step").find(dimension), std::string::npos);
  gauge.replace_faces({{1, {}}});
  write_model(gauge, folder / "open.step");
  EXPECT_EQ(testing::story(folder / "open.step").find("dimension 40"), std::string::npos);
}

std::string told(const std::vector<WriteNote>& notes) {
  std::string text;
  for (const WriteNote& note : notes) text += note.text;
  return text;
}

TEST(StepFiles, ThatLoseWhatTouchesNoShapeAreTold) {
  const Folder folder;
  Model box;
  box.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box");
  EXPECT_EQ(told(write_model(box, folder / "box.step")), "");
  std::string text = testing::content(folder / "box.step");
  text.insert(text.find("ENDSEC;", text.find("DATA;")),
              "#9001=APPROVAL_STATUS('approved');\n#9002=APPROVAL(#9001,'');\n"
              "#9003=APPROVAL(#9001,'');\n#9004=GROUP('all',$);\n"
              "#9005=(ANNOTATION_OCCURRENCE()TESSELLATED_ANNOTATION_OCCURRENCE()NO_SUCH());\n");
  testing::write_content(folder / "more.step", text);

  const Model more = read_model(folder / "more.step");
  const std::string lost =
      "written without 1 annotation, 2 approvals and 1 group of the file that was read";
  EXPECT_EQ(told(write_model(more, folder / "out.step")),
            lost + ", which touch nothing that is written");
  EXPECT_EQ(told(write_model(more.copy(), folder / "out.iges")), lost);
  EXPECT_EQ(told(write_model(more, folder / "out.brep")), lost);
  EXPECT_EQ(told(write_model(read_model(folder / "out.step"), folder / "again.step")), "");
}

// Some systems write an assignment for each item.
TEST(StepFiles, KeepLayersHoweverManyAssignmentsSayThem) {
  const Folder folder;
  Model box;
  box.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "box");
  write_model(box, folder / "box.step");
  std::string text = testing::content(folder / "box.step");
  std::string layers;
  int faces = 0;
  for (std::size_t at = 0; (at = text.find("ADVANCED_FACE", at)) != std::string::npos; ++at) {
    const std::size_t begin = text.rfind('#', at);
    const std::string number = text.substr(begin, text.find_first_of(" =", begin) - begin);
    layers += "#" + std::to_string(9001 + faces) + "=PRESENTATION_LAYER_ASSIGNMENT('" +
              (faces % 3 == 0 ? "walls" : "rest") + "','',(" + number + "));\n";
    ++faces;
  }
  ASSERT_EQ(faces, 6);
  text.insert(text.find("ENDSEC;", text.find("DATA;")), layers);
  testing::write_content(folder / "layers.step", text);
  const Model read = read_model(folder / "layers.step");
  EXPECT_EQ(told(write_model(read, folder / "out.step")), "");
  EXPECT_EQ(told(write_model(read, folder / "out.iges")), "");
  EXPECT_EQ(told(write_model(read, folder / "out.brep")),
            "written without 2 layers of the file that was read");
  // One of its faces is left, which is in one of them.
  Model left = read.copy();
  left.replace_faces({{2, {}}, {3, {}}, {4, {}}, {5, {}}, {6, {}}});
  EXPECT_EQ(told(write_model(left, folder / "left.step")),
            "written without 1 layer of the file that was read, which touch nothing that is "
            "written");
}

TEST(NewModels, KeepNamesColoursPlacesAndNumbersThroughStep) {
  const Folder folder;
  gp_Trsf move;
  move.SetTranslation(gp_Vec(10, 0, 0));
  Model model = box_model();
  model.add(BRepPrimAPI_MakeSphere(1).Shape().Moved(TopLoc_Location(move)), "Kugel \xc3\xa4");
  EXPECT_EQ(model.face_count(), 7);
  EXPECT_TRUE(model.file().empty());
  write_model(model, folder / "out.step");
  const Model back = read_model(folder / "out.step");
  EXPECT_EQ(back.face_count(), 7);
  EXPECT_EQ(back.file(), folder / "out.step");
  EXPECT_NEAR(volume(back.shape()), volume(model.shape()), 1e-9);
  const std::string told = story(folder / "out.step");
  EXPECT_NE(told.find("box #FF0000 0.000..1.000 0.000..2.000 0.000..3.000 valid"),
            std::string::npos)
      << told;
  EXPECT_NE(told.find("9.000..11.000 -1.000..1.000 -1.000..1.000 valid"), std::string::npos)
      << told;
}

TEST(NewModels, HoldLooseEdgesToo) {
  const Folder folder;
  TopoDS_Compound edges;
  const BRep_Builder builder;
  builder.MakeCompound(edges);
  for (const double y : {0.0, 1.0})
    builder.Add(edges, BRepBuilderAPI_MakeEdge(gp_Pnt(0, y, 0), gp_Pnt(5, y, 1)).Edge());
  for (const char* name : {"edges.step", "edges.brep", "edges.iges"}) {
    Model model;
    model.add(edges, "curves");
    write_model(model, folder / name);
    int count = 0;
    const Model back = read_model(folder / name);
    for (TopExp_Explorer edge(back.shape(), TopAbs_EDGE); edge.More(); edge.Next()) ++count;
    EXPECT_EQ(count, 2) << name;
    EXPECT_EQ(back.face_count(), 0) << name;
  }
}

TEST(NewModels, RefuseNothingAndColoursThatAreNone) {
  Model model;
  EXPECT_EQ(failure_of([&] { model.add(TopoDS_Shape(), "part"); }), "the part 'part' has no shape");
  EXPECT_THROW(model.add(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "part", {1, 0}), BadModel);
  EXPECT_THROW(model.face(1), BadModel);
}

TEST(OtherFormats, KeepTheSolids) {
  const Folder folder;
  testing::write_machine(folder / "in.step");
  const Model model = read_model(folder / "in.step");
  for (const char* name : {"out.brep", "out.BRP", "out.iges", "out.IGS"}) {
    write_model(model, folder / name);
    const Model back = read_model(folder / name);
    EXPECT_EQ(back.face_count(), 18) << name;
    EXPECT_EQ(solids(back.shape()), 3) << name;
    EXPECT_NEAR(volume(back.shape()), volume(model.shape()), 1e-6) << name;
  }
}

TEST(OtherFormats, KeepInchesInIges) {
  const Folder folder;
  testing::write_machine(folder / "in.step", "INCH");
  write_model(read_model(folder / "in.step"), folder / "out.igs");
  EXPECT_NE(testing::content(folder / "out.igs").find("4HINCH"), std::string::npos);
  const Model back = read_model(folder / "out.igs");
  EXPECT_NEAR(volume(back.shape()), 40 * 30 * 10 + 2 * 8 * 8 * 20, 1e-6);
  write_model(back, folder / "out.step");
  EXPECT_EQ(story(folder / "out.step").substr(0, 7), "in INCH");
}

/// The file has them as UTF-8; other programs write Latin-1.
TEST(OtherFormats, KeepNamesOfAllLettersInIges) {
  const Folder folder;
  Model model;
  for (const char* name : {"Zahnrad \u00D840", "\u6b6f\u8eca", "plain"})
    model.add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), name);
  write_model(model, folder / "out.igs");
  const Model back = read_model(folder / "out.igs");
  EXPECT_EQ(back.part_paths().at(0), "Zahnrad \u00D840");
  EXPECT_EQ(back.part_paths().at(6), "\u6b6f\u8eca");
  EXPECT_EQ(back.part_paths().at(12), "plain");

  std::string text = testing::content(folder / "out.igs");
  const std::size_t place = text.find("12HZahnrad \u00D840;");
  ASSERT_NE(place, std::string::npos);
  text.replace(place, 16,
               "11HZahnrad \xD8"
               "40; ");
  testing::write_content(folder / "latin.igs", text);
  EXPECT_EQ(read_model(folder / "latin.igs").part_paths().at(0), "Zahnrad \u00D840");
}

TEST(OtherFormats, KeepControlPointsToSixteenDigits) {
  const Folder folder;
  testing::Random random(1);
  const auto surface = testing::random_spline_surface(random, true, false, false);
  Model model;
  model.add(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), "sheet");
  for (const char* name : {"sheet.step", "sheet.iges", "sheet.brep"}) {
    write_model(model, folder / name);
    const auto back = Handle(Geom_BSplineSurface)::DownCast(
        BRep_Tool::Surface(read_model(folder / name).face(1)));
    ASSERT_FALSE(back.IsNull()) << name;
    for (int i = 1; i <= surface->NbUPoles(); ++i)
      for (int j = 1; j <= surface->NbVPoles(); ++j) {
        EXPECT_LE(back->Pole(i, j).Distance(surface->Pole(i, j)), 4e-15) << name;
        EXPECT_NEAR(back->Weight(i, j), surface->Weight(i, j), 1e-15) << name;
      }
  }
}

// Without the curve of one of its edges in the parameters of its round face.
TopoDS_Shape rod_without_a_curve() {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const TopoDS_Face round = TopoDS::Face(TopExp_Explorer(rod, TopAbs_FACE).Current());
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(round, TopAbs_EDGE).Current());
  BRep_Builder().UpdateEdge(edge, Handle(Geom2d_Curve)(), round, BRep_Tool::Tolerance(edge));
  return rod;
}

TEST(OtherFormats, LeaveOutFacesWithoutCurvesInTheirParametersAndNameThem) {
  const Folder folder;
  Model model = box_model();
  model.add(rod_without_a_curve(), "rod");
  for (const char* name : {"a.step", "a.iges"}) {
    const std::vector<WriteNote> notes = write_model(model, folder / name);
    ASSERT_FALSE(notes.empty()) << name;
    EXPECT_TRUE(notes.front().shapes_lost);
    EXPECT_EQ(notes.front().text,
              "written without face 7, whose edge 13 has no curve in the parameters of the face: "
              "only BREP has such faces");
    EXPECT_EQ(read_model(folder / name).face_count(), 8) << name;
  }
  EXPECT_TRUE(write_model(model, folder / "a.brep").empty());
  EXPECT_EQ(read_model(folder / "a.brep").face_count(), 9);
}

TEST(OtherFormats, RefuseModelsOfWhichNoFaceIsLeft) {
  const Folder folder;
  Model model;
  const TopoDS_Shape rod = rod_without_a_curve();
  model.add(TopExp_Explorer(rod, TopAbs_FACE).Current(), "round");
  EXPECT_NE(failure_of([&] {
              write_model(model, folder / "a.step");
            }).find("a.step: nothing would be left: without face 1, whose edge 1 has no curve"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "a.step"));
}

TEST(Writing, RefusesUnknownEndingsFoldersAndMissingFolders) {
  const Folder folder;
  const Model model = box_model();
  fs::create_directory(folder / "folder.step");
  EXPECT_THROW(write_model(model, folder / "out.obj"), BadModel);
  EXPECT_EQ(failure_of([&] { write_model(model, folder / "folder.step"); }),
            (folder / "folder.step").string() + ": is a folder");
  EXPECT_EQ(failure_of([&] { write_model(model, folder / "no/out.step"); }),
            (folder / "no/out.step").string() + ": the folder '" + (folder / "no").string() +
                "' does not exist");
  EXPECT_THROW(write_model(Model(), folder / "out.step"), Failure);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"folder.step"});
}

TEST(Writing, RefusesFoldersAndFilesThatAreProtected) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is protected from root";
  const Folder folder;
  testing::write_content(folder / "kept.step", "old");
  fs::permissions(folder / "kept.step", fs::perms::owner_read);
  EXPECT_THROW(write_model(box_model(), folder / "kept.step"), Failure);
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(write_model(box_model(), folder / "new.step"), Failure);
  EXPECT_EQ(testing::content(folder / "kept.step"), "old");
}

/// Files cannot grow over a limit while this lives: a full disk, as far as a program can tell.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Writing, LeavesTheOldFileAndNothingElseWhenTheDiskIsFull) {
  const Folder folder;
  const Model model = box_model();
  for (const char* name : {"part.step", "part.iges", "part.brep"}) {
    testing::write_content(folder / name, "old");
    const std::string failure = failure_of([&] {
      const FullDisk full(1000);
      write_model(model, folder / name);
    });
    EXPECT_EQ(failure, (folder / name).string() + ": cannot be written: File too large");
    EXPECT_EQ(testing::content(folder / name), "old");
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"part.brep", "part.iges", "part.step"}));
}

// Asked twice: when the text is there, and when it is on the disk.
TEST(Writing, LeavesTheOldFileAndNothingElseWhenItIsStopped) {
  const Folder folder;
  const Model model = box_model();
  for (const char* name : {"part.step", "part.iges", "part.brep"})
    for (const int last : {1, 2}) {
      testing::write_content(folder / name, "old");
      int asked = 0;
      const auto stop = [&] {
        if (++asked == last) throw std::runtime_error("enough");
      };
      EXPECT_EQ(failure_of([&] { write_model(model, folder / name, stop); }), "enough");
      EXPECT_EQ(testing::content(folder / name), "old");
      EXPECT_EQ(folder.names(), std::vector<std::string>{name});
      if (last == 2) fs::remove(folder / name);
    }
}

// A killed program cannot tidy up, so there must be nothing to tidy: the file has no name yet.
TEST(Writing, ShowsNothingBeforeTheFileIsWhole) {
  const Folder folder;
  const int probe = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (probe < 0) GTEST_SKIP() << "the file system has no files without names";
  ::close(probe);
  std::vector<std::string> seen{"never asked"};
  write_text("text", folder / "out.txt", [&] { seen = folder.names(); });
  EXPECT_EQ(seen, std::vector<std::string>{});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
  EXPECT_EQ(testing::content(folder / "out.txt"), "text");
}

TEST(Writing, SaysThatADeviceIsFullAndLeavesItADevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_EQ(failure_of([] { write_text("text", "/dev/full"); }),
            "/dev/full: cannot be written: No space left on device");
  const Folder folder;
  fs::create_symlink("/dev/full", folder / "full.step");
  EXPECT_THROW(write_model(box_model(), folder / "full.step"), Failure);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"full.step"});
}

TEST(Writing, ReplacesFilesThroughLinksAndKeepsTheirRights) {
  const Folder folder;
  testing::write_content(folder / "real.txt", "old");
  ::chmod((folder / "real.txt").c_str(), 0640);
  fs::create_symlink("real.txt", folder / "link.txt");
  write_text("new", folder / "link.txt");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(testing::content(folder / "real.txt"), "new");
  struct stat status {};
  ::stat((folder / "real.txt").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(Writing, TakesNamesWithoutAFolder) {
  const Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  write_text("text", "plain.txt");
  fs::current_path(before);
  EXPECT_EQ(testing::content(folder / "plain.txt"), "text");
}

}  // namespace
}  // namespace blossom::occt
