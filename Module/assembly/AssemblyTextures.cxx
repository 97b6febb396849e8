#include "assembly/AssemblyTextures.h"

#include "Core/assembly/UsedImages.h"
#include "Core/threads/ForEachInThreads.h"
#include "assembly/PngDecoder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageExtractComponents.h"
#include "vtkImageResize.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"

#include <algorithm>
#include <set>
#include <string>

using namespace vitrine;

namespace
{
constexpr std::uint64_t MOST_PIXELS = std::uint64_t{ 1 }
  << 29; // some 2 GB, of all pictures together

/** Decodes a whole picture, or returns null if it is damaged. */
template <class Reader>
vtkSmartPointer<vtkImageData> Decode(const std::vector<std::uint8_t>& bytes)
{
  vtkNew<Reader> reader;
  bool hasFailed = false;
  vtkNew<vtkCallbackCommand> onError;
  onError->SetClientData(&hasFailed);
  onError->SetCallback(
    [](vtkObject*, unsigned long, void* failed, void*) { *static_cast<bool*>(failed) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, onError);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, onError);
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  return hasFailed || image->GetNumberOfPoints() == 0 ? nullptr : image;
}

/** Width times height as the header states them, or 0 if it cannot be read. */
std::uint64_t PixelsOf(const AssemblyImage& image)
{
  const std::vector<std::uint8_t>& bytes = image.Bytes;
  if (image.MimeType == "image/png" && bytes.size() >= 24)
  {
    const auto number = [&bytes](std::size_t at)
    {
      return std::uint64_t{ bytes[at] } << 24 | std::uint64_t{ bytes[at + 1] } << 16 |
        std::uint64_t{ bytes[at + 2] } << 8 | bytes[at + 3];
    };
    return number(16) * number(20);
  }
  if (image.MimeType != "image/jpeg")
  {
    return 0;
  }
  vtkNew<vtkJPEGReader> reader;
  vtkNew<vtkCallbackCommand> onError; // Decode() tells what is wrong.
  reader->AddObserver(vtkCommand::ErrorEvent, onError);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, onError);
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->UpdateInformation();
  const int* const extent = reader->GetDataExtent();
  return static_cast<std::uint64_t>(extent[1] - extent[0] + 1) *
    static_cast<std::uint64_t>(extent[3] - extent[2] + 1);
}

/** Decodes a picture, or returns null if it is damaged or of another kind. */
vtkSmartPointer<vtkImageData> Decode(const AssemblyImage& image)
{
  vtkSmartPointer<vtkImageData> decoded;
  if (image.MimeType == "image/jpeg")
  {
    decoded = Decode<vtkJPEGReader>(image.Bytes);
  }
  // VTK's reader crashes on damaged PNGs and reads beyond the end of those that were cut short.
  else if (image.MimeType == "image/png" &&
    !DecodePng(image.Bytes.data(), image.Bytes.size()).Pixels.empty())
  {
    decoded = Decode<vtkPNGReader>(image.Bytes);
  }
  return decoded;
}

/** A picture of one component of another, in a size. */
vtkSmartPointer<vtkImageData> ExtractFirst(vtkImageData* image, const int* size)
{
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(image);
  resize->SetOutputDimensions(size[0], size[1], size[2]);
  vtkNew<vtkImageExtractComponents> first;
  first->SetInputConnection(resize->GetOutputPort());
  first->SetComponents(0);
  first->Update();
  return first->GetOutput();
}

vtkSmartPointer<vtkImageData> PutFirst(vtkImageData* first, vtkImageData* image)
{
  vtkNew<vtkImageExtractComponents> others;
  others->SetInputData(image);
  others->SetComponents(1, 2);
  vtkNew<vtkImageAppendComponents> append;
  append->AddInputData(first);
  append->AddInputConnection(others->GetOutputPort());
  append->Update();
  return append->GetOutput();
}

/** A picture whose last component, if that is alpha, is as a mode says. */
vtkSmartPointer<vtkImageData> ChangeAlpha(vtkImageData* image, AlphaMode mode, double cutoff)
{
  const int components = image->GetNumberOfScalarComponents();
  if (mode == AlphaMode::Blend || components % 2 != 0)
  {
    return image;
  }
  auto changed = vtkSmartPointer<vtkImageData>::New();
  changed->DeepCopy(image);
  vtkDataArray* const scalars = changed->GetPointData()->GetScalars();
  const double opaque = scalars->GetDataTypeMax();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const bool isHole =
      mode == AlphaMode::Mask && scalars->GetComponent(i, components - 1) < cutoff * opaque;
    scalars->SetComponent(i, components - 1, isHole ? 0.0 : opaque);
  }
  return changed;
}

