/**
 * The culler, which remembers what it left out, so that a failure can name it.
 */
#ifndef VITRINE_RECORDING_CULLER_H
#define VITRINE_RECORDING_CULLER_H

#include "TestPicture.h"
#include "vtkHierarchicalSBufferCuller.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <optional>
#include <string>
#include <vector>

class RecordingCuller : public vtkHierarchicalSBufferCuller
{
public:
  static RecordingCuller* New();
  vtkTypeMacro(RecordingCuller, vtkHierarchicalSBufferCuller);

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized) override;

  /** Forget what was left out of frames before. */
  void Forget() { this->LeftOut.clear(); }

  /** Whether anything was left out since then. A culler that only counts leaves out nothing. */
  bool HasLeftOut() const { return !this->LeftOut.empty(); }

  /**
   * A line for each prop that was left out, as a whole or in parts, and whose bounds may cover a pixel of the window,
   * and the indices of the others. Props that are gone since then are not told.
   */
  std::string DescribeLeftOut(const std::optional<PixelPlace>& pixel) const;

protected:
  RecordingCuller() = default;

private:
  /** A prop of which something was left out. */
  struct LeftOutProp
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkProp> Prop;
    std::vector<int>
      Parts; ///< those of its mapper that were left out; empty where the whole prop was

    bool MayCover(const PixelPlace& pixel) const;
    std::string Describe(int index) const;
  };

  std::vector<LeftOutProp> LeftOut;
};

#endif
