#include "scene/files/ObjMaterials.h"

#include "Errors.h"
#include "scene/files/FileBytes.h"
#include "scene/files/ImageCheck.h"
#include "scene/files/ObjLines.h"

#include "vtkBMPReader.h"
#include "vtkImageData.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkTIFFReader.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace program
{

namespace
{
namespace fs = std::filesystem;

/** A material as the file has it. */
struct ReadMaterial
{
  std::array<double, 3> Diffuse = { 1.0, 1.0, 1.0 };
  std::array<double, 3> Specular = { 0.0, 0.0, 0.0 };
  double SpecularPower = 0.0;
  double Opacity = 1.0;
  int Illumination = 2;
  std::string Texture;
  std::array<double, 3> TextureScale = { 1.0, 1.0, 1.0 };
};

/** One to three numbers from a word on; the last one stands for those that are missing. */
std::array<double, 3> NumbersAt(const ObjLine& line, std::size_t word)
{
  std::array<double, 3> numbers;
  numbers.fill(line.NumberAt(word));
  for (std::size_t i = 1; i < 3 && word + i < line.Words.size(); ++i)
  {
    std::fill(
      numbers.begin() + static_cast<std::ptrdiff_t>(i), numbers.end(), line.NumberAt(word + i));
  }
  return numbers;
}

std::array<double, 3> ColorAt(const ObjLine& line)
{
  if (line.Words.size() < 2 || line.Words.size() > 4)
  {
    line.Fail("has too few or too many numbers for " + std::string(line.Words[0]));
  }
  return NumbersAt(line, 1);
}

bool IsNumber(std::string_view word)
{
  return !word.empty() && word.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
}

/** Options of a texture begin with '-'. What follows them is the name, which may have spaces. */
void TakeTexture(const ObjLine& line, ReadMaterial& material)
{
  std::size_t word = 1;
  while (word < line.Words.size() && line.Words[word].front() == '-')
  {
    const std::string_view option = line.Words[word++];
    const std::size_t first = word;
    const bool hasWord = option != "-s" && option != "-o" && option != "-t" && option != "-mm";
    while (word < line.Words.size() && IsNumber(line.Words[word]) && !hasWord)
    {
      ++word;
    }
    word += hasWord ? 1 : 0;
    if (!hasWord && (word == first || word - first > 3))
    {
      line.Fail("has too few or too many numbers for " + std::string(option));
    }
    if (option == "-s")
    {
      material.TextureScale.fill(1.0);
      for (std::size_t i = first; i < word; ++i)
      {
        material.TextureScale[i - first] = line.NumberAt(i);
      }
    }
  }
  material.Texture = line.Rest(word);
}

void TakeLine(const ObjLine& line, ReadMaterial& material)
{
  const std::string_view command = line.Words[0];
  if (command == "Kd")
  {
    material.Diffuse = ColorAt(line);
  }
  else if (command == "Ks")
  {
    material.Specular = ColorAt(line);
  }
  else if (command == "Ns")
  {
    material.SpecularPower = line.NumberAt(1);
  }
  else if (command == "d")
  {
    material.Opacity = std::clamp(line.NumberAt(line.Words.size() - 1), 0.0, 1.0);
  }
  else if (command == "Tr" && material.Opacity == 1.0)
  {
    material.Opacity = 1.0 - std::clamp(line.NumberAt(1), 0.0, 1.0);
  }
  else if (command == "illum")
  {
    material.Illumination = static_cast<int>(std::clamp(line.NumberAt(1), 0.0, 10.0));
  }
  else if (command == "map_Kd" || command == "map_Ka")
  {
    TakeTexture(line, material);
  }
}

/**
 * As VTK's importer makes it, but without Ka: nothing says how much light there is from everywhere, and many programs
 * write that all of it is reflected.
 */
vtkSmartPointer<vtkProperty> MakeProperty(const ReadMaterial& material)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetDiffuseColor(material.Diffuse.data());
  property->SetSpecularColor(material.Specular.data());
  property->SetOpacity(material.Opacity);
  property->SetInterpolationToPhong();
  property->SetDiffuse(1.0);
  property->SetSpecular(material.Illumination == 1 ? 0.0 : 1.0);
  if (material.Illumination == 0)
  {
    property->LightingOff();
    property->SetSpecular(0.0);
  }
  else if (material.Illumination != 1)
  {
    property->SetSpecularPower(material.SpecularPower / 4.0); // Blinn's to Phong's
  }
  return property;
}

/** The file of a texture: where it says, or a JPEG of that name instead of a PNG, or empty if it is not there. */
fs::path FindTexture(const std::string& library, const std::string& name)
{
  const fs::path said = fs::path(library).parent_path() / name;
  std::error_code error;
  if (fs::is_regular_file(said, error))
  {
    return said;
  }
  const fs::path other = fs::path(said).replace_extension(".jpg");
  return said.extension() == ".png" && fs::is_regular_file(other, error) ? other : fs::path();
}

vtkSmartPointer<vtkImageReader2> MakeImageReader(const std::string& path)
{
  vtkNew<vtkBMPReader> bmp;
  vtkNew<vtkTIFFReader> tiff;
  if (bmp->CanReadFile(path.c_str()))
  {
    return bmp.Get();
  }
  if (tiff->CanReadFile(path.c_str()))
  {
    return tiff.Get();
  }
  if (CheckImage(path, "it", ReadBytes(path)) == ImageFormat::PNG)
  {
    return vtkSmartPointer<vtkPNGReader>::New();
  }
  return vtkSmartPointer<vtkJPEGReader>::New();
}

vtkSmartPointer<vtkTexture> MakeTexture(const fs::path& path, const ReadMaterial& material)
{
  const vtkSmartPointer<vtkImageReader2> reader = MakeImageReader(path.string());
  reader->SetFileName(path.c_str());
  reader->Update();
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputDataObject(reader->GetOutput());
  if (material.TextureScale != std::array<double, 3>{ 1.0, 1.0, 1.0 })
  {
    vtkNew<vtkTransform> scale;
    scale->Scale(material.TextureScale.data());
    texture->SetTransform(scale);
  }
  return texture;
}
}

vtkSmartPointer<vtkProperty> MakeObjProperty()
{
  return MakeProperty({});
}

std::map<std::string, ObjMaterial> ReadObjMaterials(
  const std::string& path, std::vector<std::string>& notes)
{
  const std::string bytes = ReadBytes(path);
  if (bytes.back() != '\n')
  {
    throw InputError(path, "does not end with the end of a line: it is truncated");
  }
  std::map<std::string, ReadMaterial> read;
  ReadMaterial* current = nullptr;
  for (ObjLines lines(path, bytes); lines.Next();)
  {
    if (lines.Line().Words[0] == "newmtl")
    {
      current = &read[lines.Line().Rest()];
    }
    else if (current)
    {
      TakeLine(lines.Line(), *current);
    }
  }
  std::map<std::string, ObjMaterial> materials;
  for (const auto& [name, material] : read)
  {
    materials[name].Property = MakeProperty(material);
    const fs::path texture =
      material.Texture.empty() ? fs::path() : FindTexture(path, material.Texture);
    if (!texture.empty())
    {
      materials[name].Texture = MakeTexture(texture, material);
    }
    else if (!material.Texture.empty())
    {
      notes.push_back("texture '" + material.Texture + "' of material '" + name + "' is not there");
    }
  }
  return materials;
}

}
