// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP files of which Open CASCADE leaves something out without a word: it is told.

#include "adapters/occt/exchange/step/step_results.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;
using testing::write_content;
using Points = std::vector<std::array<double, 3>>;

/// Entities of a STEP file, numbered in the order in which they are added.
class StepWriting {
 public:
  std::string add(const std::string& entity) {
    text_ += "#" + std::to_string(++count_) + "=" + entity + ";\n";
    return "#" + std::to_string(count_);
  }

  std::string triple(const char* kind, const std::array<double, 3>& x) {
    return add(std::string(kind) + "(''," + numbers(x) + ")");
  }

  std::string axes(const std::array<double, 3>& at = {0, 0, 0}) {
    const std::string point = triple("CARTESIAN_POINT", at), z = triple("DIRECTION", {0, 0, 1});
    return add("AXIS2_PLACEMENT_3D(''," + point + "," + z + "," + triple("DIRECTION", {1, 0, 0}) +
               ")");
  }

  /// A polyline of one segment.
  std::string segment(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return add("POLYLINE('',(" + triple("CARTESIAN_POINT", a) + "," + triple("CARTESIAN_POINT", b) +
               "))");
  }

  /// A curve that is composed of one.
  std::string composed_of(const std::string& curve) {
    return add("COMPOSITE_CURVE('',(" +
               add("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.," + curve + ")") + "),.F.)");
  }

  enum class Edges { Simple, Composed };
  std::string loop(const Points& points, Edges kind) {
    std::string edges;
    std::vector<std::string> corners;
    for (const auto& point : points)
      corners.push_back(add("VERTEX_POINT(''," + triple("CARTESIAN_POINT", point) + ")"));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      std::string geometry = segment(points[i], points[next]);
      if (kind == Edges::Composed) geometry = composed_of(geometry);
      const std::string edge =
          add("EDGE_CURVE(''," + corners[i] + "," + corners[next] + "," + geometry + ",.T.)");
      edges += (edges.empty() ? "" : ",") + add("ORIENTED_EDGE('',*,*," + edge + ",.T.)");
    }
    return add("EDGE_LOOP('',(" + edges + "))");
  }

  /// A square of 10 with a square hole of 2.
  std::string holed_square(Edges hole_edges = Edges::Simple) {
    const std::string outer = loop({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, Edges::Simple);
    const std::string hole = loop({{2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}}, hole_edges);
    const std::string bounds = add("FACE_OUTER_BOUND(''," + outer + ",.T.)") + "," +
                               add("FACE_BOUND(''," + hole + ",.T.)");
    const std::string plane = add("PLANE(''," + axes() + ")");
    const std::string face = add("ADVANCED_FACE('',(" + bounds + ")," + plane + ",.T.)");
    return add("SHELL_BASED_SURFACE_MODEL('',(" + add("OPEN_SHELL('',(" + face + "))") + "))");
  }

  std::string representation(const std::string& kind, const std::string& items) {
    const std::string origin = axes();
    return add(kind + "('',(" + origin + "," + items + ")," + context() + ")");
  }

  void product(const std::string& name, const std::string& whole) {
    const std::string use = add("APPLICATION_CONTEXT('')");
    const std::string product = add("PRODUCT('" + name + "','" + name + "','',(" +
                                    add("PRODUCT_CONTEXT(''," + use + ",'')") + "))");
    const std::string version = add("PRODUCT_DEFINITION_FORMATION('',''," + product + ")");
    const std::string design = add("PRODUCT_DEFINITION_CONTEXT(''," + use + ",'design')");
    const std::string definition = add("PRODUCT_DEFINITION('',''," + version + "," + design + ")");
    const std::string shape = add("PRODUCT_DEFINITION_SHAPE('',''," + definition + ")");
    add("SHAPE_DEFINITION_REPRESENTATION(" + shape + "," + whole + ")");
  }

  /// The unit of lengths, by its parts.
  std::string unit = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";

  Model read() const {
    const Folder folder;
    write_content(folder / "part.stp",
                  "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),("
                  "''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n" +
                      text_ + "ENDSEC;\nEND-ISO-10303-21;\n");
    return read_model(folder / "part.stp");
  }

 private:
  static std::string numbers(const std::array<double, 3>& x) {
    return "(" + std::to_string(x[0]) + "," + std::to_string(x[1]) + "," + std::to_string(x[2]) +
           ")";
  }

  std::string context() {
    const std::string length = add(unit);
    const std::string angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," +
               angle + "))REPRESENTATION_CONTEXT('',''))");
  }

  std::string text_;
  int count_ = 0;
};

/// Of shape; one without a cause if there is none.
Loss loss_of_shape(const Model& model) {
  for (const Loss& loss : model.reading().losses)
    if (loss.of_shape) return loss;
  return {};
}

