// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/selection.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "plugin/reports/models/entity_words.h"
#include "plugin/reports/text/json.h"
#include "plugin/reports/text/words.h"

namespace blossom::reports {
namespace {

using occt::AssemblyNode;

// "Face3": a kind and a number, whatever the case of the letters.
struct NumberedEntity {
  std::string kind;  // face, edge or solid
  int number = 0;
};

std::optional<NumberedEntity> counted_in(const std::string& word) {
  if (word.empty() || std::isalpha(static_cast<unsigned char>(word[0])) == 0) return std::nullopt;
  for (const char* kind : {"face", "edge", "solid"})
    if (const auto number = entity_number(word, kind)) return NumberedEntity{kind, *number};
  return std::nullopt;
}

class Selecting {
 public:
  explicit Selecting(const occt::Model& model) : model_(model), tree_(model.assembly()) {
    TopExp::MapShapes(model.shape(), TopAbs_SOLID, solids_);
    TopExp::MapShapes(model.shape(), TopAbs_EDGE, edges_);
    TopExp::MapShapes(model.shape(), TopAbs_FACE, faces_);
  }

  void add(const std::string& word) {
    const std::size_t colon = word.find(':');
    const std::string kind = word.substr(0, colon);
    const bool numbered = kind == "face" || kind == "edge" || kind == "solid";
    if (colon != std::string::npos && numbered) {
      if (const auto number = entity_number(word, kind)) return add_number(kind, *number);
      throw InvalidInput(model_.file().string() + ": '" + word + "' has no number");
    }
    const bool part = kind == "part" && colon != std::string::npos;
    add_named(part ? word.substr(colon + 1) : word);
  }

  const Selection& made() const { return made_; }

  /// Whether it is a name of the model, or begins with one and goes on with a number.
  bool is_called(const std::string& word) const {
    if (!nodes_called(word).empty()) return true;
    const std::size_t slash = word.rfind('/');
    if (slash != std::string::npos && counted_in(word.substr(slash + 1)))
      return !nodes_called(word.substr(0, slash)).empty();
    const std::vector<std::string> names = model_.face_names();
    return std::ranges::find(names, word) != names.end();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw occt::BadModel(model_.file().string() + ": " + why);
  }

  void add_number(const std::string& kind, int number) {
    const auto& all = kind == "solid" ? solids_ : kind == "edge" ? edges_ : faces_;
    if (number > all.Extent())
      refuse("there is no " + kind + " " + std::to_string(number) + " in it, it has " +
             counted(static_cast<std::size_t>(all.Extent()), kind));
    if (kind == "solid") add_solid(number);
    if (kind == "edge") made_.edges.insert(number);
    if (kind == "face") made_.faces.insert(number);
  }

  void add_solid(int number) {
    made_.solids.insert(number);
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(solids_(number), TopAbs_FACE, own);
    for (int i = 1; i <= own.Extent(); ++i) made_.faces.insert(faces_.FindIndex(own(i)));
  }

  void add_named(const std::string& word) {
    if (const auto nodes = nodes_called(word); !nodes.empty()) {
      for (const AssemblyNode* node : nodes) add_node(*node);
      return;
    }
    const std::size_t slash = word.rfind('/');
    const auto which =
        slash == std::string::npos ? std::nullopt : counted_in(word.substr(slash + 1));
    if (which) {
      const std::string name = word.substr(0, slash);
      const auto nodes = nodes_called(name);
      if (nodes.empty()) refuse_name(name);
      for (const AssemblyNode* node : nodes) add_counted(*node, *which, name);
      return;
    }
    if (add_faces_called(word)) return;
    if (const auto of_all = counted_in(word)) return add_number(of_all->kind, of_all->number);
    refuse_name(word);
  }

  // That are called so by the whole way; else by the end of it, or by a name of their own.
  std::vector<const AssemblyNode*> nodes_called(const std::string& word) const {
    std::vector<const AssemblyNode*> exact, others;
    // way   from the whole model, which paths leave out
    const auto look = [&](const AssemblyNode& node, const std::string& way,
                          const auto& self) -> void {
      if (node.path == word || way == word) exact.push_back(&node);
      if (node.name == word || node.product == word || way.ends_with("/" + word))
        others.push_back(&node);
      for (const AssemblyNode& part : node.parts) self(part, way + "/" + part.name, self);
    };
    for (const AssemblyNode& root : tree_) look(root, root.name, look);
    return exact.empty() ? others : exact;
  }

