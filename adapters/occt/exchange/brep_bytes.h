// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes as bytes: how they come from other programs and go back, without a shared C++ object.

#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// A shape from BRep text, from Open CASCADE's binary BRep or from FreeCAD's `exportBinary`.
/// name     what the caller calls the argument, for messages
/// throws   BadModel if the bytes hold no shape
TopoDS_Shape shape_from_bytes(std::string_view bytes, const std::string& name);

/// Likewise, for programs that must outlive any bytes: they are read in a child process first, see
/// `read_model_in_child` in adapters/occt/shapes.h.
/// throws   BadModel, also if Open CASCADE crashes on them or never ends
TopoDS_Shape rehearsed_shape_from_bytes(std::string_view bytes, const std::string& name,
                                        const std::function<void()>& stop = {});

/// BRep text. throws Failure if it cannot be made
std::string brep_text(const TopoDS_Shape& shape);

}  // namespace blossom::occt
