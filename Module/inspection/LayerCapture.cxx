#include "inspection/LayerCapture.h"

#include "Shaders/SharedLayout.h"
#include "gl/Capabilities.h"
#include "gl/MemoryBarriers.h"
#include "gl/ScopedState.h"
#include "gl/StateRecord.h"
#include "scene/CaptureEvents.h"
#include "scene/ScopedRenderTime.h"
#include "shader/ShaderTags.h"
#include "shader/ShaderText.h"
#include "transparency/common/FillExtensions.h"
#include "transparency/common/FillShader.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>

namespace vitrine
{

static_assert(sizeof(LayerFragment) == sizeof(VitrineLayerFragment), "layout");
static_assert(offsetof(LayerFragment, Rgba) == offsetof(VitrineLayerFragment, Red), "layout");
static_assert(
  offsetof(LayerFragment, Coverage) == offsetof(VitrineLayerFragment, Coverage), "layout");
static_assert(offsetof(LayerFragment, Kind) == offsetof(VitrineLayerFragment, Kind), "layout");
static_assert(
  offsetof(LayerFragment, Primitive) == offsetof(VitrineLayerFragment, Primitive), "layout");
static_assert(LayerFragment::Opaque == VITRINE_OPAQUE_LAYER, "layout");
static_assert(LayerFragment::Added == VITRINE_ADDED_LAYER, "layout");
static_assert(LayerFragment::Tested == VITRINE_TESTED_LAYER, "layout");
static_assert(LayerFragment::FirstDrawBit == VITRINE_FIRST_DRAW_BIT, "layout");
static_assert(LayerFragment::BackFace == VITRINE_BACK_FACE, "layout");

const char* const LayerCapture::TooMany =
  "the driver has no room for all fragments; ask for fewer pixels at once";

vtkStandardNewMacro(LayerCapture);

namespace
{

constexpr std::int64_t FragmentBytes = sizeof(LayerFragment);
constexpr std::int64_t FirstCapacity = 4096;

// With several samples, llvmpipe loses samples along the edges of the scissor box. The shader cuts out the region then.
constexpr int ScissorMargin = 4;

FillShader ShaderFor(const LayerCapture::Request& request, bool version430)
{
  FillShader fill;
  fill.Version430 = version430;
  const std::vector<const char*>& extensions = FillExtensions();
  fill.Extensions.assign(extensions.begin(), extensions.end());
  fill.Defines = { "VITRINE_SAMPLES " + std::to_string(request.Samples) };
  if (request.FixedPoint)
  {
    fill.Defines.emplace_back("VITRINE_FIXED_POINT_TARGET");
  }
  fill.ReadsParts = true;
  fill.Declarations = shaders::LayerFillDec;
  fill.Implementation = shaders::LayerFillImpl;
  return fill;
}

void SetPair(vtkShaderProgram* program, const char* name, int x, int y)
{
  if (program->IsUniformUsed(name))
  {
    const int pair[2] = { x, y };
    program->SetUniform2i(name, pair);
  }
}
}

LayerCapture::~LayerCapture()
{
  this->ReleaseHeld();
}

void LayerCapture::ReleaseHeld()
{
  this->Context.Release(
    [this](vtkOpenGLRenderWindow* window) { this->ReleaseGraphicsResources(window); });
}

void LayerCapture::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Context.LivesIn(window))
  {
    this->Parts.Release();
    this->Target.Release();
    this->Counter.Release();
    this->Fragments.Release();
    this->Context.LetGo();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

std::string LayerCapture::Capture(const Request& request, std::vector<LayerFragment>& fragments)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(request.Renderer->GetRenderWindow());
  if (!this->Context.LivesIn(window))
  {
    this->ReleaseHeld();
    this->Parts = PartShader();
    this->Target = Framebuffer();
    this->Counter = Buffer();
    this->Fragments = Buffer();
    this->Context.Hold(window);
    this->IsTried = false;
  }
  const ScopedBindingMemory bindings;
  const ScopedTrackedState trackedState(window->GetState());
  const ScopedArrayBuffer arrayBuffer;
  const ScopedVertexArray vertexArray(0);
  const ScopedShaderProgram shaderProgram(window);
  const std::string problem = this->Prepare(request);
  return problem.empty() ? this->DrawAll(request, fragments) : problem;
}

