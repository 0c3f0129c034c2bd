// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of faces and curves, made without a display; the same bytes at every run.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

#include "core/math/vec.h"
#include "plugin/cli/picture/png.h"

namespace blossom::cli {

/// Red, green, blue in [0, 1], sRGB; the colours of pictures.
inline constexpr Vec3 kFirstColour = {0.36, 0.56, 0.78};
inline constexpr Vec3 kSecondColour = {0.93, 0.69, 0.33};
inline constexpr Vec3 kCurveColour = {0.78, 0.08, 0.16};
/// How opaque the first and the second input are.
inline constexpr double kFirstOpacity = 0.94;
inline constexpr double kSecondOpacity = 0.55;

struct PictureFaces {
  std::vector<TopoDS_Face> faces;
  Vec3 colour;
  double opacity = 1;
};

struct PictureCurve {
  std::vector<Vec3> points;  ///< a polyline, model units
  Vec3 colour;
};

struct Picture {
  std::vector<PictureFaces> groups;
  std::vector<std::vector<Vec3>> curves;  ///< polylines, model units, drawn thick
  std::vector<PictureCurve> coloured;     ///< likewise, each in its colour
  std::vector<Vec3> points;               ///< drawn as dots
  int width = 1200;                       ///< pixels
  int height = 900;
};

/// The picture as an image.
/// throws   occt::Failure if a face cannot be triangulated
Image picture_image(const Picture& picture);

/// The bytes of a PNG file.
/// throws   likewise
std::string picture_png(const Picture& picture);

}  // namespace blossom::cli
