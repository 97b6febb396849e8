#include "scene/files/ScenePack.h"

#include "Errors.h"
#include "OutputFile.h"
#include "report/Json.h"

#include "vtkCellData.h"
#include "vtkCompositeDataWriter.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <map>
#include <utility>

namespace program
{

namespace
{
Json Numbers(const double* numbers, int count)
{
  return Json(std::vector<double>(numbers, numbers + count));
}

Json MaterialJson(vtkProperty* property)
{
  return { { "name", property->GetMaterialName() ? property->GetMaterialName() : "" },
    { "ambient_color", Numbers(property->GetAmbientColor(), 3) },
    { "diffuse_color", Numbers(property->GetDiffuseColor(), 3) },
    { "specular_color", Numbers(property->GetSpecularColor(), 3) },
    { "ambient", property->GetAmbient() }, { "diffuse", property->GetDiffuse() },
    { "specular", property->GetSpecular() }, { "specular_power", property->GetSpecularPower() },
    { "opacity", property->GetOpacity() }, { "interpolation", property->GetInterpolation() },
    { "representation", property->GetRepresentation() }, { "point_size", property->GetPointSize() },
    { "line_width", property->GetLineWidth() }, { "lighting", property->GetLighting() },
    { "backface_culling", bool(property->GetBackfaceCulling()) } };
}

Json TextureJson(vtkTexture* texture)
{
  Json json = { { "interpolate", bool(texture->GetInterpolate()) },
    { "repeat", bool(texture->GetRepeat()) }, { "edge_clamp", bool(texture->GetEdgeClamp()) },
    { "mipmap", bool(texture->GetMipmap()) }, { "srgb", bool(texture->GetUseSRGBColorSpace()) },
    { "color_mode", texture->GetColorMode() }, { "place", nullptr } };
  if (texture->GetTransform())
  {
    json["place"] = Numbers(texture->GetTransform()->GetMatrix()->GetData(), 16);
  }
  return json;
}

/** A copy in which each cell has points of its own with its colour: the module's actors show colours of points only. */
vtkSmartPointer<vtkPolyData> ColorsAtPoints(vtkPolyData* geometry)
{
  vtkDataArray* const cellColors = geometry->GetCellData()->GetScalars();
  auto colors = vtkSmartPointer<vtkDataArray>::Take(cellColors->NewInstance());
  colors->SetNumberOfComponents(cellColors->GetNumberOfComponents());
  colors->SetName(cellColors->GetName());
  vtkNew<vtkPoints> points;
  points->SetDataType(geometry->GetPoints()->GetDataType());
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(points);
  copy->AllocateEstimate(geometry->GetNumberOfCells(), 3);
  copy->GetPointData()->CopyAllocate(geometry->GetPointData());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < geometry->GetNumberOfCells(); ++cell)
  {
    geometry->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType corner = corners->GetId(i);
      const vtkIdType point = points->InsertNextPoint(geometry->GetPoint(corner));
      copy->GetPointData()->CopyData(geometry->GetPointData(), corner, point);
      colors->InsertNextTuple(cell, cellColors);
      corners->SetId(i, point);
    }
    copy->InsertNextCell(geometry->GetCellType(cell), corners);
  }
  copy->GetPointData()->SetScalars(colors);
  copy->GetCellData()->PassData(geometry->GetCellData());
  copy->GetCellData()->SetActiveScalars(nullptr);
  return copy;
}

/** Gives different objects their numbers, in the order in which they come. */
template <class Key>
class Numbering
{
public:
  /** The number of a key, and whether it is new. */
  std::pair<std::size_t, bool> Number(const Key& key)
  {
    const auto [found, isNew] = this->Known.try_emplace(key, this->Known.size());
    return { found->second, isNew };
  }

private:
  std::map<Key, std::size_t> Known;
};