/** Makes what the request needs. Returns why the driver cannot. */
std::string LayerCapture::Prepare(const Request& request)
{
  vtkOpenGLRenderWindow* const window = this->Context.Window();
  const bool isOther = !this->IsTried || request.Samples != this->Now.Samples ||
    request.FixedPoint != this->Now.FixedPoint;
  this->Now = request;
  if (isOther)
  {
    this->IsTried = true;
    this->Stage.Modified();
    this->Refused = MissingFeatures(4, 3, FillExtensions());
    if (this->Refused.empty())
    {
      this->Refused = this->FindVariant(window);
    }
  }
  if (!this->Refused.empty())
  {
    return this->Refused;
  }
  if ((this->Counter.Handle() == 0 && !this->Counter.Allocate(sizeof(VitrineCaptureCounters))) ||
    (this->Fragments.Handle() == 0 && !this->Fragments.Allocate(FirstCapacity * FragmentBytes)))
  {
    return "the driver has no memory for the fragments";
  }
  BindForDrawing(window->GetState(), this->Target.Handle());
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, request.Width);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, request.Height);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_SAMPLES, request.Samples);
  SetDrawBuffers(window->GetState(), { GL_NONE });
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
    ? std::string()
    : "the driver has no framebuffer without images";
}

/** Finds a version of the shaders that the driver compiles. Returns its message if it refuses all. */
std::string LayerCapture::FindVariant(vtkOpenGLRenderWindow* window)
{
  std::string problem;
  for (const bool version430 : { false, true })
  {
    problem = FindCompileProblem(window, ShaderFor(this->Now, version430));
    if (problem.empty())
    {
      this->Version430 = version430;
      return {};
    }
  }
  return "the driver refuses the shader that captures layers: " + problem;
}

/** Draws until all fragments have room. */
std::string LayerCapture::DrawAll(const Request& request, std::vector<LayerFragment>& fragments)
{
  const ScopedCaptureEvents events(
    request.Renderer); // They may add props, as caps of sections are.
  const std::vector<vtkProp*> props =
    this->Props.Find(request.Renderer, request.Pixels, !request.Translucent);
  if (props.empty())
  {
    return {};
  }
  for (int attempt = 0; attempt < 4; ++attempt)
  {
    const VitrineCaptureCounters zero = {};
    this->Counter.Write(0, sizeof(zero), &zero);
    this->Problem.clear();
    this->Draw(props);
    if (!this->Problem.empty())
    {
      // The next capture builds all shaders again, since a problem is found only while one is built.
      this->Stage.Modified();
      return this->Problem;
    }
    VitrineCaptureCounters counters = {};
    BarrierBeforeReadingBuffers();
    this->Counter.Read(0, sizeof(counters), &counters);
    const std::int64_t count = counters.Fragments + (std::int64_t(counters.Wraps) << 32);
    if (count <= this->Fragments.Bytes() / FragmentBytes)
    {
      const std::size_t before = fragments.size();
      fragments.resize(before + static_cast<std::size_t>(count));
      if (count > 0)
      {
        this->Fragments.Read(0, count * FragmentBytes, fragments.data() + before);
      }
      this->PlaceBlocks(fragments.data() + before, static_cast<std::size_t>(count));
      return {};
    }
    if (count * FragmentBytes > LargestStorageBlock() ||
      !this->Fragments.Allocate(std::min((count + count / 4) * FragmentBytes,
        LargestStorageBlock() / FragmentBytes * FragmentBytes)))
    {
      this->Fragments.Release();
      return TooMany;
    }
  }
  return "the props make more fragments each time they are drawn";
}

void LayerCapture::Draw(const std::vector<vtkProp*>& props)
{
  vtkRenderer* const renderer = this->Now.Renderer;
  vtkOpenGLState* const state = this->Context.Window()->GetState();
  const PixelRegion& r = this->Now.Pixels;
  const int margin = this->Now.Samples > 0 ? ScissorMargin : 0;
  BarrierBeforeFilling();
  PixelRegion viewport;
  renderer->GetTiledSizeAndOrigin(&viewport.Width, &viewport.Height, &viewport.X, &viewport.Y);
  BindForDrawing(state, this->Target.Handle());
  state->vtkglViewport(viewport.X, viewport.Y, viewport.Width, viewport.Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(r.X - margin, r.Y - margin, r.Width + 2 * margin, r.Height + 2 * margin);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);

  std::vector<vtkProp*> drawn = props;
  vtkRenderState renderState(renderer);
  renderState.SetPropArrayAndCount(drawn.data(), static_cast<int>(drawn.size()));
  const ScopedStorageBuffer counter(VITRINE_BINDING_COUNTERS, this->Counter.Handle());
  const ScopedStorageBuffer captured(VITRINE_BINDING_CAPTURE, this->Fragments.Handle());
  this->Parts.SetRenderer(renderer);
  this->BlockPlaces.clear();
  this->PreRender(&renderState);
  for (const bool opaque : { true, false })
  {
    this->DrawsOpaque = opaque;
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    this->LastPlace = 0;
    for (vtkProp* prop : props)
    {
      this->PropPlace = ++this->LastPlace;
      if (opaque || this->Now.Translucent)
      {
        this->DrawProp(prop);
      }
    }
  }
  this->PostRender(&renderState);
  this->Parts.SetDrawnProp(nullptr);
  ScopedBindingMemory::ForgetDeletedTextures();
}

