// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "validation/engines/stiction/stiction_expectations.h"

/// What the tables of this folder share. A file <name>.cpp returns its rows from a function
/// `expectations_<name>()`; the build finds it. A row is
///   {case or glob, variant, quantity, {low, high}, kShortfall or kRefuted, cause, width}
/// and `validate --show-expectations RUN/records.jsonl` writes rows like that.
///
/// Two significant digits a band, rounded outwards. The runs were made on two processors with
/// g++ 12; the same build gives the same digits anywhere, so that a width is for changes of the
/// solver, not for noise.
namespace stiction {

using enum Verdict;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Why, in so few words that a summary groups by them: what causes come down to.
inline constexpr const char* kScalarLeaves = "a scalar ξ leaves slip across ũ";
inline constexpr const char* kBothHalves = "contacts come and go, a scalar ξ leaves slip";
inline constexpr const char* kContactsGo = "contacts come and go";
inline constexpr const char* kNoCorrection = "no post-correction: contacts inject energy";
inline constexpr const char* kNoLearning = "ξ = 1: contacts learn nothing of each other";
inline constexpr const char* kVerticesAlone = "vertices alone miss what crossing edges do";
inline constexpr const char* kNotSufficient = "limit analysis bounds, it does not suffice";
inline constexpr const char* kFacetsRoll = "balls are polyhedra, and go edge to edge";
inline constexpr const char* kUnboundedGain = "the paper's normal gain has no bound";
inline constexpr const char* kTwiceSaid = "two contacts that say the same pass slip on";
inline constexpr const char* kFreeTurn = "contacts at one point leave a couple";
inline constexpr const char* kOutlastsShort = "elastic vibration outlasts the friction iteration";
inline constexpr const char* kSwept = "the order of sweeps";
inline constexpr const char* kRounds = "single precision rounds so";
inline constexpr const char* kRefused = "refused in words";
inline constexpr const char* kStale = "a lost contact's force counts again";

inline constexpr Words kFactorThree{
    "kFactorThree",
    "a factor of three about what was measured at the case's time step, 0.9 and 0.95 of it, for "
    "what "
    "is left are limit cycles, of which a run's last step is one sample"};
inline constexpr Words kNoise{
    "kNoise",
    "a factor of three about what was measured of the scene as it is and with each of its numbers "
    "a unit in the last place off (--perturb ulp/1 to ulp/5): what is left are limit cycles, of "
    "which a run's last step is one sample"};
inline constexpr Words kFactorTwo{
    "kFactorTwo",
    "a factor of two about what was measured at the case's time step and 0.9 of it: a loss that is "
    "the same within a fifth, not a sample of something that jumps"};
inline constexpr Words kFreeFall{
    "kFreeFall",
    "from a third of the least measured at the case's time step, 0.9 and 0.95 of it, up to "
    "g Δt sin θ, what a step without friction gives"};
inline constexpr Words kTwoFalls{
    "kTwoFalls",
    "from a third of the least measured at the case's time step, 0.9 and 0.95 of it, up to 2 g Δt, "
    "two steps of free fall; the largest measured takes 98 % of it"};
inline constexpr Words kOneRun{"kOneRun",
                               "a factor of three about one run at the case's time step"};
inline constexpr Words kLeaves{
    "kLeaves",
    "beyond half a box's width, where the run ends as broken, up to all of it: no box goes farther "
    "between two samples"};
inline constexpr Words kCount{"kCount", "a count, the same in every run made"};

}  // namespace stiction
