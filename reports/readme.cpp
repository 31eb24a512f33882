// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction readme`: records of runs → kept figures → the documents' tables.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "reports/documents/document.h"
#include "reports/documents/kept_figures.h"
#include "reports/record/record_json.h"
#include "reports/record/whole_file.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/text/exit_code.h"

namespace stiction {

namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string root = ".";
  std::vector<std::string> update, against;
  bool check = false;
};

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw std::runtime_error(fmt::format("{} cannot be read", file.string()));
  return content.str();
}

using Runs = std::vector<std::vector<Record>>;

// Of a run's folder, of an out-dir with its 'latest', or a file of records.
Runs read_runs(const std::vector<std::string>& names) {
  Runs runs;
  for (const std::string& name : names) {
    fs::path file = name;
    if (fs::is_directory(file / "latest")) file /= "latest";
    if (fs::is_directory(file)) file /= "records.jsonl";
    RecordFile read = read_records(file);
    if (!read.unfinished.empty()) throw std::runtime_error(read.unfinished);
    for (const Record& record : read.records) {
      if (record.differs.contains(kFinerSetting)) {
        throw std::runtime_error(fmt::format(
            "{} was run with --finer, and documents tell of the usual time steps", file.string()));
      }
    }
    runs.push_back(std::move(read.records));
  }
  return runs;
}

class Project {
 public:
  explicit Project(const fs::path& root) : root_(root), folder_(root / "reports/documents") {
    if (!fs::is_directory(folder_ / "figures")) {
      throw std::runtime_error(
          fmt::format("{} has no folder reports/documents/figures", root.string()));
    }
    for (const auto& entry : fs::directory_iterator(folder_ / "figures")) {
      if (entry.path().extension() == ".toml") rules_.push_back(read_figure_rules(entry.path()));
    }
    std::sort(rules_.begin(), rules_.end(),
              [](const auto& a, const auto& b) { return a.program < b.program; });
  }

  // The programs of which these runs tell.
  std::vector<const FigureRules*> told_by(const Runs& runs) const {
    const std::vector<Record> records = records_of(runs);
    std::vector<const FigureRules*> told;
    for (const FigureRules& rules : rules_) {
      if (tells(rules, records)) told.push_back(&rules);
    }
    if (told.empty()) throw std::runtime_error("these runs have none of the documents' figures");
    return told;
  }

  void update(const Runs& runs) const {
    for (const FigureRules* rules : told_by(runs)) {
      write_whole(kept_file(*rules), to_json(figures_of(*rules, runs)));
      show_line(relative(kept_file(*rules)));
    }
  }

  bool agrees_with(const Runs& runs) const {
    bool all = true;
    for (const FigureRules* rules : told_by(runs)) {
      const KeptFigures kept = read_kept_figures(kept_file(*rules));
      for (const std::string& sentence : disagreements(*rules, kept, figures_of(*rules, runs))) {
        show_line(fmt::format("{}.toml: {}", rules->program, sentence));
        all = false;
      }
    }
    return all;
  }

  // Writes the documents, or only says which ones would change.
  bool documents(bool only_check) const {
    FigureTexts texts;
    for (const FigureRules& rules : rules_) texts.add(rules, read_kept_figures(kept_file(rules)));
    const Templates templates = [&](const std::string& name) {
      const fs::path file = folder_ / "tables" / (name + ".md");
      if (name.find('/') != std::string::npos || !fs::is_regular_file(file)) {
        throw std::runtime_error(fmt::format("there is no reports/documents/tables/{}.md", name));
      }
      return content_of(file);
    };
    bool same = true;
    for (const fs::path& file : markdown_files()) {
      const std::string before = content_of(file);
      if (!has_markers(before)) continue;
      const std::string after = written(before, relative(file), texts, templates);
      if (before == after) continue;
      same = false;
      if (!only_check) write_whole(file, after);
      show_line(fmt::format(
          "{}{}", relative(file),
          only_check ? " differs from the kept figures: ./stiction readme writes it" : ""));
    }
    for (const std::string& name : texts.unused()) {
      show_line(fmt::format("The figure '{}' stands in no document.", name));
      same = false;
    }
    return same;
  }

