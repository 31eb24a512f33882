// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/engine.h"

namespace stiction {

/// A word of `can` and what it stands for.
struct ManifestWord {
  const char* word;
  bool Manifest::*has;
};

inline constexpr ManifestWord kManifestWords[] = {{"points", &Manifest::point_masses},
                                                  {"boxes", &Manifest::boxes},
                                                  {"balls", &Manifest::balls},
                                                  {"meshes", &Manifest::meshes},
                                                  {"convex_meshes", &Manifest::convex_meshes},
                                                  {"deformable", &Manifest::deformable},
                                                  {"held_parts", &Manifest::held_parts},
                                                  {"body_contact", &Manifest::body_contact},
                                                  {"self_contact", &Manifest::self_contact},
                                                  {"moving_obstacles", &Manifest::moving_obstacles},
                                                  {"steady_motion", &Manifest::steady_motion},
                                                  {"oscillation", &Manifest::oscillation},
                                                  {"pair_friction", &Manifest::pair_friction},
                                                  {"restitution", &Manifest::restitution},
                                                  {"drag", &Manifest::drag},
                                                  {"varying_gravity", &Manifest::varying_gravity},
                                                  {"loads", &Manifest::loads},
                                                  {"spin", &Manifest::spin},
                                                  {"contacts", &Manifest::contacts},
                                                  {"snapshots", &Manifest::snapshots}};

}  // namespace stiction
