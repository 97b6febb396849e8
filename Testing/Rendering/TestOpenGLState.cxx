// A pass puts back all of OpenGL's state, and keeps vtkOpenGLState's record of it true.
#include "SectionScene.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPartOutlines.h"
#include "vtkRenderPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace
{

constexpr int Units = 16;

using GLRecord = std::map<std::string, std::vector<GLint64>>;

#define NAMED(e)                                                                                   \
  {                                                                                                \
    e, #e                                                                                          \
  }
struct NamedEnum
{
  GLenum Value;
  const char* Name;
};

const NamedEnum Scalars[] = { NAMED(GL_CURRENT_PROGRAM), NAMED(GL_VERTEX_ARRAY_BINDING),
  NAMED(GL_ACTIVE_TEXTURE), NAMED(GL_ARRAY_BUFFER_BINDING), NAMED(GL_SHADER_STORAGE_BUFFER_BINDING),
  NAMED(GL_UNIFORM_BUFFER_BINDING), NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING),
  NAMED(GL_PIXEL_PACK_BUFFER_BINDING), NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING),
  NAMED(GL_COPY_WRITE_BUFFER_BINDING), NAMED(GL_DRAW_FRAMEBUFFER_BINDING),
  NAMED(GL_READ_FRAMEBUFFER_BINDING), NAMED(GL_RENDERBUFFER_BINDING), NAMED(GL_DRAW_BUFFER0),
  NAMED(GL_DRAW_BUFFER1), NAMED(GL_READ_BUFFER), NAMED(GL_BLEND_SRC_RGB), NAMED(GL_BLEND_DST_RGB),
  NAMED(GL_BLEND_SRC_ALPHA), NAMED(GL_BLEND_DST_ALPHA), NAMED(GL_BLEND_EQUATION_RGB),
  NAMED(GL_BLEND_EQUATION_ALPHA), NAMED(GL_DEPTH_FUNC), NAMED(GL_DEPTH_WRITEMASK),
  NAMED(GL_CULL_FACE_MODE), NAMED(GL_FRONT_FACE), NAMED(GL_STENCIL_FUNC), NAMED(GL_STENCIL_REF),
  NAMED(GL_STENCIL_VALUE_MASK), NAMED(GL_STENCIL_WRITEMASK), NAMED(GL_STENCIL_FAIL),
  NAMED(GL_STENCIL_PASS_DEPTH_FAIL), NAMED(GL_STENCIL_PASS_DEPTH_PASS), NAMED(GL_STENCIL_BACK_FUNC),
  NAMED(GL_STENCIL_BACK_REF), NAMED(GL_STENCIL_BACK_VALUE_MASK), NAMED(GL_STENCIL_BACK_WRITEMASK),
  NAMED(GL_STENCIL_BACK_FAIL), NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
  NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS), NAMED(GL_POLYGON_MODE), NAMED(GL_PACK_ALIGNMENT),
  NAMED(GL_PACK_ROW_LENGTH), NAMED(GL_PACK_SKIP_ROWS), NAMED(GL_PACK_SKIP_PIXELS),
  NAMED(GL_PACK_SWAP_BYTES), NAMED(GL_UNPACK_ALIGNMENT), NAMED(GL_UNPACK_ROW_LENGTH),
  NAMED(GL_UNPACK_SKIP_ROWS), NAMED(GL_UNPACK_SKIP_PIXELS), NAMED(GL_UNPACK_SWAP_BYTES),
  NAMED(GL_LOGIC_OP_MODE) };

// How pixels lie in memory: values that no one has, and OpenGL's own.
const struct
{
  GLenum Name;
  GLint Odd;
  GLint Default;
} PixelSettings[] = { { GL_PACK_ALIGNMENT, 8, 4 }, { GL_PACK_ROW_LENGTH, 123, 0 },
  { GL_PACK_SKIP_ROWS, 3, 0 }, { GL_PACK_SKIP_PIXELS, 5, 0 }, { GL_PACK_SWAP_BYTES, 1, 0 },
  { GL_UNPACK_ALIGNMENT, 8, 4 }, { GL_UNPACK_ROW_LENGTH, 77, 0 }, { GL_UNPACK_SKIP_ROWS, 2, 0 },
  { GL_UNPACK_SKIP_PIXELS, 7, 0 }, { GL_UNPACK_SWAP_BYTES, 1, 0 } };

