#include "gl/Capabilities.h"

#include "gl/VitrineOpenGL.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vitrine
{

namespace
{

/** Returns the positions of the current framebuffer's samples in a pixel, as x and y in turn from 0 to 1. */
std::vector<float> PlacesOfSamples()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  std::vector<float> places;
  for (GLint sample = 0; sample < samples && samples > 1; ++sample)
  {
    GLfloat place[2] = { 0.0f, 0.0f };
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(sample), place);
    places.insert(places.end(), { place[0], place[1] });
  }
  return places;
}

}

KnownLimits* KnownLimits::Current = nullptr;

KnownLimits::InUse::InUse(KnownLimits& limits)
  : Previous(KnownLimits::Current)
{
  KnownLimits::Current = &limits;
}

KnownLimits::InUse::~InUse()
{
  KnownLimits::Current = this->Previous;
}

std::int64_t KnownLimits::Recall(unsigned int name, const std::function<std::int64_t()>& ask)
{
  if (!KnownLimits::Current)
  {
    return ask();
  }
  const auto [entry, isNew] = KnownLimits::Current->Values.try_emplace(name, 0);
  if (isNew)
  {
    entry->second = ask();
  }
  return entry->second;
}

std::int64_t Limit(unsigned int name)
{
  const auto ask = [name]
  {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return value;
  };
  return KnownLimits::Recall(name, ask);
}

bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    const GLubyte* extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (extension && std::strcmp(reinterpret_cast<const char*>(extension), name) == 0)
    {
      return true;
    }
  }
  return false;
}

std::string MissingFeatures(int major, int minor, const std::vector<const char*>& extensions)
{
  const std::int64_t has[2] = { Limit(GL_MAJOR_VERSION), Limit(GL_MINOR_VERSION) };
  if (has[0] < major || (has[0] == major && has[1] < minor))
  {
    return "OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
      " is needed, the context has " + std::to_string(has[0]) + "." + std::to_string(has[1]);
  }
  std::string missing;
  for (const char* name : extensions)
  {
    if (!HasExtension(name))
    {
      missing += (missing.empty() ? "the driver lacks " : ", ") + std::string(name);
    }
  }
  return missing;
}

bool IsSoftwareRasteriser()
{
  const auto ask = []
  {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    const std::string name = renderer ? reinterpret_cast<const char*>(renderer) : "";
    return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
  };
  return KnownLimits::Recall(GL_RENDERER, ask) != 0;
}

bool HasTimeQueries(unsigned int target)
{
  if (!MissingFeatures(3, 3, {}).empty() && !HasExtension("GL_ARB_timer_query"))
  {
    return false;
  }
  GLint bits = 0;
  glGetQueryiv(target, GL_QUERY_COUNTER_BITS, &bits);
  return bits > 0;
}

int SubpixelBits()
{
  return static_cast<int>(Limit(GL_SUBPIXEL_BITS));
}

int SampleCells()
{
  const std::vector<float> places = PlacesOfSamples();
  for (const int cells : { 2, 4, 8 })
  {
    const bool areInMiddles = std::all_of(places.begin(), places.end(),
      [&](float place)
      {
        const float cell = place * static_cast<float>(cells);
        return std::floor(cell) + 0.5f == cell;
      });
    if (areInMiddles && !places.empty())
    {
      return cells;
    }
  }
  return 0;
}

std::int64_t LargestStorageBlock()
{
  return Limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
}

std::array<std::int64_t, 2> LargestViewport()
{
  const auto ask = []
  {
    GLint size[2] = { 0, 0 };
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, size);
    return std::int64_t(size[0]) << 32 | size[1];
  };
  const std::int64_t both = KnownLimits::Recall(GL_MAX_VIEWPORT_DIMS, ask);
  return { both >> 32, both & GL_INVALID_INDEX };
}

std::int64_t LargestBufferTexture()
{
  return Limit(GL_MAX_TEXTURE_BUFFER_SIZE);
}

}
