// SPDX-License-Identifier: LGPL-2.1-or-later
// What pictures and pages show: faces, curves and places, with a legend. Made without a display;
// the same bytes at every run.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

#include "core/math/vec.h"
#include "plugin/pictures/scene/mesh.h"

namespace blossom::pictures {

/// Red, green, blue in [0, 1], sRGB; the colours of pictures.
inline constexpr Vec3 kFirstColour = {0.36, 0.56, 0.78};
inline constexpr Vec3 kSecondColour = {0.93, 0.69, 0.33};
inline constexpr Vec3 kCurveColour = {0.78, 0.08, 0.16};
inline constexpr Vec3 kTouchColour = {0.00, 0.50, 0.25};
inline constexpr Vec3 kOverlapColour = {0.42, 0.13, 0.62};
inline constexpr Vec3 kUnresolvedColour = {0.88, 0.00, 0.55};
inline constexpr Vec3 kFaultyColour = {0.88, 0.42, 0.42};
inline constexpr Vec3 kToolColour = {0.62, 0.62, 0.60};
inline constexpr Vec3 kNetColour = {0.30, 0.34, 0.40};
/// Of a picture, pixels.
inline constexpr int kMinSide = 100, kMaxSide = 8000;

/// How opaque the first and the second input are.
inline constexpr double kFirstOpacity = 0.94;
inline constexpr double kSecondOpacity = 0.55;
inline constexpr double kToolOpacity = 0.3;

/// Colours for things side by side, such as pieces; after the last one the first comes again.
const Vec3& palette(std::size_t index);

struct PictureFaces {
  std::vector<TopoDS_Face> faces;
  Vec3 colour;
  double opacity = 1;
  std::string name = {};                 ///< in the legend; empty for none
  std::vector<std::string> labels = {};  ///< what a page tells of each face, or nothing
  std::vector<PictureMesh> meshes = {};  ///< shown as they are; their labels follow those of faces
};

/// How a layer is drawn. Marks are seen through faces.
enum class LayerStyle {
  Curve,   ///< thick lines
  Net,     ///< thin lines
  Hatch,   ///< lines close to each other
  Dot,     ///< a mark at the first point
  Ring,    ///< likewise
  Square,  ///< likewise
};

struct PictureItem {
  std::vector<Vec3> points;  ///< a polyline, model units; or one point
  std::string label = {};    ///< what a page tells of it, in lines
};

/// Things of one meaning in one colour.
struct PictureLayer {
  std::string name;  ///< in the legend; empty for none
  Vec3 colour;
  LayerStyle style = LayerStyle::Curve;
  std::vector<PictureItem> items = {};
};

struct Picture {
  std::vector<PictureFaces> groups;
  std::vector<std::vector<Vec3>> curves = {};  ///< a layer without a name: thick, in kCurveColour
  std::vector<Vec3> points = {};               ///< likewise dots
  std::vector<PictureLayer> layers = {};       ///< later ones are drawn over earlier ones
  std::string title = {};                      ///< empty for none
  std::string subtitle = {};                   ///< likewise; below the title
  std::vector<std::string> facts = {};         ///< what a page tells of all, such as a certificate
  bool annotated = true;                       ///< with axes and scale bar, title and legend
  std::string view = {};                       ///< as view_direction takes it; empty: the default
  int width = 1200;                            ///< pixels
  int height = 900;
};

/// The layers that `curves` and `points` stand for, and `layers`; those without items left out.
std::vector<PictureLayer> all_layers(const Picture& picture);

}  // namespace blossom::pictures
