// SPDX-License-Identifier: GPL-3.0-or-later
// A soft cube thrown on a thin sheet: it must not go through without a word.
#include <fmt/format.h>

#include <string>

#include "solver/demand.h"
#include "validation/core/case_run.h"
#include "validation/observe/passage_watch.h"
#include "validation/problems/sheet_problem.h"

namespace stiction {

namespace {

void run_sheets(CaseRun& run, Stance stance, bool backed) {
  constexpr double kDuration = 0.2;  // s: the sheet throws the cube back within 0.1 s
  run.passages_are_noted();
  int silent = 0, watched = 0, spoken = 0, throws = 0;
  std::string where;
  Series passed{"passed (1) or not (0)", "1", "throw", "1", {}, {}};
  for (const double thickness : {2e-3, 5e-3, 10e-3}) {
    for (const double speed : {5.0, 10.0, 20.0}) {
      SheetSetup setup;
      setup.thickness = thickness;
      setup.speed = speed;
      setup.stance = stance;
      setup.backed = backed;
      const std::string words = fmt::format("{:.0f} m/s on {:.0f} mm", speed, 1e3 * thickness);
      bool through = false, seen = false;
      try {
        const Problem problem = sheet_problem(setup);
        PassageWatch watch(problem);
        const auto simulation = run.simulate(problem);
        simulation->record_frames(2e-3);
        for (int k = 1; k <= 200 && !through; ++k) {
          simulation->advance_to(kDuration * k / 200.0);
          watch.look(simulation->engine());
          seen = !watch.found().empty();
          through = seen || has_passed(simulation->engine(), setup);
        }
        if (seen) {
          ++watched;
          run.note(words + ": seen by the watch alone: " + watch.found().front());
        } else if (through) {
          run.note(fmt::format("{}: beyond it at {:.1f} ms", words, 1e3 * simulation->time()));
        }
      } catch (const InputError& refusal) {
        ++spoken;
        through = seen = false;
        run.note(words + ": refused in words: " + refusal.what());
      }
      if (through && !seen && silent++ == 0) where = "first: " + words;
      passed.x.push_back(++throws);
      passed.y.push_back(through);
    }
  }
  run.add(passed);
  run.note(fmt::format(
      "of {} throws {} passed silently, {} lay deeper than contact explains, which the watch alone "
      "saw and would make an error of any other case, {} were refused in words by the engine",
      throws, silent, watched, spoken));
  run.check(
      {.quantity = "silent passages",
       .unit = "1",
       .statement = "a soft cube thrown on a held sheet does not pass through it in silence",
       .formula = "the centre stays above the sheet, or the engine refuses, or the watch reports",
       .source = "bodies do not pass through each other",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 0.0,
       .reason = "a count of nine throws: 5, 10, 20 m/s on 2, 5, 10 mm"},
      static_cast<double>(silent), where);
  run.show({.quantity = "passages that the watch alone reports",
            .unit = "1",
            .statement = "an engine notices by itself",
            .formula = "count = 0",
            .source = "bodies do not pass through each other",
            .kind = ReferenceKind::kAnalytic,
            .expected = 0.0,
            .tolerance = 0.0,
            .reason = "a count of the same throws"},
           static_cast<double>(watched));
}

}  // namespace

std::vector<Case> cases_sheet_thin() {
  std::vector<Case> cases;
  for (const bool backed : {false, true}) {
    for (const auto& [first, stance] :
         {std::pair{"face", Stance::kFace}, std::pair{"edge", Stance::kEdge},
          std::pair{"corner", Stance::kCorner}}) {
      cases.push_back(
          {.name = fmt::format("sheet/thin/{}/{}", backed ? "backed" : "framed", first),
           .title = fmt::format("a soft cube thrown, {} first, at 5 to 20 m/s on a {} sheet of 2 "
                                "to 10 mm",
                                first, backed ? "backed" : "framed"),
           .run = [stance = stance, backed](CaseRun& run) { run_sheets(run, stance, backed); }});
    }
  }
  return cases;
}

}  // namespace stiction