const NamedEnum Capabilities[] = { NAMED(GL_BLEND), NAMED(GL_DEPTH_TEST), NAMED(GL_SCISSOR_TEST),
  NAMED(GL_STENCIL_TEST), NAMED(GL_CULL_FACE), NAMED(GL_MULTISAMPLE), NAMED(GL_SAMPLE_SHADING),
  NAMED(GL_SAMPLE_MASK), NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE), NAMED(GL_SAMPLE_COVERAGE),
  NAMED(GL_POLYGON_OFFSET_FILL), NAMED(GL_DEPTH_CLAMP), NAMED(GL_RASTERIZER_DISCARD),
  NAMED(GL_FRAMEBUFFER_SRGB), NAMED(GL_CLIP_DISTANCE0), NAMED(GL_PRIMITIVE_RESTART),
  NAMED(GL_PROGRAM_POINT_SIZE), NAMED(GL_COLOR_LOGIC_OP) };

const NamedEnum TextureTargets[] = { NAMED(GL_TEXTURE_BINDING_2D),
  NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE), NAMED(GL_TEXTURE_BINDING_BUFFER),
  NAMED(GL_TEXTURE_BINDING_2D_ARRAY), NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY),
  NAMED(GL_TEXTURE_BINDING_3D), NAMED(GL_TEXTURE_BINDING_CUBE_MAP), NAMED(GL_SAMPLER_BINDING) };

const NamedEnum ImageQueries[] = { NAMED(GL_IMAGE_BINDING_NAME), NAMED(GL_IMAGE_BINDING_LEVEL),
  NAMED(GL_IMAGE_BINDING_LAYERED), NAMED(GL_IMAGE_BINDING_LAYER), NAMED(GL_IMAGE_BINDING_ACCESS),
  NAMED(GL_IMAGE_BINDING_FORMAT) };
#undef NAMED

GLint64 Query(GLenum name)
{
  GLint64 value[4] = { 0, 0, 0, 0 };
  glGetInteger64v(name, value);
  return value[0];
}

void RecordIndexed(GLRecord& record)
{
  GLint sampleMask = 0;
  glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &sampleMask);
  record["sample mask"] = { sampleMask };
  for (GLuint i = 0; i < 8; ++i)
  {
    GLint name = 0;
    GLint64 range[2] = { 0, 0 };
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &name);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &range[0]);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &range[1]);
    record["storage buffer " + std::to_string(i)] = { name, range[0], range[1] };
  }
  for (GLuint unit = 0; unit < 4; ++unit)
  {
    for (const NamedEnum& query : ImageQueries)
    {
      GLint value = 0;
      glGetIntegeri_v(query.Value, unit, &value);
      record[std::string(query.Name) + " " + std::to_string(unit)] = { value };
    }
  }
  const GLint64 active = Query(GL_ACTIVE_TEXTURE);
  for (GLuint unit = 0; unit < Units; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const NamedEnum& target : TextureTargets)
    {
      record[std::string(target.Name) + " " + std::to_string(unit)] = { Query(target.Value) };
    }
  }
  glActiveTexture(static_cast<GLenum>(active));
}

GLRecord RecordState()
{
  GLRecord record;
  for (const NamedEnum& scalar : Scalars)
  {
    record[scalar.Name] = { Query(scalar.Value) };
  }
  for (const NamedEnum& capability : Capabilities)
  {
    record[capability.Name] = { glIsEnabled(capability.Value) };
  }
  GLint box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  record["viewport"].assign(box, box + 4);
  glGetIntegerv(GL_SCISSOR_BOX, box);
  record["scissor"].assign(box, box + 4);
  GLboolean mask[4];
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  record["colour mask"].assign(mask, mask + 4);
  GLfloat clear[4];
  glGetFloatv(GL_COLOR_CLEAR_VALUE, clear);
  for (const GLfloat component : clear)
  {
    record["clear colour"].push_back(static_cast<GLint64>(1e6f * component));
  }
  GLfloat shading = 0.0f;
  glGetFloatv(GL_MIN_SAMPLE_SHADING_VALUE, &shading);
  record["sample shading"] = { static_cast<GLint64>(1e6f * shading) };
  RecordIndexed(record);
  return record;
}

