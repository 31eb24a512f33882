// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "validation/properties/claims.h"
#include "validation/properties/random_scene.h"

namespace stiction::test {

void showValue(const RandomScene& scene, std::ostream& stream) { show(stream, scene); }

}  // namespace stiction::test

namespace rc {

using stiction::test::RandomBody;
using stiction::test::RandomScene;

// Each is drawn from the whole of its range at once, and shrinks towards 0.
Gen<int> below(int count) { return gen::resize(kNominalSize, gen::inRange(0, count)); }

template <std::size_t Count>
Gen<std::array<int, Count>> each_below(int count) {
  return gen::container<std::array<int, Count>>(below(count));
}

template <>
struct Arbitrary<RandomBody> {
  static Gen<RandomBody> arbitrary() {
    return gen::build<RandomBody>(
        gen::set(&RandomBody::shape, below(4)), gen::set(&RandomBody::size, below(3)),
        gen::set(&RandomBody::mass, below(5)), gen::set(&RandomBody::aside, each_below<2>(8)),
        gen::set(&RandomBody::gap, below(6)), gen::set(&RandomBody::axis, below(5)),
        gen::set(&RandomBody::angle, below(19)), gen::set(&RandomBody::velocity, each_below<3>(10)),
        gen::set(&RandomBody::spin, below(10)));
  }
};

template <>
struct Arbitrary<RandomScene> {
  static Gen<RandomScene> arbitrary() {
    return gen::build<RandomScene>(
        gen::set(&RandomScene::ground, below(3)), gen::set(&RandomScene::slope, below(40)),
        gen::set(&RandomScene::gravity, below(2)), gen::set(&RandomScene::mu_decade, below(6)),
        gen::set(&RandomScene::mu, below(10)), gen::set(&RandomScene::damping, below(11)),
        gen::set(&RandomScene::drag, below(20)), gen::set(&RandomScene::load, each_below<3>(6)),
        gen::set(&RandomScene::bodies,
                 gen::resize(3, gen::nonEmpty(gen::arbitrary<std::vector<RandomBody>>()))));
  }
};

}  // namespace rc

