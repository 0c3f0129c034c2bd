// SPDX-License-Identifier: LGPL-2.1-or-later
// A place is a motion after a scale about the origin, which is negative if it mirrors. Moved
// outwards through all places around it, the motion stays one, and the scales multiply.

#include "adapters/occt/exchange/places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <unordered_map>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <NCollection_DataMap.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopLoc_MapLocationHasher.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_TShape.hxx>
#include <gp_Mat.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_words.h"

namespace blossom::occt {
namespace {

constexpr double kRoundedScale = 1e-9;  // of the numbers of a file

// Of the entries of a matrix, beside its scale. Programs that compute in single precision give
// 1e-6; what is scaled differently by direction on purpose is more.
constexpr double kRoundedMatrix = 1e-5;

bool only_moves(double scale) { return std::abs(scale - 1) <= kRoundedScale; }

double scale_of(const TopLoc_Location& place) {
  if (place.IsIdentity()) return 1;
  const double scale = place.Transformation().ScaleFactor();
  return only_moves(scale) ? 1 : scale;
}

double scale_of(const TopoDS_Shape& shape) { return scale_of(shape.Location()); }

bool can_be_baked(double scale) {
  return std::isfinite(scale) && std::abs(scale) > std::numeric_limits<double>::min();
}

// By rows of four, of which the last is the translation.
using PlaceMatrix = std::array<BrepWords::Number, 12>;

std::vector<PlaceMatrix> matrices_of(const std::string& content, const EntriesOfPlaces& where) {
  constexpr int kMatrix = 1;  // 2 is a product of powers of others: pairs up to a 0
  BrepWords words(content, where.at, where.binary);
  std::vector<PlaceMatrix> all;
  for (long i = 0; i < where.count && !words.ended(); ++i) {
    if (words.kind() == kMatrix)
      for (BrepWords::Number& each : all.emplace_back()) each = words.real();
    else
      while (!words.ended() && words.integer() != 0) words.integer();
  }
  if (words.ended()) all.clear();  // it is cut off, which its reader tells
  return all;
}

bool turns_and_scales(const PlaceMatrix& matrix) {
  double products[3][3], largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      products[i][j] = 0;
      for (std::size_t k = 0; k < 12; k += 4)
        products[i][j] += matrix[k + i].value * matrix[k + j].value;
    }
  const double square = (products[0][0] + products[1][1] + products[2][2]) / 3;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      largest = std::max(largest, std::abs(products[i][j] - (i == j ? square : 0)));
  return largest <= 2 * kRoundedMatrix * square;
}

/// The motion of a place, moved outwards through a scale.
TopLoc_Location motion_of(const TopLoc_Location& place, double around) {
  const gp_Trsf before = place.Transformation();
  if (around == 1 && only_moves(before.ScaleFactor())) return place;
  const gp_Mat turn = before.VectorialPart() / before.ScaleFactor();
  const gp_XYZ shift = before.TranslationPart() * around;
  gp_Trsf motion;
  motion.SetValues(turn(1, 1), turn(1, 2), turn(1, 3), shift.X(),  //
                   turn(2, 1), turn(2, 2), turn(2, 3), shift.Y(),  //
                   turn(3, 1), turn(3, 2), turn(3, 3), shift.Z());
  return motion;
}

/// Shapes are the same only where their places are one object: each motion is made once.
class Motions {
 public:
  TopLoc_Location of(const TopLoc_Location& place, double around) {
    if (place.IsIdentity()) return place;
    auto& known = known_[around];
    if (!known.IsBound(place)) known.Bind(place, motion_of(place, around));
    return known.Find(place);
  }

 private:
  std::map<double, NCollection_DataMap<TopLoc_Location, TopLoc_Location, TopLoc_MapLocationHasher>>
      known_;
};

/// Scales what places scale; see with_moving_places.
class Baking {
 public:
  TopoDS_Shape operator()(const TopoDS_Shape& shape) {
    collect(shape, 1);
    for (auto& [scale, work] : works_) work.perform(scale);
    return works_.empty() ? shape : placed(shape, 1);
  }

  /// By what was scaled; in words, empty if nothing was.
  std::string scales() const;

 private:
  /// All that is scaled by one number, in one go, so that it shares what it shared.
  struct Work {
    std::vector<TopoDS_Shape> shapes = {};
    std::unique_ptr<BRepBuilderAPI_Transform> scaled = {};  ///< null if it cannot be

    void perform(double scale);
  };
  using Key = std::pair<const TopoDS_TShape*, double>;

  bool is_opened(const TopoDS_Shape& shape);
  bool scales_within(const TopoDS_Shape& shape);
  void collect(const TopoDS_Shape& shape, double around);
  TopoDS_Shape placed(const TopoDS_Shape& shape, double around);
  TopoDS_Shape made(const TopoDS_Shape& shape, double scale);

