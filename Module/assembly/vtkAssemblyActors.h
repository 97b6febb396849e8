/**
 * @class   vtkAssemblyActors
 * @brief   actors that draw the parts of an assembly, in few draws
 *
 * Small parts of a material are blocks of one actor, in world coordinates, drawn by a vtkCulledCompositePolyDataMapper.
 * Large geometry that several parts share has one actor for each of them, and is on the device once. Each part can be
 * found from its actor and block, and back. Its opacity, colour and visibility can be set.
 *
 * @code
 * vtkNew<vtkAssemblyActors> actors;
 * actors->AddParts(reader);
 * actors->AddTo(renderer);
 * actors->SetPartOpacity(part, 0.2);
 * @endcode
 *
 * Parts are found by their names, which those of a reader have at once.
 *
 * Actors are made when one is asked for the first time. After that no part can be added.
 *
 * @sa
 * vtkAssemblyReader vtkCulledCompositePolyDataMapper vtkHierarchicalSBufferCuller
 */
#ifndef vtkAssemblyActors_h
#define vtkAssemblyActors_h

#include "vtkObject.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the actors
#include <string> // for names

class vtkActor;
class vtkAssemblyReader;
class vtkIdList;
class vtkInformation;
class vtkInformationDoubleKey;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProperty;
class vtkRenderer;

namespace vitrine
{
class DrawnParts;
}

