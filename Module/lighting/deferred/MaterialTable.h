/**
 * A table of the materials of uniform surfaces. Pixels of the G-buffer hold a material's number in place of its values.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_MATERIAL_TABLE_H
#define VITRINE_LIGHTING_DEFERRED_MATERIAL_TABLE_H

#include "Shaders/SharedLayout.h"
#include "gl/GLObjects.h"
#include "gl/ScopedState.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkOpenGLState;
class vtkProp;
class vtkShaderProgram;

namespace vitrine
{

class MaterialTable
{
public:
  /** Removes all materials. */
  void Clear();

  /**
   * Returns the number of an actor's material. It is -1 if the mapper does not draw all of the actor with the
   * property's values, or if the table is full. The actor's shader must take the material from the property.
   */
  int NumberOf(vtkAbstractMapper* mapper, vtkProp* prop);

  /**
   * Writes the table to the GPU. Returns an empty string, or why the driver cannot hold it. The context must be
   * current.
   */
  std::string Write();
  void Release();

  /** Binds the table to a texture unit until Unbind(). */
  void Bind(vtkOpenGLState* state);
  void Unbind() { this->Unit.reset(); }
  void SetUniforms(vtkShaderProgram* program) const;

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const { return this->Table.Bytes(); }

private:
  using Words = std::array<std::uint32_t,
    /** The bits of a material, which tell NaNs apart, too. */
    4 * VITRINE_MATERIAL_TEXELS>;

  std::vector<VitrineMaterial> Materials;
  std::vector<VitrineMaterial> Written; ///< What the table holds, as long as it exists.
  std::map<Words, int> Numbers;
  Buffer Table;
  std::unique_ptr<ScopedTextureUnit> Unit;
};

}

#endif
