// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/contact_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <type_traits>
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

// Of so many vertices, which follow each other along the curve.
std::vector<std::int32_t> in_a_row(std::size_t vertices) {
  std::vector<std::int32_t> places(vertices);
  std::iota(places.begin(), places.end(), 0);
  return places;
}

std::vector<std::int32_t> places_of(std::size_t count) { return in_a_row(2 * count + 4); }

template <class Contact>
std::set<std::int32_t> vertices_of(const Contact& contact) {
  std::set<std::int32_t> vertices(contact.partner, contact.partner + 4);
  if constexpr (std::is_same_v<Contact, PairContact>) {
    vertices.insert(contact.vertex);
  } else {
    vertices.insert(contact.vertex, contact.vertex + 2);
  }
  return vertices;
}

// The vertices that chunks of the same colour share, and the contacts in the order that they come in.
struct Seen {
  std::vector<std::size_t> contacts;
  std::size_t shared = 0;

  template <class Contacts>
  Seen(const ContactOrder& order, const Contacts& all) {
    std::vector<std::span<const std::int32_t>> chunks;
    order.for_each_chunk(nullptr, [&](std::size_t k, const Chunk& chunk) {
      EXPECT_EQ(k, chunks.size());
      chunks.push_back(order.in_turn(chunk));
      contacts.insert(contacts.end(), chunks.back().begin(), chunks.back().end());
    });
    for (std::size_t colour = 0; colour < order.colours(); ++colour) {
      std::map<std::int32_t, std::size_t> owner;
      for (std::size_t k = order.first_chunk(colour); k < order.first_chunk(colour + 1); ++k) {
        for (const std::int32_t c : chunks[k]) {
          for (const std::int32_t v : vertices_of(all[static_cast<std::size_t>(c)])) {
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
  order.make(pairs, places_of(kSome));
  EXPECT_EQ(order.chunks(), 1u);
  const Seen seen(order, pairs);
  EXPECT_TRUE(std::is_sorted(seen.contacts.begin(), seen.contacts.end()));
  EXPECT_EQ(seen.contacts.size(), kSome);
}

TEST(ContactOrder, OfManyHasEachOnceAndNoVertexTwiceInAColour) {
  const PairContacts pairs = strip(kMany);
  ContactOrder order;
  order.make(pairs, places_of(kMany));
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
  order.make(pairs, places_of(kMany));
  // The last contact reaches back to the first: their chunks must part.
  pairs.back().partner[3] = pairs.front().vertex;
  order.make(pairs, places_of(kMany));
  ContactOrder fresh;
  fresh.make(pairs, places_of(kMany));
  const Seen seen(order, pairs), wanted(fresh, pairs);
  EXPECT_EQ(seen.contacts, wanted.contacts);
  EXPECT_EQ(seen.shared, 0u);
  order.make(strip(kSome), places_of(kMany));
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
        pairs, places_of(kMany), nullptr,
        [&] {
          ++restarts;
          handed.assign(kMany, 0);
        },
        [&](const Chunk& chunk) {
          for (const std::int32_t c : order.in_turn(chunk)) ++handed[static_cast<std::size_t>(c)];
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
    std::vector<std::size_t> turn(pairs.size());
    for (const std::int32_t c : order.in_turn({0, pairs.size()})) {
      turn[static_cast<std::size_t>(c)] = next++;
    }
    std::map<std::int32_t, std::pair<std::size_t, std::size_t>> last;  // place and turn at a vertex
    for (std::size_t place = 0; place < pairs.size(); ++place) {
      const std::size_t c = sequence.contact(place);
      contacts.push_back(c);
      for (const std::int32_t v : vertices_of(pairs[c])) {
        const auto [at, is_first] = last.emplace(v, std::pair(place, turn[c]));
        if (is_first) continue;
        nearest = std::min(nearest, place - at->second.first);
        in_order = in_order && at->second.second < turn[c];
        at->second = {place, turn[c]};
      }
    }
  }

 private:
  std::size_t next = 0;
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
  const std::vector<std::int32_t> places = in_a_row(kVertices);
  const PairContacts pairs = woven(kCount, kAcross);
  ContactOrder order;
  order.make(pairs, places);
  const Placed at_first(order, pairs);
  EXPECT_TRUE(std::is_sorted(at_first.contacts.begin(), at_first.contacts.end()));
  EXPECT_EQ(at_first.nearest, 1u);
  order.make(pairs, places);
  Placed placed(order, pairs);
  EXPECT_EQ(placed.nearest, kAcross);
  EXPECT_TRUE(placed.in_order);
  std::sort(placed.contacts.begin(), placed.contacts.end());
  EXPECT_EQ(placed.contacts, at_first.contacts);
  // Another contact, and all begins anew.
  PairContacts others = pairs;
  others.back().partner[2] = 0;
  order.make(others, places);
  EXPECT_EQ(Placed(order, others).contacts, at_first.contacts);
}

// Strands of edges: each shares vertices with those before and behind it.
EdgeContacts strands(std::size_t count, std::size_t each) {
  const auto strand = static_cast<std::int32_t>(each + 5);  // its vertices
  EdgeContacts edges(count * each);
  for (std::size_t c = 0; c < edges.size(); ++c) {
    const auto first =
        static_cast<std::int32_t>(c / each) * strand + static_cast<std::int32_t>(c % each);
    for (int k = 0; k < 2; ++k) edges[c].vertex[k] = first + k;
    for (int k = 0; k < 4; ++k) edges[c].partner[k] = first + 2 + k;
  }
  return edges;
}

TEST(ContactOrder, OfFewEdgesPutsThoseApartThatShareAVertexInOneChunk) {
  constexpr std::size_t kStrands = 5, kEach = 40;
  EdgeContacts edges = strands(kStrands, kEach);
  const std::vector<std::int32_t> places = in_a_row(kStrands * (kEach + 5));
  ContactOrder order;
  order.make(edges, places);
  EXPECT_TRUE(order.is_of(edges));
  for (std::size_t c = 0; c < edges.size(); ++c) ASSERT_EQ(order.sequence().contact(c), c);
  order.make(edges, places);
  EXPECT_EQ(order.chunks(), 1u);
  // Each once, and those of a strand in their order.
  std::vector<std::size_t> last(kStrands, 0), seen(kStrands, 0);
  std::size_t beside = 0;
  for (std::size_t place = 0; place < edges.size(); ++place) {
    const std::size_t c = order.sequence().contact(place), of = c / kEach;
    if (seen[of]++ > 0) {
      ASSERT_EQ(c, last[of] + 1);
    }
    last[of] = c;
    beside += place > 0 && order.sequence().contact(place - 1) / kEach == of;
  }
  for (const std::size_t count : seen) EXPECT_EQ(count, kEach);
  EXPECT_LT(beside, edges.size() / 4);
  edges.back().vertex[1] = 0;
  EXPECT_FALSE(order.is_of(edges));
  order.make(edges, places);
  for (std::size_t c = 0; c < edges.size(); ++c) ASSERT_EQ(order.sequence().contact(c), c);
}

TEST(ContactOrder, OfManyEdgesHasEachOnceAndNoVertexTwiceInAColour) {
  const EdgeContacts edges = strands(5, kMany);
  const std::vector<std::int32_t> places = in_a_row(5 * (kMany + 5));
  ContactOrder order;
  for (int steps = 0; steps < 2; ++steps) {
    order.make(edges, places);
    EXPECT_GT(order.chunks(), 2 * order.colours());
    Seen seen(order, edges);
    EXPECT_EQ(seen.shared, 0u);
    std::sort(seen.contacts.begin(), seen.contacts.end());
    ASSERT_EQ(seen.contacts.size(), edges.size());
    for (std::size_t c = 0; c < edges.size(); ++c) ASSERT_EQ(seen.contacts[c], c);
  }
}

// Two bodies' vertices on each other, with keys far from each other, side by side along the curve.
TEST(ContactOrder, OfManyBringsThoseTogetherThatLieTogether) {
  const std::size_t half = kMany / 2;
  PairContacts pairs(2 * half);
  std::vector<std::int32_t> places(2 * (half + 4));
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const std::size_t body = c / half, at = c % half;
    pairs[c].vertex = static_cast<std::int32_t>(body * (half + 4) + at);
    for (std::size_t k = 0; k < 4; ++k) {
      pairs[c].partner[k] = static_cast<std::int32_t>((1 - body) * (half + 4) + at + k);
    }
  }
  for (std::size_t v = 0; v < places.size(); ++v) {
    const std::size_t body = v / (half + 4), at = v % (half + 4);
    places[v] = static_cast<std::int32_t>(2 * at + body);
  }
  ContactOrder order;
  order.make(pairs, places);
  std::size_t chunks = 0;
  order.for_each_chunk(nullptr, [&](std::size_t, const Chunk& chunk) {
    ++chunks;
    std::size_t of_first = 0, least = half, most = 0;
    for (const std::int32_t c : order.in_turn(chunk)) {
      const std::size_t at = static_cast<std::size_t>(c) % half;
      of_first += static_cast<std::size_t>(c) < half;
      least = std::min(least, at);
      most = std::max(most, at);
    }
    // A quarter of the chunk at either end may have no other beside it.
    const auto size = static_cast<double>(chunk.end - chunk.begin);
    EXPECT_NEAR(static_cast<double>(of_first), size / 2, size / 4);
    EXPECT_LE(static_cast<double>(most - least), 3 * size / 4);
  });
  EXPECT_GT(chunks, 30u);
  EXPECT_LE(order.colours(), 3u);
}

TEST(ContactOrder, KeepsTheOrderAtEachVertexAndTheChunksOfEachColour) {
  for (const std::size_t count : {kMany, std::size_t{20000}}) {  // large windows and small ones
    const PairContacts pairs = woven(count, 3);
    const std::vector<std::int32_t> places = in_a_row(6 * (count + 4));
    ContactOrder order;
    order.make(pairs, places);
    const std::vector<std::size_t> chunks = Seen(order, pairs).contacts;
    order.make(pairs, places);
    EXPECT_EQ(Seen(order, pairs).contacts, chunks);
    Placed placed(order, pairs);
    EXPECT_TRUE(placed.in_order);
    std::sort(placed.contacts.begin(), placed.contacts.end());
    for (std::size_t c = 0; c < count; ++c) ASSERT_EQ(placed.contacts[c], c);
  }
}

TEST(ContactOrder, WhereAllTouchOneVertexChunksComeOneByOne) {
  constexpr std::size_t kVeryMany = 40 * ContactOrder::kMany;  // more chunks than colours
  PairContacts pairs = strip(kVeryMany);
  for (PairContact& contact : pairs) contact.partner[0] = 0;
  ContactOrder order;
  order.make(pairs, places_of(kVeryMany));
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
    EXPECT_EQ(order.first_chunk(colour + 1) - order.first_chunk(colour), colour == 1 ? 1u : 16u);
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
