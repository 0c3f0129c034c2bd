// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/watertight_output.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>

#include "plugin/reports/cuts/watertight.h"

namespace blossom::cli {
namespace {

using reports::to_json;

TEST(WatertightOutput, SaysWhichFacesAreOpenWhenTheTimeIsSpent) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3);

  const occt::WatertightShape made = watertight_of(box, EngineOptions{}, 1e-9);

  EXPECT_TRUE(made.shape.IsNull());
  EXPECT_EQ(reason_of(made.pieces),
            "the time limit was reached while the faces were made watertight; 6 faces not done");
  EXPECT_EQ(summary_of(made.pieces),
            "  watertight: stopped; faces that are not done: 1 2 3 4 5 6\n");
  const Json report = to_json(made.pieces);
  EXPECT_EQ(report["open"], Json({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(report["triangles"], 0);
}

TEST(WatertightOutput, HasNoOpenFacesWhenAllIsDone) {
  const occt::WatertightShape made =
      watertight_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), EngineOptions{}, 0);

  EXPECT_FALSE(made.shape.IsNull());
  EXPECT_EQ(reason_of(made.pieces), "");
  EXPECT_EQ(to_json(made.pieces)["open"], Json::array());
  EXPECT_EQ(to_json(made.pieces)["may_fold"], Json::array());
  EXPECT_EQ(status_with(Status::Complete, made.pieces), Status::Complete);
}

TEST(WatertightOutput, NamesFacesWhosePiecesMayFoldOver) {
  WatertightPieces pieces =
      watertight_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), EngineOptions{}, 0).pieces;
  pieces.turned = {0, 1};
  pieces.pieces[0].face = pieces.pieces[1].face = 4;

  EXPECT_EQ(to_json(pieces)["may_fold"], Json::array({5}));
  EXPECT_NE(summary_of(pieces).find("not proven to fold over nowhere: 2 pieces narrower than the "
                                    "edges beside are moved, of face 5\n"),
            std::string::npos);
  EXPECT_EQ(status_with(Status::Complete, pieces), Status::Tolerance);
  EXPECT_EQ(status_with(Status::Stopped, pieces), Status::Stopped);
}

}  // namespace
}  // namespace blossom::cli
