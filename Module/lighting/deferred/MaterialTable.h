/**
 * The materials of surfaces that are the same all over, so that pixels of the G-buffer have their numbers in place of their values.
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
  /** Forgets all materials. */
  void Clear();

  /**
   * The number of the material that a mapper draws all of an actor with, whose shader takes it from the property; -1 if it is not that, or there is no more
   * room.
   */
  int NumberOf(vtkAbstractMapper* mapper, vtkProp* prop);

  /** Returns an empty string, or why the driver cannot hold them. The context is current. */
  std::string Write();
  void Release();

  /** Until Unbind() it has a texture unit. */
  void Bind(vtkOpenGLState* state);
  void Unbind() { this->Unit.reset(); }
  void SetUniforms(vtkShaderProgram* program) const;

  /** GPU memory. */
  std::int64_t Bytes() const { return this->Table.Bytes(); }

private:
  using Words = std::array<std::uint32_t,
    4 * VITRINE_MATERIAL_TEXELS>; ///< numbers that are no numbers are told apart, too

  std::vector<VitrineMaterial> Materials;
  std::map<Words, int> Numbers;
  Buffer Table;
  std::unique_ptr<ScopedTextureUnit> Unit;
};

}

#endif
