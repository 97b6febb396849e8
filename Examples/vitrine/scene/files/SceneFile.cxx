#include "scene/files/SceneFile.h"

#include "Core/assembly/UniqueNames.h"
#include "Errors.h"
#include "Join.h"
#include "VTKMessages.h"
#include "scene/files/FileBytes.h"
#include "scene/files/FileReaders.h"
#include "scene/files/GeometryCheck.h"
#include "scene/files/ReadingGuard.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <sstream>

namespace program
{

namespace
{
struct FileType
{
  FileType(std::string extension, Scene (*read)(const std::string& path))
    : Extension(std::move(extension))
    , Read([read](const std::string& path, const ReadingOptions&) { return read(path); })
  {
  }

  FileType(std::string extension, Scene (*read)(const std::string&, const ReadingOptions&))
    : Extension(std::move(extension))
    , Read(read)
  {
  }

  std::string Extension;
  std::function<Scene(const std::string& path, const ReadingOptions&)> Read;
};

const std::vector<FileType>& FileTypes()
{
  static const std::vector<FileType> types = {
    { ".glb", ReadAssemblyFile },
    { ".gltf", ReadAssemblyFile },
    { ".3mf", ReadThreeMfFile },
    { ".step", ReadAssemblyFile },
    { ".stp", ReadAssemblyFile },
    { ".iges", ReadAssemblyFile },
    { ".igs", ReadAssemblyFile },
    { ".brep", ReadAssemblyFile },
    { ".obj", ReadObjFile },
    { ".stl", ReadStlFile },
    { ".ply", ReadPlyFile },
    { ".vtp", ReadPolyDataFile },
    { ".vtu", ReadUnstructuredGridFile },
    { ".vtm", ReadMultiBlockFile },
    { ".vtpd", ReadPartitionedFile },
    { ".vtpc", ReadCollectionFile },
    { ".vtk", ReadLegacyFile },
    { ".vtkhdf", ReadHdfFile },
  };
  return types;
}

const FileType& TypeOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const FileType& type : FileTypes())
  {
    if (type.Extension == extension)
    {
      return type;
    }
  }
  throw InputError(path, "is not of a kind that can be read: " + ListFileTypes());
}

/** Read, with whatever goes wrong in VTK's reader made into an InputError. */
Scene ReadGuarded(const std::string& path, const FileType& type, const ReadingOptions& options)
{
  const ReadingGuard guard(path, std::filesystem::file_size(path));
  const MessageCapture messages;
  try
  {
    Scene scene = type.Read(path, options);
    if (!messages.Errors().empty())
    {
      throw InputError(path, "cannot be read: " + messages.Errors().front());
    }
    for (const std::string& warning : messages.Warnings())
    {
      if (std::find(scene.Notes.begin(), scene.Notes.end(), warning) == scene.Notes.end())
      {
        scene.Notes.push_back(warning);
      }
    }
    return scene;
  }
  catch (const InputError&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw InputError(path, "is damaged, or needs more memory than there is");
  }
  catch (const std::exception& error)
  {
    throw InputError(path, std::string("is damaged: ") + error.what());
  }
}

bool IsFinite(vtkMatrix4x4* matrix)
{
  return !matrix ||
    std::all_of(
      matrix->GetData(), matrix->GetData() + 16, [](double x) { return std::isfinite(x); });
}

void CheckPart(const std::string& path, const Part& part)
{
  const std::string problem = FindGeometryProblem(part.Geometry);
  if (!problem.empty())
  {
    throw InputError(path, "is damaged: part '" + part.Name + "' " + problem);
  }
  if (!IsFinite(part.Transform))
  {
    throw InputError(
      path, "is damaged: the place of part '" + part.Name + "' is not made of finite numbers");
  }
}

/** Take parts in which there is nothing to draw out of the scene, and say so. */
void SkipEmptyParts(Scene& scene)
{
  std::vector<Part> drawn;
  for (Part& part : scene.Parts)
  {
    if (HasDrawableCells(part.Geometry))
    {
      drawn.push_back(std::move(part));
    }
    else
    {
      scene.Skipped.push_back({ part.Name, "has no triangles, lines or points" });
    }
  }
  scene.Parts = std::move(drawn);
}

/** VTK's shaders square lengths in 32-bit float. */
void CheckExtent(const std::string& path, const Scene& scene)
{
  const double smallest = 1e-15;
  const double largest = 1e15;
  const std::array<double, 6> bounds = SceneBounds(scene);
  const double farthest = std::abs(*std::max_element(
    bounds.begin(), bounds.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const double across =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  std::ostringstream problem;
  if (farthest > largest)
  {
    problem << "has coordinates of " << farthest << "; beyond " << largest
            << " nothing can be drawn";
  }
  else if (across > 0.0 && across < smallest)
  {
    problem << "is only " << across << " across; below " << smallest << " nothing can be drawn";
  }
  if (!problem.str().empty())
  {
    throw InputError(path, problem.str());
  }
}

void MakeNamesUnique(Scene& scene)
{
  vitrine::UniqueNames names;
  for (Part& part : scene.Parts)
  {
    part.Name = names.Make(part.Name);
  }
}
}

Scene ReadSceneFile(const std::string& path, const ReadingOptions& options)
{
  CheckReadable(path);
  Scene scene = ReadGuarded(path, TypeOf(path), options);
  for (const Part& part : scene.Parts)
  {
    CheckPart(path, part);
  }
  SkipEmptyParts(scene);
  if (scene.Parts.empty())
  {
    throw InputError(path, "has nothing to draw: no triangles, lines or points");
  }
  CheckExtent(path, scene);
  MakeNamesUnique(scene);
  scene.Name = path;
  scene.Placement.DefaultView = { 30.0, 20.0, 1.0 };
  return scene;
}

std::string ListFileTypes()
{
  return Join(FileTypes(), [](const FileType& type) { return type.Extension; });
}

Scene MakeSinglePartScene(const std::string& path, vtkPolyData* geometry)
{
  Part part;
  part.Name = std::filesystem::path(path).stem().string();
  part.Geometry = geometry;
  part.Material = vtkSmartPointer<vtkProperty>::New();
  if (CountTriangles(geometry) ==
    0) // VTK's white points of one pixel are not seen on a bright ground
  {
    part.Material->SetColor(0.1, 0.2, 0.4);
    part.Material->SetPointSize(3.0f);
  }
  Scene scene;
  scene.Parts.push_back(part);
  return scene;
}

}