 private:
  static bool tells(const FigureRules& rules, const std::vector<Record>& records) {
    return std::any_of(rules.figures.begin(), rules.figures.end(), [&](const FigureRule& rule) {
      return std::any_of(records.begin(), records.end(),
                         [&](const Record& record) { return is_of(rule, record); });
    });
  }

  std::vector<fs::path> markdown_files() const {
    std::vector<fs::path> files;
    for (auto at = fs::recursive_directory_iterator(root_);
         at != fs::recursive_directory_iterator(); ++at) {
      const std::string name = at->path().filename().string();
      if (at->is_directory() && (name == "build" || name.front() == '.' || at->path() == folder_)) {
        at.disable_recursion_pending();
      } else if (at->is_regular_file() && at->path().extension() == ".md") {
        files.push_back(at->path());
      }
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  fs::path kept_file(const FigureRules& rules) const {
    return folder_ / "figures" / (rules.program + ".json");
  }
  std::string relative(const fs::path& file) const { return fs::relative(file, root_).string(); }

  fs::path root_, folder_;
  std::vector<FigureRules> rules_;
};

int readme(const Arguments& arguments) {
  const Project project(fs::absolute(arguments.root).lexically_normal());
  bool agree = true;
  if (!arguments.update.empty()) project.update(read_runs(arguments.update));
  if (!arguments.against.empty()) agree = project.agrees_with(read_runs(arguments.against));
  const bool only_look = arguments.check || !arguments.against.empty();
  if (!project.documents(only_look) && only_look) agree = false;
  return agree ? kHolds : kDoesNotHold;
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  CLI::App app(
      "Writes the measured figures of README and documents, between their markers, from the\n"
      "committed extracts of runs (reports/documents/README.md).",
      "stiction readme");
  stiction::Arguments arguments;
  app.add_option(
         "--update", arguments.update,
         "Renew the extracts from these runs first: folders of ./stiction validate, compare, "
         "bench or track sizes; of what several runs have measured, the last counts")
      ->type_name("RUN…")
      ->group("What is done");
  app.add_option("--against", arguments.against,
                 "Write nothing; say which figures of these runs have another verdict than in the "
                 "documents, or have left their band")
      ->type_name("RUN…")
      ->group("What is done");
  app.add_flag("--check", arguments.check, "Write nothing; say which documents are out of date")
      ->group("What is done");
  app.add_option("--root", arguments.root, "Of the source tree")
      ->type_name("DIR")
      ->capture_default_str()
      ->group("Where");
  stiction::set_help(
      app,
      {.name = "stiction-readme",
       .summary = "writes the measured figures of README and documents",
       .synopsis = {"./stiction readme [--update RUN...]",
                    "./stiction readme --check | --against RUN..."},
       .description = "Every measured figure of a document stands between markers and comes from a "
                      "record. This writes "
                      "them from the extracts that are kept in the tree, renews the extracts from "
                      "runs, or says what "
                      "is out of date.",
       .exit_codes = {{"0", "all agree"},
                      {"1", "something differs"},
                      {"2", "a figure could not be found, or a file not read"}},
       .files = {{"reports/documents/figures/*.toml", "which number of which record a figure is"},
                 {"reports/documents/figures/*.json",
                  "the extracts, with revision, machine and date"},
                 {"reports/documents/tables/*.md",
                  "tables in which {{figure}} stands for a figure"}},
       .examples = {{"./stiction readme --update validation-report", "after a run of validate"},
                    {"./stiction readme --check",
                     "is any document out of date? (a test of ./stiction test)"},
                    {"./stiction readme --against validation-report", "does a fresh run agree?"}},
       .see_also = {"./stiction help validate", "./stiction help compare",
                    "reports/documents/README.md"}});
  return stiction::run_program(app, argc, argv, [&] { return stiction::readme(arguments); });
}
