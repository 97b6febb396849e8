/** What is told about the last frame of a view. A server that drew it sends this to its client. */
#ifndef VITRINE_PARAVIEW_FRAME_ANSWERS_H
#define VITRINE_PARAVIEW_FRAME_ANSWERS_H

#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;
class vtkPVSession;

namespace vitrine
{

/** A layer under a pixel. */
struct LayerOfPixel
{
  int Rank = 0;                    ///< that has its geometry
  unsigned int Representation = 0; ///< the unique identifier of that which shows it, or 0
  std::string Block;               ///< names of blocks from the outermost on, with slashes between
  double Depth = 1.0;              ///< of the window, in [0, 1]
  double Distance = 0.0;           ///< along the ray, in world units
  double Share = 0.0;              ///< of the picture, in [0, 1]
};

struct FrameAnswers
{
  std::string Reason; ///< why the frame was not drawn exactly, or empty
  vtkIdType Fragments = 0;
  vtkIdType MostLayers = 0;
  std::string CullingReason; ///< why less was left out than all that is hidden, or empty
  vtkIdType CulledParts = 0;
  /** The representations and blocks that a section with caps cuts and that are not closed in this process. */
  std::vector<std::pair<unsigned int, unsigned int>> OpenParts;
  vtkIdType DividedParts = 0; ///< open parts that several ranks have
  std::string LayersProblem;  ///< why the layers cannot be told, or empty
  std::vector<LayerOfPixel> Layers;

  /**
   * Gives rank 0 the names of layers of other ranks, and the numbers of parts that are left out, and divided. All
   * ranks have the same layers, and know the names of their own. All ranks of the controller call this.
   */
  void Gather(vtkMultiProcessController* ranks);

  /** Sends the answers to the client, or receives those of the server. Does nothing where there is one process. */
  void Exchange(vtkPVSession* session);
};

}

#endif
