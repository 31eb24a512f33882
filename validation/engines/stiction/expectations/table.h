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
inline constexpr const char* kScalarLeaves = "one scalar ξ a contact leaves slip across ũ";
inline constexpr const char* kBothHalves =
    "its contacts come and go, and its scalar ξ leaves slip across ũ";
inline constexpr const char* kContactsGo = "its contacts come and go, so that they never settle";
inline constexpr const char* kNoCorrection = "without post-correction each contact injects energy";
inline constexpr const char* kNoLearning = "with ξ = 1 a contact learns nothing of its neighbours";
inline constexpr const char* kVerticesAlone =
    "contacts of vertices alone miss what crossing edges carry";
inline constexpr const char* kNotSufficient =
    "the bound is necessary, not sufficient: sliding is not associated";
inline constexpr const char* kFacetsRoll = "a ball is a polyhedron, and goes from edge to edge";
inline constexpr const char* kUnboundedGain = "the paper's normal gain has no bound";
inline constexpr const char* kTwiceSaid = "two contacts that say the same pass the slip to and fro";
inline constexpr const char* kSwing = "only strain damps what swings without slip";
inline constexpr const char* kStale = "a force kept from a lost contact counts again";

inline constexpr Words kFactorThree{
    "kFactorThree",
    "a factor of three about what was measured at the case's time step, 0.9 and 0.95 of it, for "
    "what "
    "is left are limit cycles, of which a run's last step is one sample"};
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
