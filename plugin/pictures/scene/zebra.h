// SPDX-License-Identifier: LGPL-2.1-or-later
// Zebra stripes: how faces would reflect rows of lamps, dark and light in turns.
//
// A mirror with the normal n shows an eye in the direction d the direction r = 2 (n.d) n - d of its
// surroundings. These are striped in bands of one width by the height of r over the horizon of the
// picture. So stripes are as smooth as normals are: at an edge that is G0 they break off, at one
// that is G1 they go on with a bend, at one that is G2 without.

#pragma once

#include "plugin/pictures/scene/mesh.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::pictures {

/// The parts of a mesh in dark and in light stripes; borders are the dark one's.
struct StripedMesh {
  PictureMesh dark, light;
};

/// Triangles are cut along the borders of stripes; along their sides the height of r is linear.
/// to_eye, up   unit, of the picture
StripedMesh striped(const PictureMesh& mesh, const Vec3& to_eye, const Vec3& up);

/// The faces of a picture as its view shows them, striped, in place of the faces.
void paint_zebra(Picture& picture);

}  // namespace blossom::pictures