  void add_node(const AssemblyNode& node) {
    for (const int solid : node.solids) add_solid(solid);
    made_.faces.insert(node.faces.begin(), node.faces.end());
    for (const AssemblyNode& part : node.parts) add_node(part);
  }

  static void collect(const AssemblyNode& node, std::vector<int>& faces, std::vector<int>& solids) {
    faces.insert(faces.end(), node.faces.begin(), node.faces.end());
    solids.insert(solids.end(), node.solids.begin(), node.solids.end());
    for (const AssemblyNode& part : node.parts) collect(part, faces, solids);
  }

  void add_counted(const AssemblyNode& node, const NumberedEntity& which, const std::string& name) {
    std::vector<int> faces, solids;
    collect(node, faces, solids);
    const auto chosen = [&](const std::vector<int>& numbers, const std::string& kind) {
      if (which.number > static_cast<int>(numbers.size()))
        refuse("there is no " + kind + " " + std::to_string(which.number) + " in '" + name +
               "', it has " + counted(numbers.size(), kind));
      return numbers[static_cast<std::size_t>(which.number) - 1];
    };
    if (which.kind == "face") made_.faces.insert(chosen(faces, which.kind));
    if (which.kind == "solid") add_solid(chosen(solids, which.kind));
    if (which.kind != "edge") return;
    TopTools_IndexedMapOfShape own;
    for (const int face : faces) TopExp::MapShapes(faces_(face), TopAbs_EDGE, own);
    std::vector<int> edges;
    for (int i = 1; i <= own.Extent(); ++i) edges.push_back(edges_.FindIndex(own(i)));
    made_.edges.insert(chosen(edges, which.kind));
  }

  bool add_faces_called(const std::string& word) {
    const std::vector<std::string> names = model_.face_names();
    bool any = false;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == word) {
        made_.faces.insert(static_cast<int>(i) + 1);
        any = true;
      }
    return any;
  }

  // The parts that the model consists of; of an assembly those of its first level.
  std::vector<std::string> names_of_parts() const {
    const bool assembly = tree_.size() == 1 && !tree_.front().parts.empty();
    std::vector<std::string> names;
    for (const AssemblyNode& part : assembly ? tree_.front().parts : tree_)
      add_name(part.name.empty() ? part.product : part.name, names);
    return names;
  }

  static void add_name(const std::string& name, std::vector<std::string>& names) {
    if (!given_name(name).empty() && std::ranges::find(names, name) == names.end())
      names.push_back(name);
  }

  [[noreturn]] void refuse_name(const std::string& word) const {
    constexpr std::size_t kMaxNames = 5;  // names in a message
    std::vector<std::string> all;
    const auto look = [&](const AssemblyNode& node, const auto& self) -> void {
      for (const std::string* name : {&node.name, &node.product, &node.path}) add_name(*name, all);
      for (const AssemblyNode& part : node.parts) self(part, self);
    };
    for (const AssemblyNode& root : tree_) look(root, look);
    for (const std::string& name : model_.face_names()) add_name(name, all);
    const std::string near = nearest_word(word, all);
    const std::string text = "there is no part and no face '" + word + "' in it";
    if (!near.empty()) refuse(text + "; did you mean '" + near + "'?");
    std::vector<std::string> parts = names_of_parts();
    if (parts.empty()) refuse(text + "; its parts have no names");
    const bool more = parts.size() > kMaxNames;
    parts.resize(std::min(parts.size(), kMaxNames));
    for (std::string& name : parts) name = "'" + name + "'";
    refuse(text + "; there " + (parts.size() == 1 ? "is " : "are ") + listed(parts, "and") +
           (more ? "; info --tree lists all" : ""));
  }

