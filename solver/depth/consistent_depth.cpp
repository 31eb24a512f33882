// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/consistent_depth.h"

#include <cstddef>
#include <cstdint>

#include "solver/depth/border_average.h"
#include "solver/depth/edge_exit.h"
#include "solver/depth/find_outlets.h"
#include "solver/detection/lasting.h"
#include "solver/lanes/lane_width.h"

namespace stiction {

namespace {

std::uint32_t body_of(const PairContact& contact) {
  return static_cast<std::uint32_t>(contact.other);
}

// One pass over the contacts of a step. Levels: 0 not reached, 1 border, 2 … propagated; −1 for
// those of the level in work.
class Pass {
 public:
  Pass(const Scene& scene, const PairOptions& options, Workspace& workspace)
      : scene_(scene),
        search_(workspace.search),
        x_(workspace.search.predicted),
        pairs_(workspace.pairs),
        scratch_(workspace.consistent),
        width_(lane_width()),
        is_in_its_element_(options.tie_margin == 0.0) {}

  void run() {
    begin();
    for (std::size_t c = 0; c < pairs_.size(); ++c) {
      if (!pairs_.site(c).open && set_border(c)) reach(c, 1);
    }
    for (int level = 1; advance(level); ++level) {
    }
    for (const PairContact& contact : pairs_) first_contact(contact.vertex) = -1;
  }

 private:
  void begin() {
    if (scratch_.links.scene != scene_.serial) {
      build_links(scene_, scratch_.links);
      scratch_.first_contact.assign(scene_.mass.size(), -1);
    }
    search_.outlets.resize(scene_.mass.size());
    scratch_.walk.begin(scene_.elements.size(), scene_.topology.triangle.size());
    scratch_.level.assign(pairs_.size(), 0);
    scratch_.front.clear();
    for (std::size_t c = pairs_.size(); c-- > 0;) {
      first_contact(pairs_[c].vertex) = static_cast<std::int32_t>(c);
    }
  }

  // All contacts reached in the front become known; those next to them are the next front.
  bool advance(int level) {
    scratch_.next.clear();
    for (const std::int32_t c : scratch_.front) {
      for_each_beside(pairs_[static_cast<std::size_t>(c)], [&](std::size_t other) {
        if (scratch_.level[other] != 0) return;
        scratch_.level[other] = -1;
        scratch_.next.push_back(static_cast<std::int32_t>(other));
      });
    }
    scratch_.front.clear();
    for (const std::int32_t c : scratch_.next) {
      const auto k = static_cast<std::size_t>(c);
      if (set_inner(pairs_[k], level)) {
        reach(k, level + 1);
      } else {
        scratch_.level[k] = 0;
      }
    }
    return !scratch_.front.empty();
  }

  void reach(std::size_t c, int level) {
    scratch_.level[c] = level;
    scratch_.front.push_back(static_cast<std::int32_t>(c));
  }

  bool set_border(std::size_t c) {
    PairContact& contact = pairs_[c];
    Border border{scene_,
                  scratch_.links,
                  x_,
                  contact.vertex,
                  pairs_.site(c).element,
                  kConsistentThin * scratch_.links.longest_edge[body_of(contact)]};
    if (!is_in_its_element_) border.element = element_at(border, scratch_.walk);
    Outlets& outlets = search_.outlets[static_cast<std::size_t>(contact.vertex)];
    const double path = paths(scene_.topology, search_, contact.key());
    const bool same = outlets.element == border.element;
    if (same && path < outlets.until) {
      return average_by_outlets(border, outlets, width_, scratch_.walk).write_to(contact);
    }
    const Average average = average_by_walks(border, scratch_.walk);
    outlets.element = border.element;
    note_lasting(same, path, outlets.steps, outlets.until, [&] {
      return find_outlets(border, static_cast<Real>(search_.stride), scratch_.walk, outlets);
    });
    return average.write_to(contact);
  }

  bool set_inner(PairContact& contact, int level) {
    const Vec3& p = x(contact.vertex);
    Average average;
    for_each_beside(contact, [&](std::size_t other) {
      const PairContact& from = pairs_[other];
      if (scratch_.level[other] < 1 || scratch_.level[other] > level) return;
      const Vec3 away = x(from.vertex) - p;
      average.add(1 / away.squaredNorm(), away.dot(from.normal) + from.depth, from.normal);
    });
    return average.write_to(contact);
  }

  // The contacts with the same body of the vertex's neighbours.
  template <class Use>
  void for_each_beside(const PairContact& contact, Use&& use) {
    for (const std::int32_t v : scratch_.links.neighbours_of(contact.vertex)) {
      const std::int32_t first = first_contact(v);
      if (first < 0) continue;
      for (auto c = static_cast<std::size_t>(first); c < pairs_.size() && pairs_[c].vertex == v;
           ++c) {
        if (body_of(pairs_[c]) == body_of(contact) && !pairs_.site(c).open) use(c);
      }
    }
  }

  const Vec3& x(std::int32_t v) const { return x_[static_cast<std::size_t>(v)]; }
  std::int32_t& first_contact(std::int32_t v) {
    return scratch_.first_contact[static_cast<std::size_t>(v)];
  }

  const Scene& scene_;
  PairSearch& search_;
  const std::vector<Vec3>& x_;
  PairContacts& pairs_;
  ConsistentScratch& scratch_;
  int width_;  // of registers, in doubles
  // With a margin of ties a vertex may be said to be in an element that it has left. A walk from there would come
  // to nothing where edges lead away from it.
  bool is_in_its_element_;
};

}  // namespace

void consistent_depths(const Scene& scene, const PairOptions& options, Workspace& workspace) {
  Pass(scene, options, workspace).run();
}

}  // namespace stiction