void LayerCapture::DrawProp(vtkProp* prop)
{
  const ScopedRenderTime time(prop, this->Now.Renderer);
  this->Parts.SetDrawnProp(prop);
  if (this->DrawsOpaque)
  {
    prop->RenderOpaqueGeometry(this->Now.Renderer);
  }
  else if (prop->HasTranslucentPolygonalGeometry())
  {
    prop->RenderTranslucentPolygonalGeometry(this->Now.Renderer);
  }
}

bool LayerCapture::PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  FillShader fill = ShaderFor(this->Now, this->Version430);
  if (WritesDepth(fragmentShader))
  {
    fill.Defines.emplace_back("VITRINE_WRITES_DEPTH");
  }
  // VTK's own names primitives only where it needs them, and fragment shaders are told nothing then.
  InsertBeforeEach(geometryShader, "EmitVertex();", "gl_PrimitiveID = gl_PrimitiveIDIn; ");
  std::string problem = PartShader::Join(vertexShader, geometryShader, fragmentShader, mapper);
  if (problem.empty())
  {
    problem = JoinFillShader(fill, fragmentShader);
  }
  if (!problem.empty())
  {
    this->Problem = std::string("fragments of ") + (prop ? prop->GetClassName() : "a prop") +
      " cannot be captured: " + problem;
    fragmentShader = "//VTK::System::Dec\nvoid main()\n{\n  discard;\n}\n";
  }
  return true;
}

bool LayerCapture::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* VAO)
{
  const PixelRegion& r = this->Now.Pixels;
  int blend[4];
  this->Context.Window()->GetState()->GetBlendFuncState(blend);
  const bool adds = !this->DrawsOpaque && blend[0] == GL_SRC_ALPHA && blend[1] == GL_ONE;
  if (program->IsUniformUsed("vitrineLayerKind"))
  {
    const std::uint32_t kind = this->DrawsOpaque ? LayerFragment::Opaque
      : adds                                     ? LayerFragment::Added
                                                 : 0u;
    program->SetUniformi("vitrineLayerKind",
      static_cast<int>(kind | (this->PropPlace << LayerFragment::FirstDrawBit)));
    program->SetUniformi("vitrineLayerWidth", r.Width);
  }
  SetPair(program, "vitrineLayerFirst", r.X, r.Y);
  SetPair(program, "vitrineRegionFirst", r.X, r.Y);
  SetPair(program, "vitrineRegionEnd", r.X + r.Width, r.Y + r.Height);
  this->Parts.SetParameters(program, mapper, prop, VAO);
  if (this->DrawsOpaque)
  {
    this->NoteBlocks(mapper, prop);
  }
  return true;
}

/** Gives the blocks that a mapper is about to draw places behind that of their prop. */
void LayerCapture::NoteBlocks(vtkAbstractMapper* mapper, vtkProp* prop)
{
  for (const std::uint32_t number : this->Parts.NumbersInOrder(mapper, prop))
  {
    if (this->BlockPlaces.emplace(number, this->LastPlace + 1).second)
    {
      ++this->LastPlace;
    }
  }
}

/** Shaders know the place of a fragment's prop. Here it becomes that of its block. */
void LayerCapture::PlaceBlocks(LayerFragment* fragments, std::size_t count) const
{
  constexpr std::uint32_t Flags = (1u << LayerFragment::FirstDrawBit) - 1u;
  for (std::size_t i = 0; i < count && !this->BlockPlaces.empty(); ++i)
  {
    LayerFragment& f = fragments[i];
    const auto place = (f.Kind & LayerFragment::Opaque) != 0
      ? this->BlockPlaces.find(f.Part & ~LayerFragment::BackFace)
      : this->BlockPlaces.end();
    if (place != this->BlockPlaces.end())
    {
      f.Kind = (f.Kind & Flags) | (place->second << LayerFragment::FirstDrawBit);
    }
  }
}

}