  const occt::Model& model_;
  std::vector<AssemblyNode> tree_;
  TopTools_IndexedMapOfShape solids_, edges_, faces_;
  Selection made_{};
};

// The edges that an input names and that go with the faces that it does not name.
std::vector<TopoDS_Shape> edges_named_alone(const Input& input) {
  TopTools_IndexedMapOfShape edges, kept, all;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, edges);
  for (int number = 1; number <= input.model.face_count(); ++number)
    TopExp::MapShapes(input.model.face(number), TopAbs_EDGE, all);
  for (const int number : input.numbers)
    TopExp::MapShapes(input.model.face(number), TopAbs_EDGE, kept);
  std::vector<TopoDS_Shape> without;
  for (const int number : input.edges)
    if (all.Contains(edges(number)) && !kept.Contains(edges(number)))
      without.push_back(edges(number));
  return without;
}

// Solids, faces that are in none of them, and edges, side by side.
TopoDS_Shape shape_of(const Selection& selection, const std::vector<int>& faces,
                      const occt::Model& model) {
  TopTools_IndexedMapOfShape solids, edges, bounding;
  TopExp::MapShapes(model.shape(), TopAbs_SOLID, solids);
  TopExp::MapShapes(model.shape(), TopAbs_EDGE, edges);
  std::vector<TopoDS_Shape> shapes;
  for (const int number : selection.solids) {
    shapes.push_back(solids(number));
    TopExp::MapShapes(solids(number), TopAbs_FACE, bounding);
  }
  for (const int number : faces)
    if (!bounding.Contains(model.face(number))) shapes.push_back(model.face(number));
  for (const int number : selection.edges) shapes.push_back(edges(number));
  return occt::compound_of(shapes);
}

}  // namespace

Selection selection_of(const occt::Model& model, const std::vector<std::string>& words) {
  Selecting selecting(model);
  for (const std::string& word : words) selecting.add(word);
  return selecting.made();
}

void choose(const Selection& selection, Input& input) {
  std::set<int> faces(input.numbers.begin(), input.numbers.end());
  faces.insert(selection.faces.begin(), selection.faces.end());
  input.numbers.assign(faces.begin(), faces.end());
  input.solids.assign(selection.solids.begin(), selection.solids.end());
  input.edges.assign(selection.edges.begin(), selection.edges.end());
  if (!input.solids.empty() || !input.edges.empty())
    input.selected = shape_of(selection, input.numbers, input.model);
}

bool is_of_solids(const Input& input) {
  if (static_cast<int>(input.numbers.size()) == input.model.face_count()) return true;
  TopTools_IndexedMapOfShape solids, bounding;
  TopExp::MapShapes(input.model.shape(), TopAbs_SOLID, solids);
  for (const int number : input.solids) TopExp::MapShapes(solids(number), TopAbs_FACE, bounding);
  return !input.solids.empty() && std::ranges::all_of(input.faces, [&](const TopoDS_Face& face) {
    return bounding.Contains(face);
  });
}

occt::Model alone(const Input& input) {
  std::map<int, std::vector<TopoDS_Face>> others;
  for (int number = 1; number <= input.model.face_count(); ++number) others[number];
  for (const int number : input.numbers) others.erase(number);
  occt::Model model = input.model.copy();
  if (!others.empty()) model.replace_faces(others);
  if (const std::vector<TopoDS_Shape> edges = edges_named_alone(input); !edges.empty())
    model.add(occt::compound_of(edges), "edges");
  return model;
}

std::optional<occt::Model> alone_for_solids(const Input& input) {
  if (!input.edges.empty() && input.numbers.empty()) {
    occt::Model model;
    model.add(input.selected, "edges");
    return model;
  }
  if (input.edges.empty() && static_cast<int>(input.numbers.size()) == input.model.face_count())
    return std::nullopt;
  if (!input.edges.empty())
    throw occt::BadModel(input.name + ": edges are combined alone, not beside faces or solids");
  return alone(input);
}

std::vector<std::string> words_in(const occt::Model& model, const std::string& list) {
  const Selecting names(model);
  std::vector<std::string> entries, words;
  for (std::size_t begin = 0, comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = list.find(',', begin);
    entries.push_back(list.substr(begin, comma - begin));
  }
  for (std::size_t i = 0; i < entries.size();) {
    std::string word = entries[i], longer = word;
    std::size_t next = i + 1;
    for (std::size_t j = i + 1; j < entries.size(); ++j) {
      longer += "," + entries[j];
      if (!names.is_called(longer)) continue;
      word = longer;
      next = j + 1;
    }
    words.push_back(word);
    i = next;
  }
  return words;
}

}  // namespace blossom::reports
