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

using Numbers = std::vector<int>;

TEST(PartPattern, NamesANodeWithItsSubtree)
{
  EXPECT_EQ(Choose("gear-1"), (Numbers{ 3 }));
  EXPECT_EQ(Choose("gear*"), (Numbers{ 3, 4, 5 }));
  EXPECT_EQ(Choose("Gearbox"), (Numbers{ 3, 4, 5 }));
  EXPECT_EQ(Choose("Machine"), (Numbers{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(Choose("gear-?"), (Numbers{ 3, 4, 5 }));
}

TEST(PartPattern, IsWholeName)
{
  EXPECT_EQ(Choose("gear"), Numbers{});
  EXPECT_EQ(Choose("ear-1"), Numbers{});
  EXPECT_EQ(Choose("*box"), (Numbers{ 3, 4, 5 }));
}

TEST(PartPattern, CaseCounts)
{
  EXPECT_EQ(Choose("gearbox"), Numbers{});
  EXPECT_EQ(Choose("LID"), Numbers{});
}

TEST(PartPattern, StopsAtSlashesOfAPath)
{
  EXPECT_EQ(Choose("/Machine/Housing/*"), (Numbers{ 0, 1, 2 }));
  EXPECT_EQ(Choose("/Machine/*/bolt"), Numbers{});
  EXPECT_EQ(Choose("/Machine/**/bolt"), (Numbers{ 4, 5 }));
  EXPECT_EQ(Choose("/*/Gearbox/gear-?"), (Numbers{ 3, 4, 5 }));
  EXPECT_EQ(Choose("/Housing"), Numbers{});
  EXPECT_EQ(Choose("/**"), (Numbers{ 0, 1, 2, 3, 4, 5, 6 }));
}

TEST(PartPattern, EndsAPathWithoutALeadingSlash)
{
  EXPECT_EQ(Choose("Housing/lid"), (Numbers{ 0, 1 }));
  EXPECT_EQ(Choose("gear-2/*"), (Numbers{ 4, 5 }));
  EXPECT_EQ(Choose("ousing/lid"), Numbers{});
}

TEST(PartPattern, TakesNumbersOfEqualNamesForNoPartOfThem)
{
  EXPECT_EQ(Choose("lid"), (Numbers{ 0, 1 }));
  EXPECT_EQ(Choose("lid (2)"), (Numbers{ 1 }));
  EXPECT_EQ(PartPattern("a (x)").Choose({ { "/a (x)", "" }, { "/a ()", "" } }), (Numbers{ 0 }));
  EXPECT_EQ(PartPattern("a").Choose({ { "/a (x)", "" }, { "/a ()", "" }, { "/a (12)", "" } }),
    (Numbers{ 2 }));
}

TEST(PartPattern, ChoosesByMaterial)
{
  EXPECT_EQ(Choose("material:glass*"), (Numbers{ 2 }));
  EXPECT_EQ(Choose("material:steel"), (Numbers{ 3, 4, 6 }));
  EXPECT_EQ(Choose("material:*"), (Numbers{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(PartPattern("material:a*").Choose({ { "/x", "a/b" } }), (Numbers{ 0 }));
  EXPECT_EQ(PartPattern("material\\:a").Choose({ { "/material:a", "" } }), (Numbers{ 0 }));
}

TEST(PartPattern, EscapesCharacters)
{
  EXPECT_EQ(Choose("a\\*b\\?c"), (Numbers{ 6 }));
  EXPECT_EQ(Choose("a\\*c"), Numbers{});
  EXPECT_EQ(PartPattern("a\\\\b").Choose({ { "/a\\b", "" } }), (Numbers{ 0 }));
  EXPECT_EQ(PartPattern("[1]").Choose({ { "/[1]", "" }, { "/1", "" } }), (Numbers{ 0 }));
}

TEST(PartPattern, CountsCharactersAndNotBytes)
{
  const std::vector<PartNames> names = { { "/Gehäuse", "" }, { "/Gehause", "" }, { "/日本", "" } };
  EXPECT_EQ(PartPattern("Geh?use").Choose(names), (Numbers{ 0, 1 }));
  EXPECT_EQ(PartPattern("Geh??use").Choose(names), Numbers{});
  EXPECT_EQ(PartPattern("?本").Choose(names), (Numbers{ 2 }));
  EXPECT_EQ(PartPattern("??").Choose(names), (Numbers{ 2 }));
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
  EXPECT_EQ(PartPattern(stars + "b").Choose({ { "/" + std::string(5000, 'a'), "" } }), Numbers{});
}
}
