// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/core/runner.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

// A box lands on a slope of tan θ = 0.3 and slides; the slope is recorded where `interval` > 0.
Job slide(double interval) {
  const auto sliding = [interval](CaseRun& run) {
    InclineSetup setup;
    setup.tan_slope = 0.3;
    setup.speed = 1.0;
    const auto simulation = run.simulate(incline_problem(setup));
    if (interval > 0.0) simulation->record_frames(interval);
    simulation->advance_to(0.1);
  };
  return {{.name = "test/slide", .title = "a test", .run = sliding}, find_engine("stiction"), {}};
}

Recording recorded(const Job& job) {
  std::optional<Recording> recording;
  const Record record = run_job(job, 1.0, &recording);
  EXPECT_EQ(record.error, "");
  return recording.value_or(Recording{});
}

TEST(Recorder, TakesFramesAtEvenTimes) {
  const Recording recording = recorded(slide(0.03));
  ASSERT_EQ(recording.frames.size(), 4u);
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_NEAR(recording.frames[f].time, 0.03 * static_cast<double>(f), 1e-12);
  }
  EXPECT_EQ(recording.title, "incline");
  ASSERT_EQ(recording.planes.size(), 1u);
  EXPECT_EQ(recording.frames[0].gravity, (Triple{0.0, 0.0, -kStandardGravity}));
}

TEST(Recorder, ShowsTheSurfaceAndTheContactsOfTheBox) {
  const Recording recording = recorded(slide(0.1));
  ASSERT_EQ(recording.bodies.size(), 1u);
  // 2 × 2 × 1 cells: all 3 × 3 × 2 vertices lie on the surface, 2 triangles on each of 16 squares.
  EXPECT_EQ(recording.bodies[0].vertices, 18u);
  EXPECT_EQ(recording.bodies[0].triangles.size(), 32u);
  ASSERT_EQ(recording.frames.size(), 2u);
  EXPECT_TRUE(recording.frames[0].contacts.empty());
  const Frame& last = recording.frames[1];
  ASSERT_EQ(last.contacts.size(), 9u);
  double normal = 0.0;
  double travel = 0.0;
  for (const FrameContact& contact : last.contacts) {
    EXPECT_FALSE(contact.sticks);
    normal += std::hypot(contact.normal_force[0], contact.normal_force[1], contact.normal_force[2]);
  }
  EXPECT_NEAR(normal, kStandardGravity * std::cos(std::atan(0.3)), 1.0);
  for (std::size_t v = 0; v < 18; ++v) {
    travel += std::hypot(last.positions[v][0] - recording.frames[0].positions[v][0],
                         last.positions[v][1] - recording.frames[0].positions[v][1]) /
              18.0;
  }
  EXPECT_NEAR(travel, 0.1 * std::cos(std::atan(0.3)), 0.02);
}

TEST(Recorder, ChangesNeitherStateNorSteps) {
  std::optional<Recording> recording;
  const Record with = run_job(slide(0.007), 1.0, &recording);
  const Record without = run_job(slide(0.0), 1.0);
  ASSERT_TRUE(recording.has_value());
  EXPECT_EQ(with.state_hash, without.state_hash);
  EXPECT_EQ(with.cost.steps, without.cost.steps);
  EXPECT_EQ(with.cost.contact_updates, without.cost.contact_updates);
}

TEST(Recorder, OnlyTheFirstSimulationThatAsksIsRecorded) {
  Job job = slide(0.0);
  job.which.run = [](CaseRun& run) {
    InclineSetup setup;
    const auto first = run.simulate(incline_problem(setup));
    const auto second = run.simulate(incline_problem(setup));
    second->record_frames(0.01);
    first->record_frames(0.01);
    second->advance_to(0.02);
    first->advance_to(0.05);
  };
  EXPECT_EQ(recorded(job).frames.size(), 3u);
}

TEST(Recorder, WhatIsKeptIsNamedInTheRecord) {
  const std::vector<Job> jobs = {slide(0.0), slide(0.05)};
  std::vector<Record> records(2);
  const auto finished = [&](std::size_t index, Record record) { records[index] = record; };
  const std::size_t order[] = {0, 1};
  run_jobs(jobs, order, 1, 1.0, finished, [](std::size_t index, const Recording& recording) {
    return std::to_string(index) + ":" + std::to_string(recording.frames.size());
  });
  EXPECT_EQ(records[0].frames, "");
  EXPECT_EQ(records[1].frames, "1:3");
}

TEST(Recorder, NothingIsRecordedUnlessSomebodyAsks) {
  std::optional<Recording> recording;
  run_job(slide(0.0), 1.0, &recording);
  EXPECT_FALSE(recording.has_value());
}

// One triangle that doubles its way from the origin with every step of 1 s.
class Runaway final : public Engine {
 public:
  explicit Runaway(bool visible, double start = 1.0) : visible_(visible), start_(start) {}
  void load(const Problem&, const Accuracy&) override {}
  double time_step() const override { return 1.0; }
  std::uint64_t steps_done() const override { return steps_; }
  void advance(std::uint64_t steps) override { steps_ += steps; }
  BodyMotion body(std::size_t) const override { return {}; }
  std::vector<ContactSample> contacts() const override { return {}; }
  Energies energies() const override { return {}; }
  Momenta momenta() const override { return {}; }
  Settings settings() const override { return {}; }
  Cost cost() const override { return {}; }
  std::uint64_t state_hash() const override { return 0; }
  Snapshot save() const override { return nullptr; }
  void restore(const Snapshot&) override {}
  Eigen::Matrix3Xi surface(std::size_t) const override {
    return visible_ ? Eigen::Matrix3Xi(Eigen::Vector3i(2, 0, 1)) : Eigen::Matrix3Xi();
  }
  Eigen::Matrix3Xd vertices(std::size_t) const override {
    const double way = start_ * std::exp2(static_cast<double>(steps_));
    return (Eigen::Matrix3Xd(3, 3) << 0, 1, 0, 0, 0, 1, way, way, way).finished();
  }

 private:
  bool visible_;
  double start_;
  std::uint64_t steps_ = 0;
};

Problem one_body() {
  Problem problem;
  problem.bodies.push_back({.name = "triangle", .shape = PointShape{}, .elasticity = {}});
  return problem;
}

TEST(Recorder, EndsWhereSomethingFliesOff) {
  Runaway engine(true);
  Recorder recorder(one_body());
  recorder.start(engine, 1.0);
  int taken = 1;
  for (; recorder.due_step() < 100; ++taken) {
    engine.advance(recorder.due_step() - engine.steps_done());
    recorder.take(engine);
  }
  // √2 m across, it is left when it is 50 times as far away: 64 m is seen, 128 m is not.
  EXPECT_EQ(taken, 8);
  EXPECT_EQ(std::move(recorder).recording().frames.size(), 7u);
}

TEST(Recorder, WhatIsNoNumberIsNotRecorded) {
  Runaway engine(true, std::nan(""));
  Recorder recorder(one_body());
  recorder.start(engine, 1.0);
  EXPECT_FALSE(recorder.has_frames());
  EXPECT_GT(recorder.due_step(), 1000000u);
}

TEST(Recorder, AnEngineThatShowsNoSurfaceIsNotRecorded) {
  Runaway engine(false);
  Recorder recorder(one_body());
  recorder.start(engine, 1.0);
  EXPECT_FALSE(recorder.has_frames());
  EXPECT_GT(recorder.due_step(), 1000000u);
}

}  // namespace
}  // namespace stiction
