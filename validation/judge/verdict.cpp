// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/verdict.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "solver/demand.h"

namespace stiction {

Judgement for_information(Claim claim, double value) {
  const std::optional<double> scale = scale_of(claim);
  demand(!scale || *scale != 0.0, "a check's scale is not zero");
  demand(scale || !claim.relative, "a relative error has a scale");
  const double difference = value - claim.expected;
  Judgement found;
  found.value = value;
  found.error = claim.relative ? difference / *scale : difference;
  found.of_tolerance = share_of_tolerance(found.error, claim.tolerance);
  if (scale) found.digits = correct_digits(difference, *scale);
  found.verdict = Verdict::kForInformation;
  found.claim = std::move(claim);
  return found;
}

Judgement judge(Claim claim, double value, double tolerance_scale,
                const std::optional<KnownShortfall>& known) {
  Judgement found = for_information(std::move(claim), value);
  const bool holds = std::abs(found.error) <= found.claim.tolerance * tolerance_scale;
  found.verdict = holds ? Verdict::kPass : Verdict::kFail;
  if (!known) return found;
  demand(known->verdict == Verdict::kShortfall || known->verdict == Verdict::kRefuted,
         "a band has a verdict");
  found.band = known->band;
  found.cause = known->cause;
  found.because = known->because;
  const bool inside = value >= known->band.low && value <= known->band.high;
  found.verdict = inside && !holds ? known->verdict : Verdict::kFail;
  return found;
}

std::string scale_sentence(double tolerance_scale) {
  return fmt::format("verdicts multiply each tolerance by {:g} (--tolerance-scale)",
                     tolerance_scale);
}

std::string finer_sentence(int finer) {
  return fmt::format("time steps are 1/{} of the usual ones (--finer)", finer);
}

}  // namespace stiction
