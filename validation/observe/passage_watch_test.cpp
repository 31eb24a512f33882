// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/passage_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/meshes/box_mesh.h"
#include "solver/mesh/mesh.h"
#include "validation/core/case_run.h"
#include "validation/core/runner.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Boxes that fly straight on, whatever is in their way: an engine without contacts.
class Ghosts final : public Engine {
 public:
  void load(const Problem& problem, const Accuracy&) override { problem_ = problem; }
  double time_step() const override { return 1e-3; }
  std::uint64_t steps_done() const override { return steps_; }
  void advance(std::uint64_t steps) override { steps_ += steps; }
  BodyMotion body(std::size_t b) const override {
    const ProblemBody& body = problem_.bodies.at(b);
    return {body.position + 1e-3 * static_cast<double>(steps_) * body.velocity, body.velocity};
  }
  std::vector<ContactSample> contacts() const override { return {}; }
  Eigen::Matrix3Xi surface(std::size_t b) const override {
    return surface_triangles(mesh(b).tetrahedra);
  }
  Eigen::Matrix3Xd vertices(std::size_t b) const override {
    return mesh(b).vertices.colwise() + body(b).position;
  }
  Energies energies() const override { return {}; }
  Momenta momenta() const override { return {}; }
  Settings settings() const override { return {}; }
  Cost cost() const override { return {}; }
  std::uint64_t state_hash() const override { return 0; }
  Snapshot save() const override { return nullptr; }
  void restore(const Snapshot&) override {}

 private:
  TetMesh mesh(std::size_t b) const {
    return reference::box_mesh(std::get<BoxShape>(problem_.bodies.at(b).shape).size, {1, 1, 1});
  }
  Problem problem_;
  std::uint64_t steps_ = 0;
};

EngineKind ghosts() {
  EngineKind kind = find_engine("stiction");
  kind.make = [](const Settings&) -> std::unique_ptr<Engine> { return std::make_unique<Ghosts>(); };
  return kind;
}

ProblemBody box(const char* name, const Vec3& size, const Vec3& position,
                const Vec3& velocity = Vec3::Zero()) {
  return {.name = name,
          .shape = BoxShape{size},
          .elasticity = {},
          .position = position,
          .velocity = velocity};
}

// A cube that reaches a sheet of 2 mm after 5 ms and has left it again after 10.
Problem cube_through_sheet() {
  Problem problem;
  problem.bodies = {box("cube", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.151}, {0.0, 0.0, -20.0}),
                    box("sheet", {0.4, 0.4, 0.002}, {0.01, 0.02, 0.0})};
  return problem;
}

std::vector<std::string> seen(const Problem& problem, std::uint64_t steps) {
  Ghosts engine;
  engine.load(problem, {});
  PassageWatch watch(problem);
  while (watch.due_step() <= steps) {
    engine.advance(watch.due_step() - engine.steps_done());
    watch.look(engine);
  }
  engine.advance(steps - engine.steps_done());
  watch.look(engine, true);
  return watch.found();
}

TEST(PassageWatch, SeesACubeFlyThroughASheetAlthoughItHasLeftItInTheEnd) {
  EXPECT_THAT(seen(cube_through_sheet(), 4), IsEmpty());
  EXPECT_THAT(seen(cube_through_sheet(), 100),
              ElementsAre(testing::AllOf(HasSubstr("cube"), HasSubstr("sheet"))));
}

TEST(PassageWatch, TellsOfOneBarThroughAnotherWithTheDepth) {
  Problem problem;
  problem.bodies = {box("upper bar", {0.4, 0.05, 0.05}, {0.0, 0.0, 0.03}),
                    box("lower bar", {0.05, 0.4, 0.05}, {0.0, 0.0, 0.0})};
  EXPECT_THAT(seen(problem, 1),
              ElementsAre("'upper bar' passes through 'lower bar', 20 mm deep, at "
                          "t = 0.001 s"));
  problem.bodies[0].position.z() = 0.04;  // 10 mm deep: less than a quarter of 50
  EXPECT_THAT(seen(problem, 1), IsEmpty());
}

TEST(PassageWatch, TellsOfABodyInsideAnother) {
  Problem problem;
  problem.bodies = {box("big", {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}),
                    box("small", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.0})};
  EXPECT_THAT(seen(problem, 1), ElementsAre("'small' is 450 mm inside 'big' at t = 0 s"));
}

TEST(PassageWatch, LeavesStandingDepthsAndFlushFacesAlone) {
  Problem problem;
  problem.bodies = {box("lower", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.05}),
                    box("upper", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.15}),
                    box("beside", {0.1, 0.1, 0.1}, {0.0999, 0.0, 0.0501})};
  EXPECT_THAT(seen(problem, 1), IsEmpty());
}

TEST(PassageWatch, TellsOfACentreBeneathTheGround) {
  Problem problem;
  problem.bodies = {box("box", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.05}, {0.0, 0.0, -1.0})};
  problem.obstacles = {{.name = "ground"}};
  EXPECT_THAT(seen(problem, 40), IsEmpty());
  EXPECT_THAT(seen(problem, 60), ElementsAre("the centre of 'box' is 10 mm beneath 'ground' at t = "
                                             "0.06 s"));
}

TEST(PassageWatch, TellsOfABodyTooFarAwayToBeLookedAt) {
  Problem problem;
  problem.bodies = {box("rocket", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.05}, {0.0, 0.0, 1e203}),
                    box("box", {0.1, 0.1, 0.1}, {0.0, 0.0, 0.15})};
  EXPECT_THAT(seen(problem, 50),
              ElementsAre(testing::AllOf(HasSubstr("'rocket'"), HasSubstr("more than 1e+60"))));
}

// And so on to the end: what has no place is waited for as what rests.
TEST(PassageWatch, GoesOnPastABodyThatIsNoNumber) {
  Problem problem;
  problem.bodies = {box("lost", {0.1, 0.1, 0.1}, {0.0, 0.0, NAN})};
  EXPECT_THAT(seen(problem, 500), IsEmpty());
}

Record record_of(const Settings& settings, void (*prepare)(CaseRun&)) {
  Case one{.name = "test/sheet", .title = "a test"};
  one.run = [prepare](CaseRun& run) {
    prepare(run);
    run.simulate(cube_through_sheet())->advance(100);
    run.check({.quantity = "nothing", .unit = "1", .tolerance = 1.0}, 0.0);
  };
  return run_job({one, ghosts(), settings}, 1.0);
}

TEST(PassageWatch, MakesARecordAnErrorWhateverItsChecksSay) {
  const Record record = record_of({}, [](CaseRun&) {});
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("'cube'"));
  EXPECT_EQ(record.checks.size(), 1u);
}

TEST(PassageWatch, IsANoteOfTheOldMethodAndWhereTheCaseCountsPassagesItself) {
  for (const Record& record : {record_of({{"method", "old"}}, [](CaseRun&) {}),
                               record_of({}, [](CaseRun& run) { run.passages_are_noted(); })}) {
    EXPECT_NE(record.verdict, Verdict::kError);
    EXPECT_EQ(record.error, "");
    ASSERT_EQ(record.notes.size(), 1u);
    EXPECT_THAT(record.notes[0], HasSubstr("'cube'"));
  }
}

}  // namespace
}  // namespace stiction