// What vtkOpenGLState believes must be what OpenGL says.
void ExpectTrueRecord(vtkOpenGLState* state)
{
  for (const GLenum capability :
    { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_MULTISAMPLE })
  {
    EXPECT_EQ(state->GetEnumState(capability), glIsEnabled(capability) == GL_TRUE) << capability;
  }
  for (const GLenum name : { GL_VIEWPORT, GL_SCISSOR_BOX, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB,
         GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA, GL_DEPTH_FUNC, GL_CULL_FACE_MODE })
  {
    GLint believed[4] = { 0, 0, 0, 0 };
    GLint is[4] = { 0, 0, 0, 0 };
    state->vtkglGetIntegerv(name, believed);
    glGetIntegerv(name, is);
    EXPECT_TRUE(std::equal(believed, believed + 4, is)) << name;
  }
  GLboolean believed = GL_FALSE;
  state->vtkglGetBooleanv(GL_DEPTH_WRITEMASK, &believed);
  EXPECT_EQ(believed, Query(GL_DEPTH_WRITEMASK));
}

// Fills the state with things to be kept, renders by a pass, and compares.
class StateCheckingPass : public vtkRenderPass
{
public:
  static StateCheckingPass* New();
  vtkTypeMacro(StateCheckingPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    this->Bind(window->GetState());
    const GLRecord before = RecordState();
    this->Delegate->Render(s);
    const GLRecord after = RecordState();
    for (const auto& entry : before)
    {
      if (this->IsOfVTK && after.at(entry.first) != entry.second)
      {
        this->ChangedByVTK.insert(entry.first);
      }
      if (this->ChangedByVTK.count(entry.first) == 0)
      {
        EXPECT_EQ(after.at(entry.first), entry.second) << entry.first;
      }
    }
    ExpectTrueRecord(window->GetState());
    this->Unbind(window->GetState());
    ++this->Frames;
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  int Frames = 0;
  bool IsOfVTK = false;               // a frame of VTK's alone may leave state changed
  std::set<std::string> ChangedByVTK; // in such frames, and allowed in others

private:
  void Bind(vtkOpenGLState* state)
  {
    glGenBuffers(1, &this->Buffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 8; ++i)
    {
      if (this->Frames == 0)
      {
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, this->Buffer, 256 * i, 256 * (i + 1));
      }
      else
      {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, this->Buffer); // whole
      }
    }
    glGenTextures(3, this->Textures);
    for (GLuint unit = 0; unit < Units; ++unit)
    {
      state->vtkglActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, this->Textures[0]);
      glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, this->Textures[1]);
      glBindTexture(GL_TEXTURE_BUFFER, this->Textures[2]);
    }
    state->vtkglActiveTexture(GL_TEXTURE3);
    glTexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8UI, 4, 4);
    for (GLuint unit = 0; unit < 4; ++unit)
    {
      glBindImageTexture(unit, this->Textures[0], 1, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA8UI);
    }
    glGenVertexArrays(1, &this->VertexArray);
    glBindVertexArray(this->VertexArray);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, this->Buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->Buffer);
    glBindBuffer(GL_COPY_WRITE_BUFFER, this->Buffer);
    for (const auto& setting : PixelSettings)
    {
      state->vtkglPixelStorei(setting.Name, setting.Odd);
    }
    glLogicOp(GL_NOR);
    state->vtkglReadBuffer(GL_NONE);
  }

  void Unbind(vtkOpenGLState* state)
  {
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
    glLogicOp(GL_COPY);
    for (const auto& setting : PixelSettings)
    {
      state->vtkglPixelStorei(setting.Name, setting.Default);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    for (GLuint i = 0; i < 8; ++i)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
    }
    for (GLuint unit = 0; unit < 4; ++unit)
    {
      glBindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
    }
    glDeleteTextures(3, this->Textures);
    glDeleteBuffers(1, &this->Buffer);
    glDeleteVertexArrays(1, &this->VertexArray);
    state->vtkglActiveTexture(GL_TEXTURE0);
  }

  GLuint Buffer = 0;
  GLuint Textures[3] = {};
  GLuint VertexArray = 0;
};
vtkStandardNewMacro(StateCheckingPass);

class OpenGLState : public testing::TestWithParam<Method>
{
protected:
  static void ExpectPutBack(TestScene& scene, vtkTransparencyPass* pass)
  {
    scene.Use(pass);
    const Picture expected = scene.Render();
    pass->ReleaseGraphicsResources(scene.Window);
    vtkNew<StateCheckingPass> checking;
    checking->Delegate = pass;
    scene.Use(checking);
    EXPECT_TRUE(Matches(scene.Render(), expected)); // allocates
    EXPECT_TRUE(Matches(scene.Render(), expected)); // finds everything there
    EXPECT_EQ(checking->Frames, 2);
    EXPECT_STREQ(pass->GetFallbackReason(), "");
    EXPECT_GT(pass->GetNumberOfFragments(), 0);
  }
};

