/** Parts as they were added, the actors that draw them, and where each is drawn. */
#ifndef VITRINE_ASSEMBLY_DRAWN_PARTS_H
#define VITRINE_ASSEMBLY_DRAWN_PARTS_H

#include "Core/assembly/PartPattern.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace vitrine
{

/** A part as it was added. */
struct AddedPart
{
  vtkSmartPointer<vtkPolyData> Geometry;
  vtkSmartPointer<vtkMatrix4x4> Place; ///< null for the identity
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkInformation> Keys;
  bool IsTranslucent;
  std::string Name;
};

/** Where a part is drawn: its actor, and its block there. */
struct DrawnPlace
{
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkPolyData> Block; ///< null if the actor has the part alone
  unsigned int FlatIndex = 0;
  vtkSmartPointer<vtkPoints> Unmoved; ///< points of a block that was moved, as they were before
  glm::dvec3 Offset{ 0.0 };           ///< from its own place, in WC
};

/** Small parts of one look are blocks of one actor, in world coordinates. */
class DrawnParts
{
public:
  /** Adds a part, and returns its number. Not after the actors were made. */
  int Add(AddedPart part);

  bool IsMade() const { return this->HasActors; }
  int Count() const { return static_cast<int>(this->Added.size()); }
  const AddedPart& Part(int number) const { return this->Added[static_cast<std::size_t>(number)]; }

  void SetNames(int number, const std::string& name, const PartNames& names);
  const std::vector<PartNames>& Names() const { return this->NamesOfParts; }

  /** Makes the actors if they are not there yet. The members below need them. */
  void Make();

  const std::vector<vtkSmartPointer<vtkActor>>& Actors() const { return this->ActorsOfParts; }
  const DrawnPlace& Place(int number) const
  {
    return this->Places[static_cast<std::size_t>(number)];
  }

  /** Returns the part that an actor shows by a block, or -1. */
  int PartAt(vtkActor* actor, unsigned int block) const;

  void SetOpacity(int number, double opacity);
  void SetColor(int number, const std::array<double, 3>& shown);
  void SetVisibility(int number, bool isVisible);

  /** Moves a part from its own place, in WC. */
  void SetOffset(int number, const glm::dvec3& offset);

  /** Gives a part the look that it was added with. */
  void ResetLook(int number);

private:
  void AddSingle(int number);
  void AddGroup(const std::vector<int>& numbers);
  void AddActor(const vtkSmartPointer<vtkActor>& actor, std::vector<int> parts);
  DrawnPlace& PlaceOf(int number) { return this->Places[static_cast<std::size_t>(number)]; }

  std::vector<AddedPart> Added;
  std::vector<PartNames> NamesOfParts;
  bool HasActors = false;
  std::vector<DrawnPlace> Places; ///< by part
  std::vector<vtkSmartPointer<vtkActor>> ActorsOfParts;
  std::map<vtkActor*, std::vector<int>> Parts; ///< by flat index
};

}

#endif
