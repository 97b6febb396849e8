#include "OutputPicture.h"

#include "Errors.h"
#include "OutputFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <filesystem>

namespace program
{

void CheckPicturePath(const std::string& path)
{
  if (std::filesystem::path(path).extension() != ".png")
  {
    throw InputError(path, "pictures are written as PNG: give it a name that ends in .png");
  }
  CheckWritable(path);
}

std::string EncodePicture(const std::vector<std::uint8_t>& pixels, PictureSize size)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.Width, size.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(pixels.begin(), pixels.end(), static_cast<std::uint8_t*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  return { reinterpret_cast<const char*>(png->GetPointer(0)),
    static_cast<std::size_t>(png->GetNumberOfValues()) };
}

void WritePicture(
  const std::string& path, const std::vector<std::uint8_t>& pixels, PictureSize size)
{
  WriteWholeFile(path, EncodePicture(pixels, size));
}

}
