// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP, IGES and BREP files.

#include <algorithm>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

#include <Message.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes/edge_tolerances.h"
#include "adapters/occt/shapes/file_text.h"
#include "adapters/occt/shapes/listening.h"
#include "adapters/occt/shapes/loose_images.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

void tell(const RaisedTolerances& raised, const std::filesystem::path& file) {
  const int count = raised.edges.Extent() + raised.vertices.Extent();
  if (count == 0) return;
  std::ostringstream text;
  text << file.string() << ": " << count << " edges and vertices get tolerances of up to "
       << raised.largest()
       << ", since curves are farther apart than Open CASCADE measured at a few points";
  Message::SendInfo(text.str().c_str());
}

/// Only BREP files state tolerances; others have those that Open CASCADE's readers find.
void heal(const TopoDS_Shape& shape, Format format, const std::filesystem::path& file) {
  RaisedTolerances raised;
  if (format != Format::Brep) raised = raise_tolerances(shape);
  if (const RemadeImages made = remake_loose_images(shape, raised.edges); made.count > 0) {
    std::ostringstream text;
    text << file.string() << ": " << made.count << " curves in the parameters of faces are up to "
         << made.worst << " off those in space, which lie on the faces; they are made anew";
    Message::SendWarning(text.str().c_str());
  }
  tell(raised, file);
  const int missing = count_missing_curves(shape);
  if (missing == 0) return;
  add_missing_curves(shape);
  const int left = count_missing_curves(shape);
  const std::string text = file.string() + ": " + std::to_string(missing) +
                           " edges have no curve in the parameters of their face; " +
                           std::to_string(missing - left) + " are made from their curves in space";
  Message::SendWarning(text.c_str());
}

bool is_empty(const TopoDS_Shape& shape) {
  return shape.IsNull() || (shape.ShapeType() != TopAbs_VERTEX && !TopoDS_Iterator(shape).More());
}

void require_shape(const TopoDS_Shape& shape, const ReadingReport& report) {
  if (!is_empty(shape)) return;
  const auto lost = std::ranges::find_if(report.losses, [](const Loss& l) { return l.of_shape; });
  if (lost == report.losses.end()) throw BadModel("holds no shape");
  throw BadModel("holds no shape that can be used: " + lost->text());
}

void read_format(Format format, Reading& reading) {
  const Listening listening;
  switch (format) {
    case Format::Step: return read_step(reading);
    case Format::Iges: return read_iges(reading);
    case Format::Brep: return read_brep(reading);
  }
}

/// Into the document of the reading; returns the format.
Format read_into(Reading& reading) {
  reading.begin("opening");
  FileText content = file_text(reading.file);
  reading.text = std::move(content.text);
  if (content.cut) reading.report.add({"the packed file", "it is damaged or cut off", true});
  read_format(content.format, reading);
  reading.begin("checking the numbers");
  leave_out_bad_faces(reading.document, content.format, reading.text, reading.report);
  return content.format;
}

}  // namespace

void Reading::begin(const char* doing) {
  step = doing;
  if (options.step) options.step((step + " of " + file.string()).c_str());
}

void Reading::with_names(const XSControl_Reader& reader, const std::function<bool()>& transfer) {
  const char* const kNames = "names, colours, dimensions and assembly";
  if (options.names) try {
      begin(kReadingNames);
      if (transfer()) return;
    } catch (const Standard_Failure&) {
      report.add({kNames, current_failure_text()});
    } catch (const std::exception&) {
      report.add({kNames, current_failure_text()});
    }
  else
    report.add({kNames, "reading them fails, or is not wanted"});
  document.renew();
  for (int i = 1; i <= reader.NbShapes(); ++i)
    document.shapes()->SetShape(document.shapes()->NewShape(), reader.Shape(i));
}

Model read_model(const std::filesystem::path& file, const ReadOptions& options) {
  const std::lock_guard guard(exchange_lock());
  Model model;
  Model::Impl& impl = *model.impl_;
  Reading reading{impl.document, file, options, impl.reading};
  try {
    const Format format = read_into(reading);
    impl.refresh();
    require_shape(impl.shape, impl.reading);
    reading.begin("mending the edges");
    heal(impl.shape, format, file);
  } catch (const BadModel& error) {
    throw BadModel(file.string() + ": " + error.what());
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    throw BadModel(file.string() + ": " + reading.step + " fails: " + current_failure_text());
  }
  impl.file = file;
  return model;
}

}  // namespace blossom::occt
