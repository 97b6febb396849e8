/** A driver that announces an extension and does not compile a shader that requires it. */
#ifndef VITRINE_TEST_REFUSED_TEXTS_H
#define VITRINE_TEST_REFUSED_TEXTS_H

#include "gl/VitrineOpenGL.h"

#include <string>
#include <utility>
#include <vector>

/** Lets the driver refuse each shader with one of the given texts, while it lives. */
class RefusedTexts
{
public:
  explicit RefusedTexts(std::vector<std::string> texts)
  {
    Texts = std::move(texts);
    Source = glShaderSource;
    glShaderSource =
      [](GLuint shader, GLsizei count, const GLchar* const* strings, const GLint* lengths)
    {
      for (const std::string& text : Texts)
      {
        if (std::string(strings[0]).find(text) != std::string::npos)
        {
          const GLchar* const refused = "#version 150\n#error refused by the test\n";
          Source(shader, 1, &refused, nullptr);
          return;
        }
      }
      Source(shader, count, strings, lengths);
    };
  }
  ~RefusedTexts() { glShaderSource = Source; }
  RefusedTexts(const RefusedTexts&) = delete;
  void operator=(const RefusedTexts&) = delete;

private:
  inline static std::vector<std::string> Texts;
  inline static decltype(glShaderSource) Source = nullptr;
};

#endif
