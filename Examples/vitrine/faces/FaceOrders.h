/**
 * What an s-buffer saves by the statements on the order of faces: what `vitrine paper faces` measures.
 *
 * The statements: A. V. Boreskov, the hierarchical s-buffer (docs/lab/culling.md, The order of faces).
 */
#ifndef VITRINE_FACE_ORDERS_H
#define VITRINE_FACE_ORDERS_H

#include "methods/Stage.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace program
{

/** Faces inserted by some of the statements. */
struct FaceOrderResult
{
  std::string Statements; ///< "compared" (no order is asked for), "none", "1", "2", "3" or "all"
  std::string Skipped;    ///< why it could not be measured; the rest is void then
  std::vector<double>
    Milliseconds;                ///< to insert all faces into an empty s-buffer, one for each round
  std::uint64_t Comparisons = 0; ///< of two depths
  std::uint64_t Lookups = 0;     ///< of pairs of faces
  std::uint64_t EndChecks = 0;   ///< whether two spans share an end
};

/** The same faces in one sequence, inserted in each way. */
struct FaceOrderRun
{
  std::string Faces;                    ///< what they are
  std::string Sequence;                 ///< "as-stored" or "front-to-back"
  std::size_t Count;                    ///< faces that look towards the eye
  std::vector<FaceOrderResult> Results; ///< the first is "compared"
};

struct FaceOrderComparison
{
  PictureSize Size{}; ///< columns and lines of the s-buffer
  std::vector<FaceOrderRun> Runs;
};

/** Insert generated faces `rounds` times in each way, the ways in turn. */
FaceOrderComparison MeasureFaceOrders(const PictureSize& size, int rounds);

/** The share of comparisons that the statements save, of those without any order. */
double SavedShare(const FaceOrderRun& run, const FaceOrderResult& result);

}
#endif