class VTKVITRINERENDERING_EXPORT vtkAssemblyActors : public vtkObject
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkAssemblyActors* New();
  vtkTypeMacro(vtkAssemblyActors, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Add all parts that a reader has. They get its numbers if there are none yet. Returns false, after an error, if its
   * file cannot be read, or if actors were made already.
   */
  bool AddParts(vtkAssemblyReader* reader);

  /**
   * Add a part, and return its number. Parts of the same property and the same keys may become blocks of one actor.
   *
   * @param geometry      in model coordinates. Parts may share it.
   * @param place         the matrix from model to world coordinates. Null stands for the identity.
   * @param property      how it looks.
   * @param keys          the property keys of its actor, such as vtkProp::GeneralTextureTransform(). It may be null.
   * @param isTranslucent whether textures or colours may be translucent, which the property does not tell.
   * @return the number, or -1, after an error, if geometry or property are null or actors were made already.
   */
  int AddPart(vtkPolyData* geometry, vtkMatrix4x4* place, vtkProperty* property,
    vtkInformation* keys, bool isTranslucent);

  /**
   * Get the number of parts.
   */
  int GetNumberOfParts() const;

  ///@{
  /**
   * Set/Get the names of a part, as of vtkAssemblyReader: its own, its path, which has the names of its nodes from the
   * root, each after a slash, and the name of its material. Parts that AddPart() added have none. A number out of range
   * is an error and gives empty texts.
   */
  void SetPartNames(
    int part, const std::string& name, const std::string& path, const std::string& material);
  std::string GetPartName(int part);
  std::string GetPartPath(int part);
  std::string GetPartMaterialName(int part);
  ///@}

  /**
   * Find the parts that a pattern chooses by their names, as vtkAssemblyReader::FindParts() does. Returns an empty
   * string, or why there are no such parts, with names that are near.
   */
  std::string FindParts(const std::string& pattern, vtkIdList* parts);

  ///@{
  /**
   * Get a part's geometry in model coordinates, its place, and its property, as they were added. All are null if the
   * number is out of range. Do not change the geometry.
   */
  vtkPolyData* GetPartGeometry(int part);
  vtkMatrix4x4* GetPartPlace(int part);
  vtkProperty* GetPartProperty(int part);
  ///@}

  /**
   * Make a copy of a part's geometry in world coordinates, which shares the arrays that the part's place does not
   * change. The caller owns it. It is null, after an error, if the number is out of range.
   */
  VTK_NEWINSTANCE
  vtkPolyData* CopyPlacedGeometry(int part);

  ///@{
  /**
   * Get the actors. There are fewer than parts. A number out of range is an error and gives null.
   */
  int GetNumberOfActors();
  vtkActor* GetActor(int actor);
  ///@}

  ///@{
  /**
   * Add all actors to a renderer, or remove them.
   */
  void AddTo(vtkRenderer* renderer);
  void RemoveFrom(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Get a part's actor, and the flat index of its block there, which is 0 where the actor has one part alone. They are
   * null and 0 if the part's number is out of range.
   */
  vtkActor* GetPartActor(int part);
  unsigned int GetPartBlock(int part);
  ///@}

  /**
   * Get the number of the part that an actor shows by a block, or -1 if there is none.
   */
  int GetPart(vtkActor* actor, unsigned int block);

  ///@{
  /**
   * Set how a part is drawn: its opacity in [0, 1] in place of its material's, its colour (RGB in [0, 1], as of
   * SetShownColor()) in place of its material's, and whether it is drawn at all. A value out of range is clamped.
   */
  void SetPartOpacity(int part, double opacity);
  void SetPartColor(int part, double red, double green, double blue);
  void SetPartVisibility(int part, bool isVisible);
  ///@}

  /**
   * Have a part drawn as it was added: with its material's opacity and colour, and visibly.
   */
  void ResetPart(int part);

  ///@{
  /**
   * Set/Get by how much a part is drawn away from its place, in world coordinates. The default is no offset. A block
   * that moves has its points copied, and the next frame takes all blocks of its actor to the device again. The part's
   * geometry and place stay what they were. An offset that is not finite is an error.
   */
  void SetPartOffset(int part, double x, double y, double z);
  void GetPartOffset(int part, double offset[3]);
  ///@}

  /**
   * Set the offsets of all parts for an exploded view. Each node of the tree of paths moves with its parent, and away
   * from the centre of the parent's box by `factor` times the distance of their centres. So groups move apart, and
   * within them their own parts. 0 puts all parts back. A factor out of 0 to 1000 is an error.
   */
  void Explode(double factor);

  /**
   * Get the property key of actors whose colour texture (vtkProperty's "albedoTex") has holes where its alpha is below
   * the value, and is opaque elsewhere. 0 stands for a texture whose alpha is ignored. Without the key, the texture's
   * alpha is multiplied into the opacity.
   */
  static vtkInformationDoubleKey* ALPHA_CUTOFF();

  /**
   * Have an actor drawn with property keys as of vtkAssemblyReader::GetPartKeys(), and with the alpha of its colour
   * texture as ALPHA_CUTOFF() says. The keys are copied, since passes write into them, and may be null. Call it after
   * the actor has its property.
   */
  static void SetKeys(vtkActor* actor, vtkInformation* keys);

  ///@{
  /**
   * Set/Get the colour that a property shows: RGB of sRGB in [0, 1], as names of CSS and #RRGGBB stand for it. Lit
   * properties of physically based rendering hold linear colours, and other properties hold it as it is.
   */
  static void SetShownColor(vtkProperty* property, double red, double green, double blue);
  static void GetShownColor(vtkProperty* property, double color[3]);
  ///@}

  /**
   * Make a copy of a property that shares its textures. The caller owns it. vtkProperty::DeepCopy() forgets the
   * emissive factor and does not keep the textures alive.
   */
  VTK_NEWINSTANCE
  static vtkProperty* CopyProperty(vtkProperty* property);

  /**
   * Get the bounds of a geometry's points at a place, in world coordinates: xmin, xmax, ymin, ymax, zmin, zmax. A null
   * place stands for the identity. Of no points, each lowest is above its highest.
   */
  static void GetPlacedBounds(vtkPolyData* geometry, vtkMatrix4x4* place, double bounds[6]);

protected:
  vtkAssemblyActors();
  ~vtkAssemblyActors() override;

private:
  vtkAssemblyActors(const vtkAssemblyActors&) = delete;
  void operator=(const vtkAssemblyActors&) = delete;

  friend class vtkPartLevels; // shows other actors in place of these

  bool IsPart(int part);
  vitrine::DrawnParts& Drawn();

  std::unique_ptr<vitrine::DrawnParts> Private;
};

#endif