vtkSmartPointer<vtkImageData> FillFirst(vtkImageData* image)
{
  auto filled = vtkSmartPointer<vtkImageData>::New();
  filled->DeepCopy(image);
  vtkDataArray* const scalars = filled->GetPointData()->GetScalars();
  scalars->FillComponent(0, scalars->GetDataTypeMax());
  return filled;
}
}

AssemblyTextures::AssemblyTextures(Assembly& assembly)
  : Source(assembly)
  , Images(assembly.Images.size())
{
  const std::set<int> used = UsedImages(assembly);
  this->CheckSizes(used);
  ForEachInThreads(this->Images.size(),
    [&](std::size_t i)
    {
      if (used.count(static_cast<int>(i)) > 0)
      {
        this->Images[i] = Decode(assembly.Images[i]);
      }
    });
  for (const int i : used)
  {
    if (!this->Images[static_cast<std::size_t>(i)])
    {
      assembly.Notes.push_back("picture '" + assembly.Images[static_cast<std::size_t>(i)].Name +
        "' is no PNG or JPEG, or not a whole one: parts are shown without it");
    }
  }
}

void AssemblyTextures::CheckSizes(const std::set<int>& used) const
{
  std::uint64_t pixels = 0;
  for (const int image : used)
  {
    pixels += PixelsOf(this->Source.Images[static_cast<std::size_t>(image)]);
    if (pixels > MOST_PIXELS)
    {
      throw AssemblyError("has pictures of more than " + std::to_string(MOST_PIXELS) +
        " pixels together, which are not read");
    }
  }
}

vtkImageData* AssemblyTextures::ImageOf(const TextureUse& use) const
{
  const int image = use.Texture == NO_INDEX
    ? NO_INDEX
    : this->Source.Textures[static_cast<std::size_t>(use.Texture)].Image;
  return image == NO_INDEX ? nullptr : this->Images[static_cast<std::size_t>(image)].Get();
}

vtkSmartPointer<vtkTexture> AssemblyTextures::Make(
  const TextureUse& use, vtkImageData* image, bool isColor) const
{
  const AssemblyTexture& source = this->Source.Textures[static_cast<std::size_t>(use.Texture)];
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetColorModeToDirectScalars();
  texture->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
  texture->SetMipmap(source.HasMipmaps);
  texture->SetInterpolate(source.IsSmooth);
  texture->SetRepeat(source.Repeats);
  texture->SetEdgeClamp(!source.Repeats);
  texture->SetUseSRGBColorSpace(isColor);
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkTexture> AssemblyTextures::Colors(const TextureUse& use)
{
  vtkImageData* const image = this->ImageOf(use);
  if (!image)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkTexture>& texture = this->Made[{ use.Texture, true }];
  texture = texture ? texture : this->Make(use, image, true);
  return texture;
}

vtkSmartPointer<vtkTexture> AssemblyTextures::ShownColors(
  const TextureUse& use, AlphaMode mode, double cutoff)
{
  vtkImageData* const image = this->ImageOf(use);
  return image ? this->Make(use, ChangeAlpha(image, mode, cutoff), false) : nullptr;
}

vtkSmartPointer<vtkTexture> AssemblyTextures::Numbers(const TextureUse& use)
{
  vtkImageData* const image = this->ImageOf(use);
  if (!image)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkTexture>& texture = this->Made[{ use.Texture, false }];
  texture = texture ? texture : this->Make(use, image, false);
  return texture;
}

vtkSmartPointer<vtkTexture> AssemblyTextures::OcclusionRoughnessMetalness(
  const TextureUse& roughness, const TextureUse& occlusion)
{
  vtkImageData* const image = this->ImageOf(roughness);
  if (!image || image->GetNumberOfScalarComponents() < 3)
  {
    return nullptr;
  }
  vtkImageData* const first = this->ImageOf(occlusion);
  vtkSmartPointer<vtkTexture>& texture =
    this->Merged[{ roughness.Texture, first ? occlusion.Texture : NO_INDEX }];
  if (!texture)
  {
    texture = this->Make(roughness,
      first ? PutFirst(ExtractFirst(first, image->GetDimensions()), image) : FillFirst(image),
      false);
  }
  return texture;
}
