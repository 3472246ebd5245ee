#include <rift/base/disjoint_sets.h>

#include <gtest/gtest.h>

#include <random>

using rift::DisjointSets;

TEST(DisjointSets, AreNamedByTheirSmallest)
{
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(4, 2);
  sets.unite(3, 4);
  for (const std::uint32_t i : {2, 3, 4, 5})
    EXPECT_EQ(sets.find(i), 2u);
  EXPECT_EQ(sets.find(0), 0u);
  EXPECT_EQ(sets.find(1), 1u);
}

TEST(DisjointSets, RandomUnionsAgreeWithRelabelling)
{
  std::mt19937               random(1);
  constexpr std::uint32_t    n = 60;
  DisjointSets               sets(n);
  std::vector<std::uint32_t> labels(n);
  std::iota(labels.begin(), labels.end(), 0u);
  for (unsigned int repetition = 0; repetition < 55; ++repetition)
    {
      const std::uint32_t i = random() % n, j = random() % n;
      sets.unite(i, j);
      const std::uint32_t low  = std::min(labels[i], labels[j]),
                          high = std::max(labels[i], labels[j]);
      std::replace(labels.begin(), labels.end(), high, low);
      for (std::uint32_t k = 0; k < n; ++k)
        ASSERT_EQ(sets.find(k), labels[k]);
    }
}
