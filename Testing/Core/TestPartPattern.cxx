#include "Core/assembly/PartPattern.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using vitrine::PartNames;
using vitrine::PartPattern;
using vitrine::PatternError;

namespace
{

const std::vector<PartNames> Machine = {
  { "/Machine/Housing/lid", "Grey paint" },
  { "/Machine/Housing/lid (2)", "Grey paint" },
  { "/Machine/Housing/window", "glass, clear" },
  { "/Machine/Gearbox/gear-1", "steel" },
  { "/Machine/Gearbox/gear-2/bolt", "steel" },
  { "/Machine/Gearbox/gear-2/bolt (2)", "" },
  { "/Machine/a*b?c", "steel" },
};

std::vector<int> Choose(const std::string& pattern)
{
  return PartPattern(pattern).Choose(Machine);
}

using Chosen = std::vector<int>;

TEST(PartPattern, NamesANodeWithItsSubtree)
{
  EXPECT_EQ(Choose("gear-1"), (Chosen{ 3 }));
  EXPECT_EQ(Choose("gear*"), (Chosen{ 3, 4, 5 }));
  EXPECT_EQ(Choose("Gearbox"), (Chosen{ 3, 4, 5 }));
  EXPECT_EQ(Choose("Machine"), (Chosen{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(Choose("gear-?"), (Chosen{ 3, 4, 5 }));
}

TEST(PartPattern, IsWholeName)
{
  EXPECT_EQ(Choose("gear"), Chosen{});
  EXPECT_EQ(Choose("ear-1"), Chosen{});
  EXPECT_EQ(Choose("*box"), (Chosen{ 3, 4, 5 }));
}

TEST(PartPattern, CaseCounts)
{
  EXPECT_EQ(Choose("gearbox"), Chosen{});
  EXPECT_EQ(Choose("LID"), Chosen{});
}

TEST(PartPattern, StopsAtSlashesOfAPath)
{
  EXPECT_EQ(Choose("/Machine/Housing/*"), (Chosen{ 0, 1, 2 }));
  EXPECT_EQ(Choose("/Machine/*/bolt"), Chosen{});
  EXPECT_EQ(Choose("/Machine/**/bolt"), (Chosen{ 4, 5 }));
  EXPECT_EQ(Choose("/*/Gearbox/gear-?"), (Chosen{ 3, 4, 5 }));
  EXPECT_EQ(Choose("/Housing"), Chosen{});
  EXPECT_EQ(Choose("/**"), (Chosen{ 0, 1, 2, 3, 4, 5, 6 }));
}

TEST(PartPattern, EndsAPathWithoutALeadingSlash)
{
  EXPECT_EQ(Choose("Housing/lid"), (Chosen{ 0, 1 }));
  EXPECT_EQ(Choose("gear-2/*"), (Chosen{ 4, 5 }));
  EXPECT_EQ(Choose("ousing/lid"), Chosen{});
}

TEST(PartPattern, TakesNumbersOfEqualNamesForNoPartOfThem)
{
  EXPECT_EQ(Choose("lid"), (Chosen{ 0, 1 }));
  EXPECT_EQ(Choose("lid (2)"), (Chosen{ 1 }));
  EXPECT_EQ(PartPattern("a (x)").Choose({ { "/a (x)", "" }, { "/a ()", "" } }), (Chosen{ 0 }));
  EXPECT_EQ(PartPattern("a").Choose({ { "/a (x)", "" }, { "/a ()", "" }, { "/a (12)", "" } }),
    (Chosen{ 2 }));
}

TEST(PartPattern, ChoosesByMaterial)
{
  EXPECT_EQ(Choose("material:glass*"), (Chosen{ 2 }));
  EXPECT_EQ(Choose("material:steel"), (Chosen{ 3, 4, 6 }));
  EXPECT_EQ(Choose("material:*"), (Chosen{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(PartPattern("material:a*").Choose({ { "/x", "a/b" } }), (Chosen{ 0 }));
  EXPECT_EQ(PartPattern("material\\:a").Choose({ { "/material:a", "" } }), (Chosen{ 0 }));
}

TEST(PartPattern, EscapesCharacters)
{
  EXPECT_EQ(Choose("a\\*b\\?c"), (Chosen{ 6 }));
  EXPECT_EQ(Choose("a\\*c"), Chosen{});
  EXPECT_EQ(PartPattern("a\\\\b").Choose({ { "/a\\b", "" } }), (Chosen{ 0 }));
  EXPECT_EQ(PartPattern("[1]").Choose({ { "/[1]", "" }, { "/1", "" } }), (Chosen{ 0 }));
}

TEST(PartPattern, CountsCharactersAndNotBytes)
{
  const std::vector<PartNames> names = { { "/Gehäuse", "" }, { "/Gehause", "" }, { "/日本", "" } };
  EXPECT_EQ(PartPattern("Geh?use").Choose(names), (Chosen{ 0, 1 }));
  EXPECT_EQ(PartPattern("Geh??use").Choose(names), Chosen{});
  EXPECT_EQ(PartPattern("?本").Choose(names), (Chosen{ 2 }));
  EXPECT_EQ(PartPattern("??").Choose(names), (Chosen{ 2 }));
}

TEST(PartPattern, RefusesWhatIsNoPattern)
{
  EXPECT_THROW(PartPattern(""), PatternError);
  EXPECT_THROW(PartPattern("material:"), PatternError);
  EXPECT_THROW(PartPattern("bolt\\"), PatternError);
}

TEST(PartPattern, NamesNearMisses)
{
  EXPECT_EQ(
    PartPattern("gearbox").DescribeMiss(Machine), "'gearbox' chooses no part; near are 'Gearbox'");
  EXPECT_EQ(PartPattern("Lid*").DescribeMiss(Machine), "'Lid*' chooses no part; near are 'lid'");
  EXPECT_EQ(PartPattern("bold").DescribeMiss(Machine), "'bold' chooses no part; near are 'bolt'");
  EXPECT_EQ(PartPattern("material:Steal").DescribeMiss(Machine),
    "'material:Steal' chooses no part; near are 'steel'");
  EXPECT_EQ(PartPattern("/Machine/Housing/wndow").DescribeMiss(Machine),
    "'/Machine/Housing/wndow' chooses no part; near are '/Machine/Housing/window', "
    "'/Machine/Housing/lid', '/Machine/Housing'");
  EXPECT_EQ(PartPattern("zzzzzz").DescribeMiss(Machine), "'zzzzzz' chooses no part");
}

// A pattern of stars takes time in proportion to its length, and not to the number of ways through it.
TEST(PartPattern, EndsSoonWithManyStars)
{
  std::string stars;
  for (int i = 0; i < 200; ++i)
  {
    stars += "*a";
  }
  EXPECT_EQ(PartPattern(stars + "b").Choose({ { "/" + std::string(5000, 'a'), "" } }), Chosen{});
}
}
