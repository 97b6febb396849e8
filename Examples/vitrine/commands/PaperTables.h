/**
 * The tables that `paper` draws again: what is drawn, and what is known of the papers' own figures.
 *
 * Stencil masks: Korostelev, Dolgovesov, Mazurok, 2011. Of the papers' figures only shares of the
 * frame rate of plain blending are known here, by the number of layers that the method stores.
 */
#ifndef VITRINE_PAPER_TABLES_H
#define VITRINE_PAPER_TABLES_H

#include "commands/Comparison.h"

#include <optional>
#include <string>
#include <vector>

namespace program
{

/** What a paper measured with room for that many layers. */
struct PaperFigure
{
  int Layers;
  double ShareOfBlend;
};

struct PaperTable
{
  std::string Name;
  std::string Title;
  std::string Scene;            ///< without its number of layers
  std::vector<int> Layers;      ///< that the scene is drawn with
  std::string Methods;          ///< a list for ParseMethodList()
  std::vector<PaperFigure> Own; ///< the paper's, in order of layers
};

const std::vector<PaperTable>& PaperTables();

/**
 * The share that the paper's method reaches where `method` draws that many layers: with the fewest layers
 * stored that hold them, and for a mask with as many as it has itself. Nothing for methods that are not
 * the module's, and where the paper has no such figure.
 */
std::optional<double> PaperShare(const PaperTable& table, const std::string& method, int layers);

/** The methods compared on the scene with some number of layers. */
struct PaperStep
{
  int Layers;
  ComparisonResult Comparison;
};

struct PaperResult
{
  const PaperTable* Table;
  std::vector<PaperStep> Steps;
};

}
#endif
