#include "scene/files/ImageCheck.h"

#include "Errors.h"
#include "VTKMessages.h"
#include "assembly/PngDecoder.h"

#include "vtkImageData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"

namespace program
{

namespace
{
const std::string PngSignature = "\x89PNG\r\n\x1a\n";

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
  const bool isWhole = isPng ? !vitrine::DecodePng(bytes).Pixels.empty() : IsWholeJpeg(bytes);
  if (!isWhole)
  {
    throw InputError(path, "is damaged: " + name + " is no PNG or JPEG, or not a whole one");
  }
  return isPng ? ImageFormat::PNG : ImageFormat::JPEG;
}

}
