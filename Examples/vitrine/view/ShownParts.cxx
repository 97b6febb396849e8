#include "view/ShownParts.h"

#include "scene/PartChoices.h"

#include "vtkBoundingBox.h"

namespace program
{

ShownParts::ShownParts(const Scene& scene, vtkRenderer* renderer)
  : Content(scene)
  , Shown(AddActors(scene, renderer, this->Blocks))
  , Paths(PartPaths(scene))
  , Offsets(scene.Parts.size())
{
  std::size_t actor = 0;
  int block = 0;
  for (const Part& part : scene.Parts)
  {
    const int number = part.MayBeBlock ? block++ : -1;
    const DrawnPart drawn = part.MayBeBlock
      ? DrawnPart{ this->Blocks->GetPartActor(number), this->Blocks->GetPartBlock(number) }
      : DrawnPart{ this->Shown[actor++], 0 };
    this->Found[{ drawn.Actor, drawn.Block }] = this->Parts.size();
    this->Parts.push_back(drawn);
    this->BlockNumbers.push_back(number);
    this->OwnMaterials.push_back(part.MayBeBlock ? nullptr : drawn.Actor->GetProperty());
  }
}

std::optional<std::size_t> ShownParts::Find(vtkProp* prop, unsigned int block) const
{
  const auto found = this->Found.find({ prop, block });
  return found == this->Found.end() ? std::nullopt : std::optional<std::size_t>(found->second);
}

void ShownParts::DrawByLevels(vtkRenderer* renderer, double pixels)
{
  this->Levels->SetPixels(pixels);
  this->Levels->AddAssembly(this->Blocks);
  this->Levels->Attach(renderer);
}

double ShownParts::OwnOpacity(std::size_t part) const
{
  return this->Content.Parts[part].Material->GetOpacity();
}

void ShownParts::SetLooks(const std::map<std::size_t, PartLook>& looks)
{
  const std::map<std::size_t, PartLook> before = std::move(this->Looks);
  for (const auto& [part, look] : before)
  {
    if (looks.count(part) == 0)
    {
      this->SetLook(part, {});
    }
  }
  for (const auto& [part, look] : looks)
  {
    const auto former = before.find(part);
    if (former == before.end() || !(former->second == look))
    {
      this->SetLook(part, look);
    }
  }
  this->Looks = looks;
}

void ShownParts::SetLook(std::size_t part, const PartLook& look)
{
  if (const int block = this->BlockNumbers[part]; block >= 0)
  {
    this->Blocks->ResetPart(block);
    if (look.Opacity)
    {
      this->Blocks->SetPartOpacity(block, *look.Opacity);
    }
    this->Blocks->SetPartVisibility(block, look.IsVisible);
    return;
  }
  vtkActor* const actor = this->Parts[part].Actor;
  actor->SetVisibility(look.IsVisible);
  actor->SetProperty(this->OwnMaterials[part]);
  if (look.Opacity)
  {
    const vtkSmartPointer<vtkProperty> material = CopyMaterial(this->OwnMaterials[part]);
    material->SetOpacity(*look.Opacity);
    actor->SetProperty(material);
  }
}

void ShownParts::Explode(double factor)
{
  this->Offsets = ExplodedOffsets(this->Content, factor);
  for (std::size_t part = 0; part < this->Count(); ++part)
  {
    const std::array<double, 3>& offset = this->Offsets[part];
    if (const int block = this->BlockNumbers[part]; block >= 0)
    {
      this->Blocks->SetPartOffset(block, offset[0], offset[1], offset[2]);
    }
    else
    {
      this->Parts[part].Actor->SetUserMatrix(MovedBy(offset, this->Content.Parts[part].Transform));
    }
  }
}

std::array<double, 6> ShownParts::Bounds(const std::set<std::size_t>& parts) const
{
  vtkBoundingBox box;
  for (const std::size_t part : parts)
  {
    std::array<double, 6> bounds = PartBounds(this->Content.Parts[part]);
    for (std::size_t i = 0; i < 6; ++i)
    {
      bounds[i] += this->Offsets[part][i / 2];
    }
    box.AddBounds(bounds.data());
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

}