  std::unordered_map<const TopoDS_TShape*, bool> scales_within_;
  std::set<Key> collected_;
  std::map<double, Work> works_;
  std::map<Key, TopoDS_Shape> made_;  // null of what cannot be scaled
  Motions motions_;
};

TopoDS_Shape unplaced(const TopoDS_Shape& shape) {
  return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
}

void Baking::Work::perform(double scale) {
  gp_Trsf about_origin;
  about_origin.SetScale(gp_Pnt(), scale);
  try {
    scaled = std::make_unique<BRepBuilderAPI_Transform>(compound_of(shapes), about_origin, true);
  } catch (const Standard_Failure&) {
    if (is_lack_of_memory()) throw std::bad_alloc();
  }
}

std::string Baking::scales() const {
  std::ostringstream words;
  for (const auto& [scale, work] : works_)
    if (work.scaled) words << (words.tellp() > 0 ? ", " : "") << scale;
  return words.str();
}

/// Faces and what they are made of have one place, by which their curves are told.
bool Baking::is_opened(const TopoDS_Shape& shape) {
  return shape.ShapeType() == TopAbs_COMPOUND ||
         (shape.ShapeType() <= TopAbs_SHELL && scales_within(shape));
}

bool Baking::scales_within(const TopoDS_Shape& shape) {
  if (const auto known = scales_within_.find(shape.TShape().get()); known != scales_within_.end())
    return known->second;
  bool scales = false;
  if (shape.ShapeType() <= TopAbs_SHELL)
    for (TopoDS_Iterator part(shape, false, false); part.More() && !scales; part.Next())
      scales = !only_moves(scale_of(part.Value())) || scales_within(part.Value());
  return scales_within_[shape.TShape().get()] = scales;
}

void Baking::collect(const TopoDS_Shape& shape, double around) {
  const double scale = around * scale_of(shape);
  if (!can_be_baked(scale) || !collected_.emplace(shape.TShape().get(), scale).second) return;
  if (is_opened(shape))
    for (TopoDS_Iterator part(shape, false, false); part.More(); part.Next())
      collect(part.Value(), scale);
  else if (!only_moves(scale))
    works_[scale].shapes.push_back(unplaced(shape));
}

/// Without a place, and forward.
TopoDS_Shape Baking::made(const TopoDS_Shape& shape, double scale) {
  if (!is_opened(shape)) {
    if (only_moves(scale)) return unplaced(shape);
    const auto& scaled = works_.at(scale).scaled;
    return scaled ? scaled->ModifiedShape(unplaced(shape)) : TopoDS_Shape();
  }
  TopoDS_Shape whole = unplaced(shape).EmptyCopied();
  for (TopoDS_Iterator part(unplaced(shape), false, false); part.More(); part.Next())
    BRep_Builder().Add(whole, placed(part.Value(), scale));
  whole.Closed(shape.Closed());
  return whole;
}

TopoDS_Shape Baking::placed(const TopoDS_Shape& shape, double around) {
  const double scale = around * scale_of(shape);
  if (!can_be_baked(scale)) return shape;
  const Key key(shape.TShape().get(), scale);
  if (!made_.contains(key)) made_.emplace(key, made(shape, scale));
  TopoDS_Shape result = made_.at(key);
  TopLoc_Location place = motions_.of(shape.Location(), around);
  if (result.IsNull()) {
    gp_Trsf scaling;
    scaling.SetScale(gp_Pnt(), scale);
    place = place * TopLoc_Location(scaling);
    result = unplaced(shape);
  }
  result.Orientation(TopAbs::Compose(shape.Orientation(), result.Orientation()));
  result.Location(place, false);
  return result;
}

int scaled_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  int scaled = 0;
  for (int i = 1; i <= faces.Extent(); ++i) scaled += only_moves(scale_of(faces(i))) ? 0 : 1;
  return scaled;
}

}  // namespace

void check_place(const TopoDS_Shape& shape) {
  const double scale = scale_of(shape);
  if (!can_be_baked(scale)) throw BadModel("its place is no motion, with a scale or without");
  if (!only_moves(std::abs(scale))) throw BadModel("its place scales it");
}

void check_inner_place(const TopLoc_Location& place, const char* whose) {
  if (!can_be_baked(scale_of(place)))
    throw BadModel(std::string("the place of ") + whose + " is no motion, with a scale or without");
}

void spoil_unfit_places(std::string& content, const EntriesOfPlaces& where) {
  std::vector<PlaceMatrix> matrices = matrices_of(content, where);
  std::erase_if(matrices, turns_and_scales);
  for (auto matrix = matrices.rbegin(); matrix != matrices.rend(); ++matrix) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const BrepWords::Number& first = matrix->front();
    if (where.binary)
      std::memcpy(content.data() + first.at, &none, sizeof(none));
    else
      content.replace(first.at, first.length, "nan");
  }
}

TopoDS_Shape with_moving_places(const TopoDS_Shape& shape, ReadingReport& report) {
  if (shape.IsNull()) return shape;
  Baking baking;
  TopoDS_Shape result = baking(shape);
  if (const std::string scales = baking.scales(); !scales.empty())
    report.notes.push_back(std::to_string(scaled_faces(shape)) +
                           " faces are scaled or mirrored by their places (by " + scales +
                           "): their geometry was made so");
  return result;
}

}  // namespace blossom::occt
