/** Lets the planes of a section cut what mappers draw, and caps look up what is cut. */
#ifndef VITRINE_SECTION_SECTION_SHADER_H
#define VITRINE_SECTION_SECTION_SHADER_H

#include "gl/GLObjects.h"
#include "gl/HeldContext.h"
#include "gl/ScopedState.h"
#include "scene/PartShader.h"
#include "section/SectionPlanes.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace vitrine
{

/**
 * A render pass that draws nothing. It is listed among the passes of props (vtkOpenGLRenderPass::RenderPasses()) while
 * their renderer draws a frame, whatever pass draws it, and changes the shaders of their mappers.
 */
class SectionShader : public vtkOpenGLRenderPass
{
public:
  static SectionShader* New();
  vtkTypeMacro(SectionShader, vtkOpenGLRenderPass);

  /** Begin a frame of a renderer, with its planes, and end it. */
  void BeginFrame(vtkRenderer* renderer, const SectionPlanes& planes);
  void EndFrame();

  /** Set the samples of a pixel of the sums that caps look up, 0 for one. */
  void SetSamples(int samples);

  /** Release what is held in the context of a window, or wherever it is. */
  void Release(vtkWindow* window);
  void Release();

  /** Returns the planes that apply to a prop without blocks, or to all blocks of a prop. */
  std::function<PlaneMasks(vtkProp*)> MasksOf;

  /** Returns the planes that apply to each block of a prop, by flat index. It is empty if they are the same for all. */
  std::function<std::vector<PlaneMasks>(vtkProp*)> MasksOfBlocks;

  /** Sets the uniforms of a cap's own lookups. */
  std::function<void(vtkShaderProgram*, vtkProp*)> SetCapUniforms;

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }

private:
  void UseWindow();
  void SetBlockMasks(vtkShaderProgram* program, vtkProp* prop);

  SectionPlanes Planes;
  HeldContext Context; ///< of MaskBuffer and Blocks
  int Samples = 0;
  vtkTimeStamp Stage;
  PartShader Blocks; ///< tells shaders the block of each vertex
  vtkWeakPointer<vtkRenderer> Renderer;
  std::map<vtkProp*, int> Rows;                        ///< of the frame's props with masks by block
  std::vector<std::array<std::uint32_t, 2>> MaskTable; ///< masks of all rows
  Buffer MaskBuffer;
  std::unique_ptr<ScopedTextureUnit> MaskUnit;
};

}

#endif
