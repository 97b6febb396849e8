// Tests the barriers between a frame's writes and the later accesses (gl/MemoryBarriers.h). llvmpipe runs draws one
// after the other, so no picture shows a missing barrier. Therefore the calls are recorded on their way to the driver.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/VitrineOpenGL.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

constexpr int Size = 16;

// While it lives, records writes, reads and barriers, a letter each. C clears an image, S runs a compute shader, G
// draws geometry, T draws tiles, Z clears a buffer, K copies one, R reads one.
// Barriers are named by the uses that they precede: f framebuffers, F
// fills, l lists, s scans, r reads.
class CallRecord
{
public:
  CallRecord()
  {
    Calls.clear();
    Barrier = glMemoryBarrier;
    Dispatch = glDispatchCompute;
    Read = glGetBufferSubData;
    Clear = glClearBufferuiv;
    Tiles = glDrawArraysInstanced;
    Zero = glClearBufferData;
    Copy = glCopyBufferSubData;
    glClearBufferData = RecordZero;
    glCopyBufferSubData = RecordCopy;
    glMemoryBarrier = RecordBarrier;
    glDispatchCompute = RecordDispatch;
    glGetBufferSubData = RecordRead;
    glClearBufferuiv = RecordClear;
    glDrawArraysInstanced = RecordTiles;
  }
  ~CallRecord()
  {
    glMemoryBarrier = Barrier;
    glDispatchCompute = Dispatch;
    glGetBufferSubData = Read;
    glClearBufferuiv = Clear;
    glDrawArraysInstanced = Tiles;
    glClearBufferData = Zero;
    glCopyBufferSubData = Copy;
  }
  static std::string Calls;

private:
  static void RecordBarrier(GLbitfield uses)
  {
    Calls += Letter(uses);
    Barrier(uses);
  }
  static char Letter(GLbitfield uses)
  {
    const bool fetches = uses & GL_TEXTURE_FETCH_BARRIER_BIT;
    const bool storage = uses & GL_SHADER_STORAGE_BARRIER_BIT;
    const bool images = uses & GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    const bool framebuffers = uses & GL_FRAMEBUFFER_BARRIER_BIT;
    const bool buffers = uses & GL_BUFFER_UPDATE_BARRIER_BIT;
    const bool lists = fetches && storage;
    return lists && images && framebuffers ? 's'
      : lists && images && buffers         ? 'F'
      : lists && images                    ? 'l'
      : framebuffers                       ? 'f'
      : buffers                            ? 'r'
                                           : '?';
  }
  static void RecordDispatch(GLuint x, GLuint y, GLuint z)
  {
    Calls += 'S';
    Dispatch(x, y, z);
  }
  static void RecordRead(GLenum target, GLintptr offset, GLsizeiptr size, void* data)
  {
    Calls += 'R';
    Read(target, offset, size, data);
  }
  static void RecordZero(GLenum target, GLenum inner, GLenum format, GLenum type, const void* data)
  {
    Calls += 'Z';
    Zero(target, inner, format, type, data);
  }
  static void RecordCopy(
    GLenum from, GLenum to, GLintptr fromOffset, GLintptr toOffset, GLsizeiptr size)
  {
    Calls += 'K';
    Copy(from, to, fromOffset, toOffset, size);
  }
  static void RecordClear(GLenum buffer, GLint index, const GLuint* value)
  {
    Calls += 'C';
    Clear(buffer, index, value);
  }
  static void RecordTiles(GLenum mode, GLint first, GLsizei count, GLsizei instances)
  {
    Calls += 'T';
    Tiles(mode, first, count, instances);
  }

  static decltype(glMemoryBarrier) Barrier;
  static decltype(glDispatchCompute) Dispatch;
  static decltype(glGetBufferSubData) Read;
  static decltype(glClearBufferuiv) Clear;
  static decltype(glDrawArraysInstanced) Tiles;
  static decltype(glClearBufferData) Zero;
  static decltype(glCopyBufferSubData) Copy;
};
std::string CallRecord::Calls;
decltype(glMemoryBarrier) CallRecord::Barrier = nullptr;
decltype(glDispatchCompute) CallRecord::Dispatch = nullptr;
decltype(glGetBufferSubData) CallRecord::Read = nullptr;
decltype(glClearBufferuiv) CallRecord::Clear = nullptr;
decltype(glDrawArraysInstanced) CallRecord::Tiles = nullptr;
decltype(glClearBufferData) CallRecord::Zero = nullptr;
decltype(glCopyBufferSubData) CallRecord::Copy = nullptr;

void RecordGeometry(vtkObject*, unsigned long, void*, void*)
{
  CallRecord::Calls += 'G';
}

// The calls of a frame of so many layers by the pass, whose frames before have settled.
std::string CallsOf(vtkTransparencyPass* pass, int layers)
{
  TestScene scene(Size, Size);
  vtkActor* actor = scene.AddPlates(RandomPlates(layers, 0.1, 5), 6);
  vtkNew<vtkCallbackCommand> draws;
  draws->SetCallback(RecordGeometry);
  actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, draws);
  scene.Use(pass);
  scene.Render();
  scene.Render();
  const CallRecord record;
  scene.Render();
  return CallRecord::Calls;
}

TEST(MemoryBarriers, OfLinkedLists)
{
  EXPECT_EQ(CallsOf(MakeABuffer(ABufferMethods().front()), 10), "fCZFGlrKTR");
}

// Runs are sorted in place and then merged.
TEST(MemoryBarriers, OfLongLinkedLists)
{
  EXPECT_EQ(CallsOf(MakeABuffer(ABufferMethods().front()), 100), "fCZFGlrKTlTR");
}

// Counted, and then scanned: sums of blocks, of blocks of blocks, and down again.
TEST(MemoryBarriers, OfCountedPrefixSums)
{
  vtkNew<vtkPrefixSumTransparencyPass> pass;
  pass->PredictionOff();
  EXPECT_EQ(CallsOf(pass, 10), "fCZFGsSsSsSsSsZFGlrKTR");
}

TEST(MemoryBarriers, OfPredictedPrefixSums)
{
  vtkNew<vtkPrefixSumTransparencyPass> pass;
  EXPECT_EQ(CallsOf(pass, 10), "sSsSsSsfZFGlrKKTR");
}

// Each of three bands, which the last frame planned, is cleared, filled and resolved. All counters are read at once.
TEST(MemoryBarriers, OfBands)
{
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(ABufferMethods().front());
  pass->SetMemoryLimit(Size * Size * 10 * 12 * 2 / 3);
  EXPECT_EQ(CallsOf(pass, 10), "fCZFGlrKTfCZFGlrKTfCZFGlrKTR");
}

TEST(MemoryBarriers, OfTruth)
{
  vtkNew<vtkTruthTransparencyPass> pass;
  EXPECT_EQ(CallsOf(pass, 10), "FGrRR");
}

}
