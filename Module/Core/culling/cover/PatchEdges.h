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

/** Edges between patches of an occluder, and those with nothing on one side, as they touch lines. Patches that have an edge in common are of one sheet. */
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

  /** An edge on a line. */
  struct Piece
  {
    Interval Touched;   ///< what it may touch, wherever a device draws it
    float Middle;       ///< where it crosses the line's middle
    std::uint32_t Left; ///< the patch on that side, or None
    std::uint32_t Right;
    std::uint32_t Sheet;
    bool IsCrossing;    ///< the line's middle
    std::uint32_t Next; ///< on the line

    bool IsOutline() const { return this->Left == None || this->Right == None; }

    /** By how much a patch, or all of a sheet, covers more on its right. */
    int TurnOf(std::uint32_t patch) const
    {
      return this->IsCrossing ? (this->Right == patch) - (this->Left == patch) : 0;
    }
    int Turn() const { return this->IsCrossing ? (this->Right != None) - (this->Left != None) : 0; }
  };

  /** What edges are found of. */
  struct Subject
  {
    const MeshProjection* Projection; ///< of the occluder, with its facings
    MeshProjection::Facing Facing;    ///< of the faces that count
    const ScreenPatches* Patches;     ///< of those
    const OpenLines* Open;            ///< lines, of which others are left out
    LineRange Lines;
    float Inset; ///< how far from their sides lines have no samples
  };

  void Find(const Subject& subject);

  /** Of pieces. */
  std::size_t Count() const { return this->Pieces.size(); }

  /** Does something with each piece on a line, in any order. */
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
  std::vector<std::uint32_t> Parents; ///< of patches
  std::vector<Piece> Pieces;
  std::vector<std::uint32_t> Heads; ///< of each line's pieces
};

}

#endif
