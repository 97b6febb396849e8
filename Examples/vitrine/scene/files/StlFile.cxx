#include "scene/files/FileReaders.h"

#include "Errors.h"
#include "scene/files/FileBytes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSTLReader.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <unordered_map>
#include <vector>

namespace program
{

namespace
{
const std::size_t HeaderBytes = 84; // with the number of triangles at its end
const std::size_t CountOffset = 80;
const std::size_t TriangleBytes = 50;

/**
 * VTK reads a binary file to whatever end it has. A text file says where it ends, and VTK looks.
 */
void CheckBinaryLength(const std::string& path, const std::string& bytes)
{
  if (bytes.size() < HeaderBytes)
  {
    throw InputError(path,
      "is truncated: " + std::to_string(bytes.size()) +
        " bytes are less than the header of an STL file");
  }
  const std::size_t stated = ReadUInt32(bytes, CountOffset);
  if (bytes.size() != HeaderBytes + stated * TriangleBytes)
  {
    throw InputError(path,
      "is truncated or no STL file: it states " + std::to_string(stated) + " triangles, " +
        std::to_string(HeaderBytes + stated * TriangleBytes) + " bytes, and has " +
        std::to_string(bytes.size()));
  }
}

/** The names after "solid" of a text file, in their order. They may be empty. */
std::vector<std::string> FindSolids(const std::string& bytes)
{
  std::vector<std::string> names;
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string command;
    words >> command;
    std::transform(command.begin(), command.end(), command.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (command == "solid")
    {
      std::string name;
      std::getline(words >> std::ws, name);
      name.erase(name.find_last_not_of(" \t\r") + 1);
      names.push_back(name);
    }
  }
  return names;
}

/** Triangles of one solid, with the points that they use. */
class Solid
{
public:
  void Add(vtkPolyData* all, vtkIdList* corners)
  {
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const auto [point, isNew] =
        this->Numbers.try_emplace(corners->GetId(i), this->Points->GetNumberOfPoints());
      if (isNew)
      {
        this->Points->InsertNextPoint(all->GetPoint(corners->GetId(i)));
      }
      corners->SetId(i, point->second);
    }
    this->Triangles->InsertNextCell(corners);
  }

  vtkSmartPointer<vtkPolyData> Geometry() const
  {
    auto geometry = vtkSmartPointer<vtkPolyData>::New();
    geometry->SetPoints(this->Points);
    geometry->SetPolys(this->Triangles);
    return geometry;
  }

private:
  std::unordered_map<vtkIdType, vtkIdType> Numbers; ///< of points, by those of the whole file
  vtkSmartPointer<vtkPoints> Points = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> Triangles = vtkSmartPointer<vtkCellArray>::New();
};

std::vector<Solid> TakeSolids(vtkPolyData* all, std::size_t count)
{
  vtkDataArray* const numbers = all->GetCellData()->GetScalars();
  std::vector<Solid> solids(count);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i)
  {
    const auto solid = static_cast<std::size_t>(numbers->GetComponent(i, 0));
    all->GetPolys()->GetCellAtId(i, corners);
    if (solid < count)
    {
      solids[solid].Add(all, corners);
    }
  }
  return solids;
}

/** A part for each solid of a text file. */
Scene MakeSolids(const std::string& path, vtkPolyData* all, const std::vector<std::string>& names)
{
  Scene scene;
  const std::vector<Solid> solids = TakeSolids(all, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    Scene solid = MakeSinglePartScene(path, solids[i].Geometry());
    const std::string name = names[i].empty() ? "solid-" + std::to_string(i + 1) : names[i];
    solid.Parts.front().Name = PathStep(name).substr(1);
    scene.Parts.push_back(solid.Parts.front());
  }
  return scene;
}

/** A binary file may begin with "solid" too, so its length decides first. */
bool IsText(const std::string& bytes)
{
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || bytes.compare(begin, 5, "solid") != 0)
  {
    return false;
  }
  const bool hasBinaryLength = bytes.size() >= HeaderBytes &&
    bytes.size() == HeaderBytes + ReadUInt32(bytes, CountOffset) * TriangleBytes;
  return !hasBinaryLength && bytes.find('\0') == std::string::npos;
}
}

Scene ReadStlFile(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  const bool isText = IsText(bytes);
  if (!isText)
  {
    CheckBinaryLength(path, bytes);
  }
  const std::vector<std::string> solids = isText ? FindSolids(bytes) : std::vector<std::string>();
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetScalarTags(solids.size() > 1);
  reader->Update();
  return reader->GetOutput()->GetCellData()->GetScalars()
    ? MakeSolids(path, reader->GetOutput(), solids)
    : MakeSinglePartScene(path, reader->GetOutput());
}

}
