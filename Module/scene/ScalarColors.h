#ifndef VITRINE_SCENE_SCALAR_COLORS_H
#define VITRINE_SCENE_SCALAR_COLORS_H

class vtkAbstractArray;
class vtkDataSet;
class vtkMapper;

namespace vitrine
{

/** The scalars that a mapper colours data by; null if it does not, or has none. */
vtkAbstractArray* ScalarsOf(vtkMapper* mapper, vtkDataSet* data);

/**
 * Whether scalars bring a table of colours that is not the mapper's, which takes it for its own while it draws them (vtkMapper::MapScalars()). Before that VTK asks the
 * mapper's old one what is translucent.
 * @param scalars  may be null
 */
bool BringTheirTable(vtkMapper* mapper, vtkAbstractArray* scalars);

/**
 * Whether no colour that a mapper gives the scalars of data has any transparency, or it gives them none. VTK's own answer,
 * vtkMapper::HasTranslucentPolygonalGeometry(), leaves out colours of what is unknown and of single values, tables that arrays bring, and alphas that are no numbers.
 */
bool AreColorsOpaque(vtkMapper* mapper, vtkDataSet* data);

/** The same of a block, as composite mappers take it: for one without scalars they ask all of their table. */
bool AreBlockColorsOpaque(vtkMapper* mapper, vtkDataSet* block);

}

#endif
