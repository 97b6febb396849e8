/** Tells whether the colours that a mapper gives its data are opaque. */
#ifndef VITRINE_SCENE_SCALAR_COLORS_H
#define VITRINE_SCENE_SCALAR_COLORS_H

class vtkAbstractArray;
class vtkDataSet;
class vtkMapper;

namespace vitrine
{

/** Returns the scalars by which the mapper colours `data`. Returns null if it colours by none, or if there are none. */
vtkAbstractArray* ScalarsOf(vtkMapper* mapper, vtkDataSet* data);

/**
 * Returns true if the scalars have their own lookup table, which the mapper adopts while it draws them
 * (vtkMapper::MapScalars()). Before that, VTK asks the mapper's old table what is translucent.
 * @param scalars  may be null
 */
bool BringTheirTable(vtkMapper* mapper, vtkAbstractArray* scalars);

/**
 * Returns true if all colours that the mapper gives the scalars of `data` are opaque, or if it gives none.
 * VTK's own vtkMapper::HasTranslucentPolygonalGeometry() ignores colours of NaN and of annotated values, tables of
 * arrays, and alphas that are NaN.
 */
bool AreColorsOpaque(vtkMapper* mapper, vtkDataSet* data);

/**
 * Returns true if all colours of a block are opaque, as composite mappers colour it. If the block has no scalars, the
 * mapper's whole table must be opaque.
 */
bool AreBlockColorsOpaque(vtkMapper* mapper, vtkDataSet* block);

}

#endif
