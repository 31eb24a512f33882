// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/contact_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace stiction {
namespace {

using Chunk = ContactOrder::Chunk;

constexpr std::size_t kSome = ContactOrder::kMany - 1, kMany = 3 * ContactOrder::kMany;

// A strip of a body's vertices over a strip of another's: each touches its neighbours' partners too.
PairContacts strip(std::size_t count) {
  PairContacts pairs(count);
  for (std::size_t c = 0; c < count; ++c) {
    const auto v = static_cast<std::int32_t>(c);
    pairs[c].vertex = v;
    for (int k = 0; k < 4; ++k) pairs[c].partner[k] = static_cast<std::int32_t>(count) + v + k;
  }
  return pairs;
}

std::size_t vertices_of(std::size_t count) { return 2 * count + 4; }

// The vertices that chunks of the same colour share, and the contacts in the order that they come in.
struct Seen {
  std::vector<std::size_t> contacts;
  std::size_t shared = 0;

  Seen(const ContactOrder& order, const PairContacts& pairs) {
    std::vector<std::pair<std::size_t, Chunk>> chunks;
    order.for_each_chunk(nullptr, [&](std::size_t k, const Chunk& chunk) {
      EXPECT_EQ(k, chunks.size());
      chunks.emplace_back(k, chunk);
      for (std::size_t c = chunk.begin; c < chunk.end; ++c) contacts.push_back(c);
    });
    for (std::size_t colour = 0; colour < order.colours(); ++colour) {
      std::map<std::int32_t, std::size_t> owner;
      for (std::size_t k = order.first_chunk(colour); k < order.first_chunk(colour + 1); ++k) {
        for (std::size_t c = chunks[k].second.begin; c < chunks[k].second.end; ++c) {
          std::set<std::int32_t> corners(pairs[c].partner, pairs[c].partner + 4);
          corners.insert(pairs[c].vertex);
          for (const std::int32_t v : corners) {
            shared += owner.emplace(v, k).first->second != k;
          }
        }
      }
    }
  }
};

TEST(ContactOrder, OfFewIsThatOfTheirKeys) {
  const PairContacts pairs = strip(kSome);
  ContactOrder order;
  order.make(pairs, vertices_of(kSome));
  EXPECT_EQ(order.chunks(), 1u);
  const Seen seen(order, pairs);
  EXPECT_TRUE(std::is_sorted(seen.contacts.begin(), seen.contacts.end()));
  EXPECT_EQ(seen.contacts.size(), kSome);
}

TEST(ContactOrder, OfManyHasEachOnceAndNoVertexTwiceInAColour) {
  const PairContacts pairs = strip(kMany);
  ContactOrder order;
  order.make(pairs, vertices_of(kMany));
  EXPECT_EQ(order.colours(), 2u);  // of a strip, every other chunk
  Seen seen(order, pairs);
  EXPECT_EQ(seen.shared, 0u);
  EXPECT_FALSE(std::is_sorted(seen.contacts.begin(), seen.contacts.end()));
  std::sort(seen.contacts.begin(), seen.contacts.end());
  ASSERT_EQ(seen.contacts.size(), kMany);
  for (std::size_t c = 0; c < kMany; ++c) EXPECT_EQ(seen.contacts[c], c);
}

TEST(ContactOrder, FollowsFromTheContactsAloneWhateverItWasBefore) {
  PairContacts pairs = strip(kMany);
  ContactOrder order;
  order.make(pairs, vertices_of(kMany));
  // The last contact reaches back to the first: their chunks must part.
  pairs.back().partner[3] = pairs.front().vertex;
  order.make(pairs, vertices_of(kMany));
  ContactOrder fresh;
  fresh.make(pairs, vertices_of(kMany));
  const Seen seen(order, pairs), wanted(fresh, pairs);
  EXPECT_EQ(seen.contacts, wanted.contacts);
  EXPECT_EQ(seen.shared, 0u);
  order.make(strip(kSome), vertices_of(kMany));
  EXPECT_EQ(order.chunks(), 1u);
}

TEST(ContactOrder, HandsOutEachContactOnceSinceItsLastRestartAndSaysIfItLasts) {
  PairContacts pairs = strip(kMany);
  ContactOrder order;
  std::vector<int> handed;
  int restarts = 0;
  const auto make = [&] {
    restarts = 0;
    order.make(
        pairs, vertices_of(kMany), nullptr,
        [&] {
          ++restarts;
          handed.assign(kMany, 0);
        },
        [&](const Chunk& chunk) {
          for (std::size_t c = chunk.begin; c < chunk.end; ++c) ++handed[c];
        });
    EXPECT_EQ(handed, std::vector<int>(kMany, 1));
    EXPECT_TRUE(order.is_of(pairs));
  };
  make();
  EXPECT_EQ(restarts, 1);
  make();
  EXPECT_EQ(restarts, 1) << "it lasts";
  pairs[kMany / 2].other = 7;
  EXPECT_FALSE(order.is_of(pairs)) << "another key";
  make();
  EXPECT_EQ(restarts, 2);
  EXPECT_EQ(order.keys()[kMany / 2], pairs[kMany / 2].key());
  std::swap(pairs.back().partner[0], pairs.back().partner[1]);
  EXPECT_FALSE(order.is_of(pairs)) << "other vertices";
  make();
  EXPECT_EQ(restarts, 2);
}

// The contacts of the places, and how near to each other two stand that share a vertex.
struct Placed {
  std::vector<std::size_t> contacts;
  std::size_t nearest = std::numeric_limits<std::size_t>::max();
  bool in_order = true;  // those of each vertex

