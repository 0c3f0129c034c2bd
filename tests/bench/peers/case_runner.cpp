// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/peers/case_runner.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <nlohmann/json.hpp>

namespace blossom::bench {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// The median of so many calls, and of so many seconds of them, is the time of a case.
constexpr int kCalls = 5;
constexpr double kCallsTogether = 0.03;
constexpr double kSlowCall = 0.2;  // seconds: one such call is enough

struct Settings {
  fs::path cases, out;
  double limit = 10;  // seconds of a call
  std::string only;
};

Settings settings_of(int argc, char** argv) {
  Settings settings;
  std::vector<std::string> folders;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const bool takes_value = word == "--limit" || word == "--only";
    if (takes_value && k + 1 == argc) throw std::invalid_argument(word + " needs a value");
    if (word == "--limit")
      settings.limit = std::stod(argv[++k]);
    else if (word == "--only")
      settings.only = argv[++k];
    else
      folders.push_back(word);
  }
  if (folders.size() != 2)
    throw std::invalid_argument("usage: CASES_FOLDER OUT_FOLDER [--limit SECONDS] [--only PREFIX]");
  settings.cases = folders[0];
  settings.out = folders[1];
  return settings;
}

TopoDS_Face face_in(const fs::path& file) {
  TopoDS_Shape shape;
  BRepTools::Read(shape, file.c_str(), BRep_Builder());
  if (shape.IsNull()) throw std::runtime_error(file.string() + ": no shape in it");
  const TopExp_Explorer faces(shape, TopAbs_FACE);
  if (!faces.More()) throw std::runtime_error(file.string() + ": no face in it");
  return TopoDS::Face(faces.Current());
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Json json_of(const Answer& answer) {
  Json json = {{"status", answer.status}, {"points", answer.points}};
  json["curves"] = Json::array();
  for (const SampledCurve& curve : answer.curves)
    json["curves"].push_back(
        {{"closed", curve.closed}, {"tangential", curve.tangential}, {"points", curve.points}});
  json["overlaps"] = Json::array();
  for (const auto& border : answer.overlaps) json["overlaps"].push_back({{"boundary", border}});
  if (!answer.claim.empty()) json["claim"] = answer.claim;
  return json;
}

Json solved(const Solver& solver, const Pair& pair) {
  solver.prepare(pair);
  std::vector<double> seconds{seconds_of(solver.solve)};
  const double first = seconds.front();
  double together = first;
  while (first < kSlowCall && (seconds.size() < kCalls || together < kCallsTogether)) {
    seconds.push_back(seconds_of(solver.solve));
    together += seconds.back();
  }
  std::sort(seconds.begin(), seconds.end());
  Json json = json_of(solver.answer());
  json["seconds"] = seconds[seconds.size() / 2];
  json["seconds_first"] = first;
  return json;
}

// In the child: the line of a case goes to a file, since solvers print to the console.
[[noreturn]] void work_and_report(const Solver& solver, const Pair& pair, const fs::path& file,
                                  double limit) {
  alarm(static_cast<unsigned>(kCalls * kSlowCall + limit + 1));
  Json json;
  try {
    json = solved(solver, pair);
  } catch (const Standard_Failure&) {
    json = {{"status", "exception"}};
  } catch (const std::exception& error) {
    json = {{"status", "exception"}, {"message", error.what()}};
  }
  std::ofstream(file) << json;
  _exit(0);
}

Json measured(const Solver& solver, const Pair& pair, const Settings& settings) {
  const fs::path file = settings.out / (solver.name + ".answer.json");
  fs::remove(file);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a case");
  if (child == 0) work_and_report(solver, pair, file, settings.limit);
  int status = 0;
  waitpid(child, &status, 0);
  Json json = {{"status", "error"}};
  if (WIFSIGNALED(status))
    json["status"] =
        WTERMSIG(status) == SIGALRM ? "timeout" : "crash" + std::to_string(WTERMSIG(status));
  else if (std::ifstream in(file); in)
    json = Json::parse(in);
  fs::remove(file);
  for (const char* list : {"curves", "points", "overlaps"})
    if (!json.contains(list)) json[list] = Json::array();
  if (!json.contains("seconds")) json["seconds"] = settings.limit;
  return json;
}

void run(const Settings& settings, const std::vector<Solver>& solvers) {
  fs::create_directories(settings.out);
  std::vector<std::ofstream> results;
  for (const Solver& solver : solvers)
    results.emplace_back(settings.out / (solver.name + ".jsonl"));
  std::ifstream list(settings.cases / "cases.jsonl");
  if (!list) throw std::runtime_error(settings.cases.string() + ": no cases.jsonl in it");
  for (std::string line; std::getline(list, line);) {
    const Json entry = Json::parse(line);
    const std::string name = entry.at("name");
    if (!name.starts_with(settings.only)) continue;
    const Pair pair{face_in(settings.cases / entry.at("a").get<std::string>()),
                    face_in(settings.cases / entry.at("b").get<std::string>()), entry.at("size"),
                    entry.at("tolerance")};
    for (std::size_t k = 0; k < solvers.size(); ++k) {
      Json json = measured(solvers[k], pair, settings);
      json["tool"] = solvers[k].name;
      json["case"] = name;
      results[k] << json << std::endl;
    }
  }
}

}  // namespace

int run_cases(int argc, char** argv, const std::vector<Solver>& solvers) {
  try {
    run(settings_of(argc, argv), solvers);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
}

}  // namespace blossom::bench
