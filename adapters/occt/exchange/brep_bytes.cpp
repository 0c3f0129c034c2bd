// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/brep_bytes.h"

#include <sstream>

#include <BRepTools.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/places.h"

namespace blossom::occt {
TopoDS_Shape shape_from_bytes(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw BadModel(name + ": there are no bytes");
  TopoDS_Shape shape;
  ReadingReport report;
  try {
    if (format_of_content(bytes) == Format::Brep)
      shape = with_moving_places(brep_shape(std::string(bytes), report), report);
  } catch (const BadModel& bad) {
    throw BadModel(name + ": " + bad.what());
  }
  if (!report.losses.empty()) throw BadModel(name + ": " + report.losses.front().text());
  if (shape.IsNull())
    throw BadModel(name + ": these " + std::to_string(bytes.size()) + " bytes hold no BRep shape");
  return shape;
}

std::string brep_text(const TopoDS_Shape& shape) {
  return guarded("writing BRep", [&] {
    std::ostringstream out;
    BRepTools::Write(shape, out);
    return out.str();
  });
}

}  // namespace blossom::occt