StepWriting square(StepWriting::Edges hole = StepWriting::Edges::Simple) {
  StepWriting file;
  file.product("Plate", file.representation("MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
                                            file.holed_square(hole)));
  return file;
}

TEST(StepResults, AreSilentWhenAllIsThere) {
  const Model model = square().read();
  EXPECT_EQ(model.face_count(), 1);
  EXPECT_TRUE(model.reading().losses.empty()) << model.reading().summary();
}

TEST(StepResults, TellAHoleThatIsClosed) {
  const Model model = square(StepWriting::Edges::Composed).read();  // Open CASCADE makes none of it
  EXPECT_EQ(model.face_count(), 1);
  EXPECT_EQ(loss_of_shape(model).text(),
            "border (#66 of product 'Plate'): Open CASCADE cannot make it, and the face "
            "goes on where it should end");
}

TEST(StepResults, TellScalesAndMirrorsOfPlaces) {
  const auto placed = [](const std::string& scale, double z) {
    StepWriting file;
    const std::string origin = file.axes();
    const std::string whole =
        file.representation("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", file.holed_square());
    const std::string map = file.add("REPRESENTATION_MAP(" + origin + "," + whole + ")");
    const std::string place =
        file.add("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',''," +
                 file.triple("DIRECTION", {1, 0, 0}) + "," + file.triple("DIRECTION", {0, 1, 0}) +
                 "," + file.triple("CARTESIAN_POINT", {5, 0, 0}) + "," + scale + "," +
                 file.triple("DIRECTION", {0, 0, z}) + ")");
    file.product("Plates",
                 file.representation("SHAPE_REPRESENTATION",
                                     file.add("MAPPED_ITEM(''," + map + "," + place + ")")));
    return file.read();
  };
  EXPECT_TRUE(placed("1.", 1).reading().losses.empty());
  EXPECT_TRUE(placed("$", 1).reading().losses.empty());
  EXPECT_EQ(loss_of_shape(placed("2.", 1)).cause, "Open CASCADE leaves out the scale of its place");
  EXPECT_EQ(loss_of_shape(placed("1.", -1)).cause,
            "Open CASCADE leaves out the mirror of its place");
}

std::string triangles(StepWriting& file) {
  const std::string points = file.add("COORDINATES_LIST('',3,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.)))");
  const std::string face =
      file.add("TRIANGULATED_FACE(''," + points + ",3,((0.,0.,1.)),$,(),((1,2,3)))");
  return file.representation("TESSELLATED_SHAPE_REPRESENTATION",
                             file.add("TESSELLATED_SHELL('',(" + face + "),$)"));
}

TEST(StepResults, TellAPartOfTriangles) {
  StepWriting file = square();
  file.product("Mesh", triangles(file));
  EXPECT_EQ(loss_of_shape(file.read()).text(),
            "part (#103 of product 'Mesh'): its shape is of a kind that Open CASCADE does not "
            "read: TRIANGULATED_FACE, TESSELLATED_SHELL, TESSELLATED_SHAPE_REPRESENTATION");
}

TEST(StepResults, TakeTrianglesBesideFacesForNoShape) {
  StepWriting file;
  const std::string whole =
      file.representation("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", file.holed_square());
  file.product("Plate", whole);
  file.add("SHAPE_REPRESENTATION_RELATIONSHIP('',''," + whole + "," + triangles(file) + ")");
  const Model model = file.read();
  EXPECT_EQ(model.face_count(), 1);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::AttributesLost);
}

TEST(StepResults, NameWhatAFileWithoutAnythingElseHas) {
  StepWriting file;
  const std::string block = file.add("BLOCK(''," + file.axes() + ",1.,2.,3.)");
  file.product("Block", file.representation("CSG_SHAPE_REPRESENTATION",
                                            file.add("HALF_SPACE_SOLID('',$,.T.)") + "," + block));
  try {
    file.read();
    FAIL() << "is not refused";
  } catch (const BadModel& error) {
    EXPECT_NE(std::string(error.what()).find("Open CASCADE makes no shape of it"),
              std::string::npos)
        << error.what();
  }
}

TEST(StepResults, TellAUnitThatIsNotThere) {
  StepWriting file;
  file.unit = "(CONVERSION_BASED_UNIT('INCH',#9999)LENGTH_UNIT()NAMED_UNIT(*))";
  file.product("Plate",
               file.representation("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", file.holed_square()));
  const Model model = file.read();
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost) << model.reading().summary();
  EXPECT_NE(model.reading().summary().find("lengths or angles may be wrong"), std::string::npos);
}

}  // namespace
}  // namespace blossom::occt
