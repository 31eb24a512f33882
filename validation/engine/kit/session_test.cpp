// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/kit/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solver/demand.h"
#include "validation/engine/protocol/program_kind.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

int held = 0;  // saved states that nobody has freed

void* load(const stiction_problem*) { return new double(0.0); }
double time_step(void*) { return 0.01; }
void advance(void* self, std::uint64_t steps) {
  *static_cast<double*>(self) += static_cast<double>(steps);
}
void body(void* self, std::size_t, stiction_body_state* state) {
  state->position[0] = *static_cast<double*>(self);
}
void* save(void* self) {
  ++held;
  return new double(*static_cast<double*>(self));
}
void restore(void* self, const void* saved) {
  *static_cast<double*>(self) = *static_cast<const double*>(saved);
}
void forget(void*, void* saved) {
  --held;
  delete static_cast<double*>(saved);
}
void end(void* self) { delete static_cast<double*>(self); }

stiction_engine counter() {
  stiction_engine one{};
  one.name = "counter";
  one.version = "1";
  one.description = "counts its steps";
  one.can = "boxes half-spaces";
  one.load = load;
  one.time_step = time_step;
  one.advance = advance;
  one.body = body;
  one.save = save;
  one.restore = restore;
  one.forget = forget;
  one.end = end;
  return one;
}

TEST(Session, ForgetsStatesThatNobodyHoldsAnyMore) {
  held = 0;
  const stiction_engine engine = counter();
  kit::Session session(engine);
  const EngineKind kind =
      program_kind({"./counter"}, [&](const std::string& line) { return session.reply(line); });
  const auto running = kind.make({});
  running->load(incline_problem({}), {});
  const Snapshot begun = running->save();
  for (int k = 0; k < 100; ++k) {
    const Snapshot before = running->save();
    running->advance(1);
    running->restore(before);
    running->advance(1);
  }
  EXPECT_EQ(running->body(0).position.x(), 100.0);
  EXPECT_LE(held, 3) << "the first, the last, and one that the next save gives up";
  running->restore(begun);
  EXPECT_EQ(running->body(0).position.x(), 0.0);
}

TEST(Session, RoundsByItsSettingAndRefusesAnother) {
  const stiction_engine engine = counter();
  kit::Session session(engine);
  EXPECT_THAT(session.reply(R"({"do":"hello","protocol":1})"), testing::HasSubstr("\"rounding\""));
  const EngineKind kind =
      program_kind({"./counter"}, [&](const std::string& line) { return session.reply(line); });
  const auto running = kind.make({{"rounding", "sideways"}});
  try {
    running->load(incline_problem({}), {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("upward, downward or toward-zero"));
  }
}

// Found by fuzzing: a real number beyond what an integer holds was taken for one.
TEST(Session, TakesCountsAsWholeNumbersOnly) {
  const stiction_engine engine = counter();
  kit::Session session(engine);
  const EngineKind kind = program_kind({"./counter"}, [&](const std::string& line) {
    using nlohmann::json;
    json request = json::parse(line);
    if (request.at("do") == "load") {
      json rough = request;
      for (const json& no_count : {json(4.4e45), json(-1), json("two"), json(3000000000U)}) {
        rough["accuracy"] = {{"fineness", no_count}};
        EXPECT_THAT(session.reply(rough.dump()),
                    testing::HasSubstr("'fineness' is no whole number from 0 to 2147483647"));
      }
    }
    return session.reply(line);
  });
  kind.make({})->load(incline_problem({}), {});
  for (const std::string no_count : {"4.44444e45", "-1", "1.5", "null"}) {
    EXPECT_THAT(session.reply(R"({"do":"advance","steps":)" + no_count + "}"),
                testing::HasSubstr("'steps' is no whole number"));
    EXPECT_THAT(session.reply(R"({"do":"restore","state":)" + no_count + "}"),
                testing::HasSubstr("'state' is no whole number"));
    EXPECT_THAT(session.reply(R"({"do":"save","forget":[)" + no_count + "]}"),
                testing::HasSubstr("a state to forget is no whole number"));
  }
  EXPECT_THAT(session.reply(R"({"do":"advance","steps":2})"), testing::HasSubstr("\"steps\":2"));
}

}  // namespace
}  // namespace stiction
