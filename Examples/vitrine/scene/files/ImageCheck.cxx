#include "scene/files/ImageCheck.h"

#include "Errors.h"
#include "VTKMessages.h"

#include "vtkImageData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtk_png.h"

#include <vector>

namespace program
{

namespace
{
const unsigned LargestSide = 16384;
const std::string PngSignature = "\x89PNG\r\n\x1a\n";

bool IsWholePng(const std::string& bytes)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) ||
    image.width > LargestSide || image.height > LargestSide)
  {
    png_image_free(&image);
    return false;
  }
  image.format = PNG_FORMAT_RGBA;
  std::vector<char> pixels(PNG_IMAGE_SIZE(image));
  return png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0;
}

bool IsWholeJpeg(const std::string& bytes)
{
  const MessageCapture messages;
  vtkNew<vtkJPEGReader> reader;
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  return messages.Errors().empty() && reader->GetOutput()->GetNumberOfPoints() > 0;
}
}

ImageFormat CheckImage(const std::string& path, const std::string& name, const std::string& bytes)
{
  const bool isPng = bytes.compare(0, PngSignature.size(), PngSignature) == 0;
  if (!(isPng ? IsWholePng(bytes) : IsWholeJpeg(bytes)))
  {
    throw InputError(path, "is damaged: " + name + " is no PNG or JPEG, or not a whole one");
  }
  return isPng ? ImageFormat::PNG : ImageFormat::JPEG;
}

}