  Placed(const ContactOrder& order, const PairContacts& pairs) {
    const ContactOrder::Sequence sequence = order.sequence();
    std::map<std::int32_t, std::pair<std::size_t, std::size_t>>
        last;  // place and contact at a vertex
    for (std::size_t place = 0; place < pairs.size(); ++place) {
      const std::size_t c = sequence.contact(place);
      contacts.push_back(c);
      std::set<std::int32_t> corners(pairs[c].partner, pairs[c].partner + 4);
      corners.insert(pairs[c].vertex);
      for (const std::int32_t v : corners) {
        const auto [at, is_first] = last.emplace(v, std::pair(place, c));
        if (is_first) continue;
        nearest = std::min(nearest, place - at->second.first);
        in_order = in_order && at->second.second < c;
        at->second = {place, c};
      }
    }
  }
};

// Contacts side by side, `across` of them between those that share a vertex.
PairContacts woven(std::size_t count, std::size_t across) {
  PairContacts pairs(count);
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t strand = c * across / count, first = strand * (count + 4);
    pairs[c].vertex = static_cast<std::int32_t>(first + c);
    for (std::size_t k = 0; k < 4; ++k) {
      pairs[c].partner[k] = static_cast<std::int32_t>(across * (count + 4) + first + c + k);
    }
  }
  return pairs;
}

TEST(ContactOrder, PutsContactsApartThatShareAVertexOnceTheyHaveLasted) {
  constexpr std::size_t kCount = 240, kAcross = 6, kVertices = 2 * kAcross * (kCount + 4);
  const PairContacts pairs = woven(kCount, kAcross);
  ContactOrder order;
  order.make(pairs, kVertices);
  const Placed at_first(order, pairs);
  EXPECT_TRUE(std::is_sorted(at_first.contacts.begin(), at_first.contacts.end()));
  EXPECT_EQ(at_first.nearest, 1u);
  order.make(pairs, kVertices);
  Placed placed(order, pairs);
  EXPECT_EQ(placed.nearest, kAcross);
  EXPECT_TRUE(placed.in_order);
  std::sort(placed.contacts.begin(), placed.contacts.end());
  EXPECT_EQ(placed.contacts, at_first.contacts);
  // Another contact, and all begins anew.
  PairContacts others = pairs;
  others.back().partner[2] = 0;
  order.make(others, kVertices);
  EXPECT_EQ(Placed(order, others).contacts, at_first.contacts);
}

