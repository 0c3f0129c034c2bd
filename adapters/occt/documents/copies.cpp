// SPDX-License-Identifier: LGPL-2.1-or-later
// A document as another one.

#include <TDF_AttributeIterator.hxx>
#include <TDF_ClosureTool.hxx>
#include <TDF_CopyTool.hxx>
#include <TDF_DataSet.hxx>
#include <TDF_RelocationTable.hxx>

#include "adapters/occt/documents/document.h"

namespace blossom::occt {
namespace {

/// A node at the main label has its father at the root, which is not copied: it gets the one that
/// the other document has there. Else it would point into a document that may go.
void relocate_root(const TDF_Label& from, const TDF_Label& to, TDF_RelocationTable& table) {
  for (TDF_AttributeIterator it(from); it.More(); it.Next())
    if (Handle(TDF_Attribute) own; to.FindAttribute(it.Value()->ID(), own))
      table.SetRelocation(it.Value(), own);
}

}  // namespace

std::shared_ptr<DocumentInterface> Document::copy() const {
  auto made = std::make_shared<Document>();
  const TDF_Label from = main(), to = made->main();
  const Handle(TDF_DataSet) all = new TDF_DataSet;
  all->AddLabel(from);
  TDF_ClosureTool::Closure(all);
  const Handle(TDF_RelocationTable) table = new TDF_RelocationTable(true);
  table->SetRelocation(from, to);
  relocate_root(from.Root(), to.Root(), *table);
  TDF_CopyTool::Copy(all, table);
  return made;
}

}  // namespace blossom::occt