namespace stiction::test {
namespace {

// A seed of its own unless one is asked for, so that a test that was green stays green.
const bool kSeeded = setenv("RC_PARAMS", "seed=1 max_success=25", 0) == 0;

constexpr int kSteps = 200;

class Properties : public testing::TestWithParam<std::string> {};

TEST_P(Properties, OfRandomScenes) {
  ASSERT_TRUE(kSeeded);
  const rc::detail::TestMetadata metadata{GetParam(), "claims hold of any scene"};
  const auto result = rc::detail::checkTestable(
      [] {
        const auto scene = *rc::gen::arbitrary<RandomScene>();
        const Outcome outcome = outcome_of(scene, {{"method", GetParam()}}, kSteps);
        RC_CLASSIFY(!outcome.refused.empty(), "the engine refuses to go on");
        RC_CLASSIFY(outcome.contacts > 0, "bodies touch");
        if (!outcome.broken.empty()) RC_FAIL(outcome.broken);
      },
      metadata);
  std::ostringstream words;
  rc::detail::printResultMessage(result, words);
  if (result.template is<rc::detail::SuccessResult>()) {
    std::cout << words.str() << "\n";
  } else {
    ADD_FAILURE() << words.str();
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Properties, testing::Values("old", "paper", "quiet"),
                         [](const auto& one) { return one.param; });

// Found by a search of the claim that friction between bodies takes energy, whatever the method: a
// box that lands on a slab, flush. One sweep over contacts that stick and share vertices ends none
// of their slips, and the sum of f · u may then be above 0. Conjugate directions do end them.
TEST(KeptScenes, FrictionOfOneSweepMayGiveEnergyBetweenBodies) {
  const RandomScene scene{.ground = 2, .mu = 2, .bodies = {{.velocity = {0, 1, 3}}}};
  const Outcome paper = outcome_of(scene, {{"method", "paper"}}, 300);
  EXPECT_EQ(paper.broken, "");
  EXPECT_GT(paper.friction_work, 1e-5);
  const Outcome conjugate =
      outcome_of(scene, {{"method", "paper"}, {"rule", "conjugate-vector"}}, 300);
  EXPECT_EQ(conjugate.broken, "");
  EXPECT_LT(conjugate.friction_work, 0.0);
}

// Found by searches of the claim that friction at a half-space never gives energy: a point that is
// stopped from 0.3 and 0.5 m/s and then held on a slope of 1°. The force that holds it is the one
// that stopped it, corrected, and has that one's rounding, for some steps.
TEST(KeptScenes, AForceThatIsCorrectedHasTheRoundingOfTheOneBefore) {
  RandomScene scene{.ground = 1, .slope = 1, .gravity = 1, .mu_decade = 1, .mu = 1};
  scene.bodies = {{.shape = 3, .velocity = {5, 0, 1}}};
  EXPECT_EQ(outcome_of(scene, {{"method", "paper"}}, 200).broken, "");
  scene = {.ground = 1, .slope = 1, .gravity = 1, .mu = 2};
  scene.bodies = {{.shape = 3, .gap = 3, .velocity = {9, 0, 3}}};
  EXPECT_EQ(outcome_of(scene, {{"method", "paper"}}, 200).broken, "");
}

// Found by CI's seed of a commit, of the claim that momentum is exact: a point of 10 g that is stopped on
// a half-space of μ = 100. Its friction of 121 N is remembered, put on again, and corrected to 3e-15 N: the
// 7e-20 kg m/s that are missing then are 1e-17 of the 7e-3 that were put on and taken off.
TEST(KeptScenes, AForceThatIsCorrectedLeavesItsRoundingInMomentumToo) {
  RandomScene scene{.ground = 1, .slope = 17, .mu_decade = 3, .mu = 1, .drag = 3};
  scene.bodies = {{.shape = 3, .mass = 4, .aside = {1, 0}, .gap = 2, .velocity = {3, 9, 5}}};
  EXPECT_EQ(outcome_of(scene, {{"method", "quiet"}}, 200).broken, "");
}

// Found by a search of the claim that friction between bodies takes energy, of `quiet`: a box that
// lies on an edge rocks on a slab. All contacts stick, a step's sweeps end at the slip tolerance of
// 1e-7 gΔt, and what they leave is along the friction for as long as the box leans to one side.
TEST(KeptScenes, ContactsThatStickMayGiveWhatTheSlipToleranceLeaves) {
  const RandomScene scene{
      .ground = 2, .gravity = 1, .mu = 1, .bodies = {{.angle = 1, .velocity = {0, 1, 4}}}};
  const Outcome quiet = outcome_of(scene, {{"method", "quiet"}}, 200);
  EXPECT_EQ(quiet.broken, "");
  EXPECT_GT(quiet.friction_work, 1e-14);
  const Settings tighter = {{"method", "quiet"}, {"slip-tolerance", "1e-12"}};
  EXPECT_LT(outcome_of(scene, tighter, 200).friction_work, 1e-16);
}

// And a box that strikes the slab flush, turning, a corner upon a vertex: the two are each in the
// other's tetrahedra, at weights that differ by 1e-4, so that two contacts ask nearly the same and
// fight for the rest. After 16 sweeps, of which the last eight took away less than a tenth, the box
// has a slip of 1 mm/s left of 0.5 m/s, along its friction. After hundreds that contact slides.
TEST(KeptScenes, ContactsThatStickMayGiveWhatSweepsLeaveOfAnImpact) {
  const RandomScene scene{
      .ground = 2,
      .mu = 5,
      .bodies = {
          {.mass = 2, .aside = {0, 3}, .axis = 2, .angle = 4, .velocity = {0, 5, 3}, .spin = 6}}};
  const Outcome quiet = outcome_of(scene, {{"method", "quiet"}}, 1);
  EXPECT_EQ(quiet.broken, "");
  EXPECT_GT(quiet.friction_work, 6e-6);
  EXPECT_LT(quiet.friction_work, 7e-6) << "of 10 mJ";
}

// Found by CI, of `paper`: a corner whose force by the scalar ξ falls to 6 N and in four steps grows
// to 1e5 N, back and forth, where a stored vector rests. With μ = 3000 no cone bounds what follows:
// energies double their digits each step, and were infinite in one that the engine took for good.
TEST(KeptScenes, AScalarThatDivergesIsRefused) {
  RandomScene scene{.ground = 2, .gravity = 1, .mu_decade = 5, .mu = 3, .damping = 3, .drag = 6};
  scene.load = {0, 2, 2};
  scene.bodies = {{.size = 1, .aside = {1, 7}, .angle = 17, .velocity = {0, 2, 9}, .spin = 5},
                  {.size = 2,
                   .mass = 1,
                   .aside = {4, 1},
                   .gap = 1,
                   .axis = 1,
                   .angle = 3,
                   .velocity = {4, 1, 7},
                   .spin = 4}};
  const Outcome paper = outcome_of(scene, {{"method", "paper"}}, 200);
  EXPECT_EQ(paper.broken, "");
  EXPECT_THAT(paper.refused, testing::HasSubstr("the simulation diverged"));
  const Settings vector = {{"method", "paper"}, {"rule", "stored-vector"}};
  EXPECT_EQ(outcome_of(scene, vector, 200).refused, "");
}

}  // namespace
}  // namespace stiction::test
