// SPDX-License-Identifier: LGPL-2.1-or-later
// A model is read, all of it repaired, and its faces and edges converted.
#include <memory>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/soundness.h"
#include "core/base/parallel.h"
#include "plugin/nets/net_models.h"
#include "tests/fuzz/support/child.h"
#include "tests/fuzz/support/files.h"

namespace blossom::fuzz {
namespace {

template <class Work>
void unless_refused(const Work& work) try {
  work();
} catch (const occt::BadModel&) {
} catch (const occt::Failure&) {
}

void use(const std::shared_ptr<occt::Model>& model) {
  reports::Input input{"input", model, *model};
  input.shape = model->shape();
  for (int number = 1; number <= model->face_count(); ++number) {
    input.numbers.push_back(number);
    input.faces.push_back(model->face(number));
  }
  unless_refused([&] { model->repair(); });
  unless_refused([&] { nets::nets_of_faces(input, {}); });
  unless_refused([&] { nets::nets_of_edges(input, true, {}); });
  unless_refused([&] { occt::edge_facts(model->shape()); });
  model->assembly();
}

}  // namespace

void try_input(Bytes bytes) {
  const std::filesystem::path file = file_of(bytes, BLOSSOM_FUZZ_ENDING);
  in_child([&](Parts& parts) {
    unless_refused([&] {
      with_threads(1, [&] {
        parts.reading();
        occt::ReadOptions options;
        const auto model = std::make_shared<occt::Model>(occt::read_model(file, options));
        parts.ours();
        use(model);
      });
    });
  });
}

}  // namespace blossom::fuzz
