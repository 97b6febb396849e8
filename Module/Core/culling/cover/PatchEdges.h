#ifndef VITRINE_CORE_CULLING_COVER_PATCH_EDGES_H
#define VITRINE_CORE_CULLING_COVER_PATCH_EDGES_H

#include "Core/culling/cover/OpenLines.h"
#include "Core/culling/cover/ScreenPatches.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/screen/MeshProjection.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * The edges between patches of an occluder, and its outline edges with nothing on one side, cut into pieces per line.
 * Patches with a common edge belong to one sheet.
 */
class PatchEdges
{
public:
  static constexpr std::uint32_t None = ScreenPatches::None;

  /** An interval of columns. */
  struct Interval
  {
    float Left;
    float Right;

    bool IsEmpty() const { return !(this->Left < this->Right); }
  };

  /** A piece of an edge on a line. */
  struct Piece
  {
    Interval Touched;   ///< the columns that it may touch, wherever a device draws it
    float Middle;       ///< the column where it crosses the middle of the line
    std::uint32_t Left; ///< the patch on its left, or None
    std::uint32_t Right;
    std::uint32_t Sheet;
    bool IsCrossing;    ///< it crosses the middle of the line
    std::uint32_t Next; ///< the next piece on the line

    bool IsOutline() const { return this->Left == None || this->Right == None; }

    /** Returns the change from left to right of how often a patch, or the whole sheet, covers the line. */
    int TurnOf(std::uint32_t patch) const
    {
      return this->IsCrossing ? (this->Right == patch) - (this->Left == patch) : 0;
    }
    int Turn() const { return this->IsCrossing ? (this->Right != None) - (this->Left != None) : 0; }
  };

  /** The input of Find(). */
  struct Subject
  {
    const MeshProjection* Projection; ///< the projected occluder, with its facings
    MeshProjection::Facing Facing;    ///< the facing of the faces that count
    const ScreenPatches* Patches;     ///< the patches of these faces
    const OpenLines* Open;            ///< open lines; others are left out
    LineRange Lines;
    float Inset; ///< samples are at least this far from the sides of a line
  };

  void Find(const Subject& subject);

  /** Returns the number of pieces. */
  std::size_t Count() const { return this->Pieces.size(); }

  /** Calls `work` with each piece on a line, in any order. */
  template <class Work>
  void ForEachOn(int line, const Work& work) const
  {
    for (std::uint32_t i = this->Heads[this->IndexOf(line)]; i != None; i = this->Pieces[i].Next)
    {
      work(this->Pieces[i]);
    }
  }

private:
  template <class Work>
  void ForEachEdge(const Work& work) const;
  void FindSheets();
  std::uint32_t SheetOf(std::uint32_t patch);
  void AddEdge(const MeshEdge& edge, std::uint32_t left, std::uint32_t right);
  std::size_t IndexOf(int line) const
  {
    return static_cast<std::size_t>(line - this->Current.Lines.First);
  }

  Subject Current{};
  std::vector<std::uint32_t> Parents; ///< of each patch the parent in the forest of sheets
  std::vector<Piece> Pieces;
  std::vector<std::uint32_t> Heads; ///< of each line the first piece
};

}

#endif