TEST_P(OpenGLState, IsPutBack)
{
  for (const int samples : GetParam().Samples())
  {
    for (const bool stencil : { false, true })
    {
      SCOPED_TRACE(std::to_string(samples) + " samples" + (stencil ? ", stencil" : ""));
      TestScene scene(40, 30, samples);
      scene.Window->SetStencilCapable(stencil);
      scene.AddParts();
      ExpectPutBack(scene, GetParam().Make());
    }
  }
}

// A mapper holds the last reference to the pass of its last frame, so VTK's pass and its textures go while the next
// pass draws. They were bound when its frame began. Scene.Render() fails on an error of OpenGL.
TEST_P(OpenGLState, HasNoTextureOfThePassBefore)
{
  TestScene scene(40, 30);
  scene.AddParts();
  scene.RenderAsVTK();
  scene.Use(GetParam().Make());
  scene.Render();
  scene.Render();
}

TEST_P(OpenGLState, IsPutBackAfterWritersOfDepth)
{
  TestScene scene(40, 30);
  scene.AddParts();
  scene.AddRectangle(-0.8, -0.5, 0.7, 0.6, -0.3, { 0.3, 0.9, 0.3, 0.5 })
    ->GetShaderProperty()
    ->AddFragmentShaderReplacement(
      "//VTK::Depth::Impl", true, "gl_FragDepth = gl_FragCoord.z - 0.01;\n", false);
  ExpectPutBack(scene, GetParam().Make());
}

// Caps are drawn by VTK's passes, which leave changed what they do without caps.
TEST(OpenGLStateOfSections, IsPutBack)
{
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    SectionScene scene(samples);
    vtkNew<StateCheckingPass> checking;
    checking->Delegate = vtkSmartPointer<vtkOpaquePass>::New();
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(checking);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    scene.Renderer->SetPass(camera);
    scene.Section->CapsOff();
    checking->IsOfVTK = true;
    checking->ChangedByVTK = { "GL_ACTIVE_TEXTURE" }; // by its textures, of which there are none
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Open()));
    checking->IsOfVTK = false;
    EXPECT_LE(checking->ChangedByVTK.size(), 6u); // the program, vertices
    scene.Section->CapsOn();
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped())); // allocates
    scene.Plane->SetOrigin(0.0, 0.0, 0.2);
    EXPECT_TRUE(Matches(scene.Render(), SectionScene::Capped())); // finds everything there
    EXPECT_EQ(checking->Frames, 3);
  }
}

class OpenGLStateOfBands : public OpenGLState
{
};

TEST_P(OpenGLStateOfBands, IsPutBack)
{
  TestScene scene(40, 30);
  scene.AddParts();
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(GetParam());
  pass->SetMemoryLimit(3000);
  ExpectPutBack(scene, pass);
  EXPECT_GT(pass->GetNumberOfBands(), 1);
}

// Draws what observers draw at the end of a frame.
class EndOfFramePass : public vtkRenderPass
{
public:
  static EndOfFramePass* New();
  vtkTypeMacro(EndOfFramePass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    s->GetRenderer()->InvokeEvent(vtkCommand::EndEvent);
  }
};
vtkStandardNewMacro(EndOfFramePass);

TEST(OpenGLStateOfOutlines, IsPutBack)
{
  for (const int samples : { 0, 4 })
  {
    TestScene scene(40, 30, samples);
    scene.AddParts();
    vtkNew<vtkPartOutlines> outlines;
    outlines->AddPart(scene.Renderer->GetActors()->GetLastActor());
    outlines->Attach(scene.Renderer);
    vtkNew<StateCheckingPass> checking;
    checking->Delegate = vtkSmartPointer<EndOfFramePass>::New();
    scene.Use(checking);
    const Picture first = scene.Render();
    EXPECT_TRUE(Matches(scene.Render(), first));
    EXPECT_EQ(checking->Frames, 2);
    EXPECT_STREQ(outlines->GetFallbackReason(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, OpenGLState, testing::ValuesIn(AllMethods()), MethodName());
INSTANTIATE_TEST_SUITE_P(
  Methods, OpenGLStateOfBands, testing::ValuesIn(ABufferMethods()), MethodName());

}
