// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/conversion.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <utility>

#include "plugin/nets/net_models.h"

namespace blossom::nets {
namespace {

using reports::Json;

std::vector<Net> in_form(const std::vector<Net>& nets, TargetForm form, const Stop& stop) {
  std::vector<Net> result;
  for (const Net& net : nets) {
    ask(stop);
    switch (form) {
      case TargetForm::AsItIs: result.push_back(net); break;
      case TargetForm::Bezier: result.push_back(bezier_net(net)); break;
      case TargetForm::Monomial: result.push_back(monomial_net(net)); break;
      case TargetForm::Triangles:
        for (Net& triangle : triangle_nets(net)) result.push_back(std::move(triangle));
        break;
    }
  }
  return result;
}

// As Bezier patches, a triangle too: one of its sides is a point.
std::vector<Net> patches_of(const std::vector<Net>& nets) {
  std::vector<Net> result;
  for (const Net& net : nets) result.push_back(is_triangle(net) ? collapsed_net(net) : net);
  return result;
}

// Face by face: what its trims leave, or all of its surface if it has none or they cannot be
// followed.
void follow_trims(const reports::Input& model, const std::vector<Net>& nets, TargetForm form,
                  double tolerance, const Stop& stop, Conversion& made) {
  TriangleLowering lowering;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const int number = model.numbers[i];
    std::vector<Net> whole;
    for (const Net& net : nets)
      if (net.source.face == number) whole.push_back(net);
    TrimmedNets trimmed;
    if (is_trimmed(model.faces[i]) && !whole.empty()) {
      trimmed = trimmed_nets(model.faces[i], whole.front().source, tolerance, lowering, stop);
      if (!trimmed.obstacle.empty()) ++made.trims_left_out;
    }
    const std::vector<Net>& chosen = trimmed.nets.empty() ? whole : trimmed.nets;
    append(made.nets, form == TargetForm::Bezier && !trimmed.nets.empty()
                          ? patches_of(chosen)
                          : in_form(chosen, form, stop));
    trimmed.nets.clear();
    if (trimmed.face > 0) made.trimmed.push_back(std::move(trimmed));
  }
}

Json trimmed_json(const std::vector<TrimmedNets>& faces) {
  Json list = Json::array();
  for (const TrimmedNets& face : faces) {
    Json json = {{"face", face.face},
                 {"exact", face.exact},
                 {"fitted", face.fitted},
                 {"border_error", face.border_error}};
    if (!face.obstacle.empty()) json["obstacle"] = face.obstacle;
    list.push_back(std::move(json));
  }
  return list;
}

template <class Work>
Conversion timed(const Work& work) {
  Conversion made;
  const auto start = std::chrono::steady_clock::now();
  work(made);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  made.seconds = took.count();
  return made;
}

}  // namespace

std::optional<TargetForm> target_form(const std::string& word) {
  static const std::map<std::string, TargetForm> forms = {{"bezier", TargetForm::Bezier},
                                                          {"monomial", TargetForm::Monomial},
                                                          {"triangles", TargetForm::Triangles}};
  const auto found = forms.find(word);
  return found == forms.end() ? std::nullopt : std::optional(found->second);
}

double Conversion::largest_error() const {
  double error = 0;
  for (const Net& net : nets) error = std::max(error, net.source.error);
  return error;
}

Conversion converted(const std::vector<Net>& nets, TargetForm form, const Stop& stop) {
  return timed([&](Conversion& made) { made.nets = in_form(nets, form, stop); });
}

Conversion converted_faces(const reports::Input& model, const std::vector<Net>& nets,
                           TargetForm form, double tolerance, const Stop& stop) {
  Conversion made = timed([&](Conversion& result) {
    if (form == TargetForm::Bezier || form == TargetForm::Triangles) {
      follow_trims(model, nets, form, tolerance, stop, result);
    } else {
      result.nets = in_form(nets, form, stop);
      result.trims_left_out =
          static_cast<std::size_t>(std::ranges::count_if(model.faces, is_trimmed));
    }
  });
  made.faces = model.faces.size();
  return made;
}

Json conversion_report(const std::string& input, const std::string& output, const std::string& to,
                       const Conversion& made, Json repairs) {
  return {{"schema", "blossom.conversion/1"},
          {"file", input},
          {"output", output},
          {"to", to.empty() ? Json(nullptr) : Json(to)},
          {"faces", made.faces},
          {"nets", made.nets.size()},
          {"trims_left_out", made.trims_left_out},
          {"trimmed", trimmed_json(made.trimmed)},
          {"error", made.largest_error()},
          {"seconds", made.seconds},
          {"repairs", std::move(repairs)}};
}

}  // namespace blossom::nets
