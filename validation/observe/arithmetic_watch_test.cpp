// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/arithmetic_watch.h"

#include <gtest/gtest.h>

#include <limits>

#include "validation/core/case_run.h"
#include "validation/engine/engine.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

double divided(double a, double b) {
  // As it is run, not as it is compiled, and whether or not anyone looks at it.
  const volatile double x = a, y = b, quotient = x / y;
  return quotient;
}

TEST(ArithmeticWatch, SeesWhatHasNoNumberForAnAnswer) {
  const ArithmeticWatch watch;
  EXPECT_EQ(watch.found(), "");
  divided(1.0, 3.0);
  EXPECT_EQ(watch.found(), "") << "to round is no fault";
  divided(1.0, 0.0);
  EXPECT_EQ(watch.found(), "a division by zero");
  divided(0.0, 0.0);
  divided(1e308, 1e-308);
  EXPECT_EQ(watch.found(), "an invalid operation, a division by zero, an overflow");
}

TEST(ArithmeticWatch, LeavesWhatWasThereBefore) {
  const ArithmeticWatch outer;
  divided(1.0, 0.0);
  {
    const ArithmeticWatch inner;
    EXPECT_EQ(inner.found(), "");
    divided(0.0, 0.0);
  }
  EXPECT_EQ(outer.found(), "a division by zero");
}

// An engine that divides by zero in a step, and looks right.
EngineKind careless() {
  EngineKind kind = find_engine("plain");
  kind.make = [make = kind.make](const Settings& settings) {
    class Careless final : public Engine {
     public:
      explicit Careless(std::unique_ptr<Engine> inner) : inner_(std::move(inner)) {}
      void load(const Problem& problem, const Accuracy& accuracy) override {
        inner_->load(problem, accuracy);
      }
      double time_step() const override { return inner_->time_step(); }
      std::uint64_t steps_done() const override { return inner_->steps_done(); }
      void advance(std::uint64_t steps) override {
        divided(0.0, 0.0);
        inner_->advance(steps);
      }
      BodyMotion body(std::size_t index) const override { return inner_->body(index); }
      Energies energies() const override { return inner_->energies(); }
      Momenta momenta() const override { return inner_->momenta(); }
      Settings settings() const override { return inner_->settings(); }
      Cost cost() const override { return inner_->cost(); }
      std::uint64_t state_hash() const override { return inner_->state_hash(); }

     private:
      std::unique_ptr<Engine> inner_;
    };
    return std::unique_ptr<Engine>(std::make_unique<Careless>(make(settings)));
  };
  return kind;
}

TEST(ArithmeticWatch, MakesTheRecordAnError) {
  const Case one{.name = "a/b", .title = "falls"};
  InclineSetup setup;
  setup.shape = PointShape{};
  for (const bool wrong : {false, true}) {
    CaseRun run(one, wrong ? careless() : find_engine("plain"), {}, 1.0);
    run.simulate(incline_problem(setup))->advance(3);
    const Record record = run.record();
    EXPECT_EQ(record.verdict == Verdict::kError, wrong);
    EXPECT_EQ(record.error, wrong ? "the engine's arithmetic did an invalid operation: what it "
                                    "gave is not to be trusted"
                                  : "");
    EXPECT_EQ(record.cost.steps, 3u) << "billed in either case";
  }
}

}  // namespace
}  // namespace stiction