TEST(ContactOrder, OfEdgesPutsThoseApartThatShareAVertexInOneChunk) {
  constexpr std::size_t kStrands = 5, kEach = 40;
  for (const std::size_t each : {kEach, ContactOrder::kMany}) {  // where pairs have colours too
    const auto strand = static_cast<std::int32_t>(each + 5);     // its vertices
    EdgeContacts edges(kStrands * each);
    for (std::size_t c = 0; c < edges.size(); ++c) {
      const auto first =
          static_cast<std::int32_t>(c / each) * strand + static_cast<std::int32_t>(c % each);
      for (int k = 0; k < 2; ++k) edges[c].vertex[k] = first + k;
      for (int k = 0; k < 4; ++k) edges[c].partner[k] = first + 2 + k;
    }
    const std::size_t vertices = kStrands * static_cast<std::size_t>(strand);
    ContactOrder order;
    order.make(edges, vertices);
    EXPECT_TRUE(order.is_of(edges));
    for (std::size_t c = 0; c < edges.size(); ++c) ASSERT_EQ(order.sequence().contact(c), c);
    order.make(edges, vertices);
    EXPECT_EQ(order.chunks(), 1u);
    // Each once, and those of a strand, which share vertices, in their order.
    std::vector<std::size_t> last(kStrands, 0), seen(kStrands, 0);
    std::size_t beside = 0;
    for (std::size_t place = 0; place < edges.size(); ++place) {
      const std::size_t c = order.sequence().contact(place), of = c / each;
      if (seen[of]++ > 0) {
        ASSERT_EQ(c, last[of] + 1);
      }
      last[of] = c;
      beside += place > 0 && order.sequence().contact(place - 1) / each == of;
    }
    for (const std::size_t count : seen) EXPECT_EQ(count, each);
    if (each == kEach) {
      EXPECT_LT(beside, edges.size() / 4);
    }
    edges.back().vertex[1] = 0;
    EXPECT_FALSE(order.is_of(edges));
    order.make(edges, vertices);
    for (std::size_t c = 0; c < edges.size(); ++c) ASSERT_EQ(order.sequence().contact(c), c);
  }
}

TEST(ContactOrder, KeepsTheOrderAtEachVertexAndTheChunksOfEachColour) {
  for (const std::size_t count : {kMany, 2 * kMany}) {  // small windows and large ones
    const PairContacts pairs = woven(count, 3);
    const std::size_t vertices = 6 * (count + 4);
    ContactOrder order;
    order.make(pairs, vertices);
    const std::vector<std::size_t> chunks = Seen(order, pairs).contacts;
    order.make(pairs, vertices);
    EXPECT_EQ(Seen(order, pairs).contacts, chunks);
    Placed placed(order, pairs);
    EXPECT_TRUE(placed.in_order);
    std::sort(placed.contacts.begin(), placed.contacts.end());
    for (std::size_t c = 0; c < count; ++c) ASSERT_EQ(placed.contacts[c], c);
  }
}

TEST(ContactOrder, WhereAllTouchOneVertexChunksComeOneByOne) {
  constexpr std::size_t kVeryMany = 20 * ContactOrder::kMany;  // more chunks than colours
  PairContacts pairs = strip(kVeryMany);
  for (PairContact& contact : pairs) contact.partner[0] = 0;
  ContactOrder order;
  order.make(pairs, vertices_of(kVeryMany));
  EXPECT_EQ(order.colours(), order.chunks());
  EXPECT_GT(order.chunks(), 64u);
  const Seen seen(order, pairs);
  EXPECT_EQ(seen.shared, 0u);
  EXPECT_EQ(seen.contacts.size(), kVeryMany);
}

TEST(ContactOrder, OfObstaclesHasAColourForEach) {
  OneSidedContacts contacts;
  for (std::int32_t obstacle = 0; obstacle < 3; ++obstacle) {
    const auto count = static_cast<std::int32_t>(obstacle == 1 ? 3 : ContactOrder::kMany);
    for (std::int32_t v = 0; v < count; ++v) {
      contacts.add(contact_key(obstacle, v), v, obstacle, 0.0);
    }
  }
  ContactOrder order;
  order.make(contacts);
  ASSERT_EQ(order.colours(), 3u);
  std::size_t next = 0;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    EXPECT_EQ(order.first_chunk(colour + 1) - order.first_chunk(colour), colour == 1 ? 1u : 8u);
  }
  order.for_each_chunk(nullptr, [&](std::size_t, const Chunk& chunk) {
    EXPECT_EQ(chunk.begin, next);
    EXPECT_EQ(contacts.obstacle[chunk.begin], contacts.obstacle[chunk.end - 1]);
    next = chunk.end;
  });
  EXPECT_EQ(next, contacts.size());
}

}  // namespace
}  // namespace stiction
