// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/questions.h"

namespace stiction {

const std::vector<Question>& engine_questions() {
  static const std::vector<Question> all = {
      {.id = "creep-0",
       .heading = "creep 0°",
       .words = "Does a box at rest at 90 % of the critical slope creep? Falling to 0°",
       .case_name = "slope/creep/azimuth=0",
       .quantity = "creep",
       .answer = Answer::kMagnitude},
      {.id = "creep-30",
       .heading = "creep 30°",
       .words = "… falling to 30°",
       .case_name = "slope/creep/azimuth=30",
       .quantity = "creep",
       .answer = Answer::kMagnitude,
       .quick = true,
       .curve = true},
      {.id = "gives-0",
       .heading = "gives 0°",
       .words = "At which slope does it give? Falling to 0°",
       .case_name = "slope/gives/azimuth=0",
       .quantity = "slope that gives",
       .answer = Answer::kDegrees,
       .quick = true},
      {.id = "gives-30",
       .heading = "30°",
       .words = "… falling to 30°",
       .case_name = "slope/gives/azimuth=30",
       .quantity = "slope that gives",
       .answer = Answer::kDegrees,
       .quick = true},
      {.id = "gives-45",
       .heading = "45°",
       .words = "… falling to 45°",
       .case_name = "slope/gives/azimuth=45",
       .quantity = "slope that gives",
       .answer = Answer::kDegrees},
      {.id = "accelerates",
       .heading = "accel.",
       .words = "With which acceleration does it slide at 120 % of that? Falling to 30°",
       .case_name = "slope/accelerates/azimuth=30",
       .quantity = "acceleration",
       .quick = true,
       .curve = true},
      {.id = "stops",
       .heading = "stop",
       .words = "How far does it slide on level ground? Thrown to 30°",
       .case_name = "slope/stops/azimuth=30",
       .quantity = "stopping distance",
       .quick = true,
       .curve = true},
  };
  return all;
}

}  // namespace stiction
