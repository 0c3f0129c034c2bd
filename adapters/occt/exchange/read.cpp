// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP, IGES and BREP files.

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/listening.h"

namespace blossom::occt {
namespace {

bool is_empty(const TopoDS_Shape& shape) {
  return shape.IsNull() || (shape.ShapeType() != TopAbs_VERTEX && !TopoDS_Iterator(shape).More());
}

void require_shape(const TopoDS_Shape& shape, const ReadingReport& report) {
  if (is_empty(shape)) refuse("holds no shape", report);
}

void read_format(Format format, Reading& reading) {
  const Listening listening;
  switch (format) {
    case Format::Step: return read_step(reading);
    case Format::Iges: return read_iges(reading);
    case Format::Brep: return read_brep(reading);
    case Format::Glb: break;  // no content is taken for it
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

void refuse(const std::string& cause, const ReadingReport& report) {
  const auto lost = std::ranges::find_if(report.losses, [](const Loss& l) { return l.of_shape; });
  if (lost == report.losses.end()) throw BadModel(cause);
  throw BadModel("holds no shape that can be used: " + lost->text());
}

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
    // Only BREP files state tolerances; others have those that Open CASCADE's readers find.
    if (format != Format::Brep) impl.stated = StatedTolerances::Raised;
  } catch (const BadModel& error) {
    throw BadModel(file.string() + ": " + error.what());
  } catch (...) {  // Open CASCADE's exceptions are no std::exception
    throw BadModel(file.string() + ": " + reading.step + " fails: " + current_failure_text());
  }
  impl.file = file;
  return model;
}

}  // namespace blossom::occt