class Packer
{
public:
  void Add(const Part& part, const std::string& path)
  {
    if (part.SphereRadius > 0.0 || part.ClippingPlanes || part.Keys ||
      !part.Material->GetAllTextures().empty())
    {
      throw InputError(
        part.Name, "is drawn by a shader or by planes of its own, which only this program has");
    }
    this->Parts.push_back(
      { { "name", part.Name }, { "path", path }, { "material_name", part.MaterialName },
        { "geometry", this->GeometryOf(part.Geometry) }, { "material", this->MaterialOf(part) },
        { "place", part.Transform ? Numbers(part.Transform->GetData(), 16) : Json(nullptr) },
        { "translucent", part.ForceTranslucent } });
  }

  Json Document() const
  {
    return { { "parts", this->Parts }, { "materials", this->Materials },
      { "textures", this->Textures } };
  }

  vtkMultiBlockDataSet* Data() const { return this->Blocks; }

private:
  std::size_t GeometryOf(vtkPolyData* geometry)
  {
    const auto [number, isNew] = this->BlockNumbers.Number(geometry);
    if (isNew)
    {
      const bool moves = HasColors(geometry->GetCellData()) && !HasColors(geometry->GetPointData());
      this->SetBlock(
        number, moves ? ColorsAtPoints(geometry) : vtkSmartPointer<vtkPolyData>(geometry));
    }
    return number;
  }

  std::size_t ImageOf(vtkDataObject* image)
  {
    const auto [number, isNew] = this->BlockNumbers.Number(image);
    if (isNew)
    {
      this->SetBlock(number, image);
    }
    return number;
  }

  void SetBlock(std::size_t number, vtkSmartPointer<vtkDataObject> data)
  {
    this->Blocks->SetBlock(static_cast<unsigned int>(number), data);
  }

  std::size_t MaterialOf(const Part& part)
  {
    const auto [number, isNew] = this->MaterialNumbers.Number({ part.Material, part.Texture });
    if (isNew)
    {
      this->Materials.push_back(MaterialJson(part.Material));
      this->Materials.back()["texture"] =
        part.Texture ? Json(this->TextureOf(part.Texture)) : Json(nullptr);
    }
    return number;
  }

  std::size_t TextureOf(vtkTexture* texture)
  {
    const auto [number, isNew] = this->TextureNumbers.Number(texture);
    if (isNew)
    {
      this->Textures.push_back(TextureJson(texture));
      this->Textures.back()["image"] = this->ImageOf(texture->GetInputDataObject(0, 0));
    }
    return number;
  }

  vtkNew<vtkMultiBlockDataSet> Blocks;
  Json Parts = Json::array();
  Json Materials = Json::array();
  Json Textures = Json::array();
  Numbering<vtkDataObject*> BlockNumbers;
  Numbering<vtkTexture*> TextureNumbers;
  Numbering<std::pair<vtkProperty*, vtkTexture*>> MaterialNumbers;
};

void WriteBlocks(vtkMultiBlockDataSet* blocks, const std::string& path)
{
  vtkNew<vtkCompositeDataWriter> writer;
  writer->SetInputData(blocks);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  if (writer->Write() == 0)
  {
    throw InputError(path, "cannot be written");
  }
}
}

void WriteScenePack(const Scene& scene, const std::string& folder)
{
  Packer packer;
  const std::vector<std::string> paths = PartPaths(scene);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    packer.Add(scene.Parts[i], paths[i]);
  }
  WriteBlocks(packer.Data(), folder + "/blocks.vtk");
  Json document = packer.Document();
  document["length_unit"] = scene.LengthUnit;
  document["notes"] = scene.Notes;
  for (const SkippedPart& skipped : scene.Skipped)
  {
    document["notes"].push_back(skipped.Name + " " + skipped.Reason);
  }
  if (!scene.Lights.empty())
  {
    document["notes"].push_back("its lights are left out");
  }
  const auto replace = Json::error_handler_t::replace; // what is not UTF-8
  WriteWholeFile(folder + "/parts.json", document.dump(-1, ' ', false, replace));
}

}
