// SPDX-License-Identifier: GPL-3.0-or-later
// slab/rest and slab/effort: what the paper's method leaves moving of a box that shall rest on a deformable slab.
// Each half of it was measured alone: `--set method=paper --set rule=stored-vector` (its contacts,
// another friction) and `--set method=quiet --set rule=fixed-point` (its friction, other contacts).
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kEither{
    "kEither",
    "neither half of the method rests alone. On quiet contacts, which don't come and go, ξ leaves "
    "3.5e-6 m/s (rest/one), 4.1e-5 (fixed), 5.5e-5 (random) and brings 0, 1 of 12 and 0 of 20 to "
    "rest: a scalar acts along the slip only, and the root of (15) that GSL finds on a frozen step "
    "leaves 1.5e-4 m/s across it, two unknowns a contact 5e-12 (compare, frozen/slab). A stored "
    "vector on the paper's contacts, which come and go, leaves "
    "2.6e-5, 3.6e-3 and 1.4e-5 m/s",
    kBothHalves};
constexpr Cause kNormals{
    "kNormals",
    "mostly the paper's contacts, of which some come or go in 2228 of 2500 steps (slab/kappa): "
    "with "
    "a stored vector they leave 1.2e-7 J (rest/one), 1.5e-7 (fixed), 5.7e-9 (random), ξ on quiet "
    "contacts leaves 1.7e-12, 1.5e-10 and 3.0e-10: no rest either, but a thousandth",
    kContactsGo};
constexpr Cause kDrift{"kDrift",
                       "either half of the method drifts alone: a stored vector on the paper's "
                       "contacts 1.9e-6 m, ξ on "
                       "quiet contacts 8.9e-7 m. The method before the paper drifts 9.2e-8 m",
                       kBothHalves};

}  // namespace

// clang-format off
Expectations expectations_slab_rest() {
  return {
      {"slab/rest/one", "method=paper", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/one", "method=paper", "fastest contact slip", {2e-05, 0.00067}, kRefuted, kEither, kFreeFall},
      {"slab/rest/one", "method=paper", "mean contact slip", {7.1e-06, 0.0002}, kRefuted, kEither, kFactorThree},
      {"slab/rest/one", "method=paper", "kinetic energy", {2.8e-08, 4.6e-07}, kRefuted, kNormals, kFactorThree},
      {"slab/rest/one", "method=paper rule=secant", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/one", "method=paper rule=secant", "fastest contact slip", {1.3e-05, 0.0029}, kRefuted, kEither, kNoise},
      {"slab/rest/one", "method=paper rule=secant", "mean contact slip", {6.7e-06, 0.00051}, kRefuted, kEither, kNoise},
      {"slab/rest/one", "method=paper rule=secant", "kinetic energy", {6.1e-08, 5.6e-07}, kRefuted, kNormals, kOneRun},
      {"slab/rest/fixed", "method=paper", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/fixed", "method=paper", "fastest contact slip", {3.4e-05, 0.0039}, kRefuted, kEither, kTwoFalls},
      {"slab/rest/fixed", "method=paper", "mean contact slip", {1.4e-05, 0.00099}, kRefuted, kEither, kFactorThree},
      {"slab/rest/fixed", "method=paper", "kinetic energy", {1e-09, 4.9e-07}, kRefuted, kNormals, kNoise},
      {"slab/rest/fixed", "method=paper rule=secant", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/fixed", "method=paper rule=secant", "fastest contact slip", {0.00014, 0.0039}, kRefuted, kEither, kTwoFalls},
      {"slab/rest/fixed", "method=paper rule=secant", "mean contact slip", {8.1e-05, 0.0013}, kRefuted, kEither, kFactorThree},
      {"slab/rest/fixed", "method=paper rule=secant", "kinetic energy", {7.5e-09, 8.5e-07}, kRefuted, kNormals, kFactorThree},
      {"slab/rest/random", "method=paper", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/random", "method=paper", "fastest contact slip", {1.5e-05, 0.00072}, kRefuted, kEither, kNoise},
      {"slab/rest/random", "method=paper", "mean contact slip", {5e-06, 6.1e-05}, kRefuted, kEither, kFactorThree},
      {"slab/rest/random", "method=paper", "kinetic energy", {4.5e-08, 7.7e-07}, kRefuted, kNormals, kFactorThree},
      {"slab/rest/random", "method=paper rule=secant", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/random", "method=paper rule=secant", "fastest contact slip", {0.00016, 0.0018}, kRefuted, kEither, kFactorThree},
      {"slab/rest/random", "method=paper rule=secant", "mean contact slip", {2.3e-05, 0.00024}, kRefuted, kEither, kFactorThree},
      {"slab/rest/random", "method=paper rule=secant", "kinetic energy", {1e-08, 1.8e-07}, kRefuted, kNormals, kFactorThree},
      {"slab/rest/random-fine", "method=paper", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/random-fine", "method=paper", "fastest contact slip", {0.0002, 0.0019}, kRefuted, kEither, kOneRun},
      {"slab/rest/random-fine", "method=paper", "mean contact slip", {2.9e-05, 0.00027}, kRefuted, kEither, kOneRun},
      {"slab/rest/random-fine", "method=paper", "kinetic energy", {7.2e-09, 6.6e-08}, kRefuted, kNormals, kOneRun},
      {"slab/rest/random-fine", "method=paper rule=secant", "share of configurations at rest", {0, 0}, kRefuted, kEither, kCount},
      {"slab/rest/random-fine", "method=paper rule=secant", "fastest contact slip", {0.0014, 0.013}, kRefuted, kEither, kOneRun},
      {"slab/rest/random-fine", "method=paper rule=secant", "mean contact slip", {6.1e-05, 0.00055}, kRefuted, kEither, kOneRun},
      {"slab/rest/random-fine", "method=paper rule=secant", "kinetic energy", {2.1e-08, 2e-07}, kRefuted, kNormals, kOneRun},
      {"slab/rest/drift", "method=paper", "drift over 10 s", {4.7e-07, 4.3e-05}, kRefuted, kDrift, kNoise},
      {"slab/rest/drift", "method=paper", "creep", {-2.1e-06, 1.6e-06}, kRefuted, kDrift, kFactorThree},
      {"slab/rest/drift", "method=paper rule=secant", "drift over 10 s", {2.3e-06, 0.00016}, kRefuted, kDrift, kFactorThree},
      {"slab/rest/drift", "method=paper rule=secant", "creep", {-1.4e-05, -2.2e-07}, kRefuted, kDrift, kFactorThree},
      {"slab/effort", "method=paper", "drift over 10 s", {2.3e-06, 2.1e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "method=paper", "creep", {-7.1e-07, 6.4e-07}, kRefuted, kDrift, kNoise},
      {"slab/effort", "dt=0.0001 method=paper", "drift over 10 s", {5.2e-06, 4.8e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.0001 method=paper", "creep", {-7e-07, -7.7e-08}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "method=paper rule=secant", "drift over 10 s", {2.4e-06, 2.3e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "method=paper rule=secant", "creep", {-2.3e-06, -2.4e-07}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.00005 method=paper", "drift over 10 s", {7.3e-06, 6.7e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.00005 method=paper", "creep", {-8.5e-07, -9.3e-08}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.0001 method=paper rule=secant", "drift over 10 s", {5.3e-06, 4.9e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.0001 method=paper rule=secant", "creep", {-6.9e-07, -7.5e-08}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.00005 method=paper rule=secant", "drift over 10 s", {7.3e-06, 6.7e-05}, kRefuted, kDrift, kOneRun},
      {"slab/effort", "dt=0.00005 method=paper rule=secant", "creep", {-8.5e-07, -9.3e-08}, kRefuted, kDrift, kOneRun},
  };
}
// clang-format on

}  // namespace stiction
