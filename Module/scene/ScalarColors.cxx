#include "scene/ScalarColors.h"

#include "scene/ClassName.h"

#include "vtkAbstractMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"

namespace vitrine
{

namespace
{

/** Returns true if the table's class is known. Tables of other classes may return any colours. */
bool IsKnownTable(vtkScalarsToColors* table)
{
  return IsExactly<vtkLookupTable>(table) || IsExactly<vtkColorTransferFunction>(table) ||
    IsExactly<vtkDiscretizableColorTransferFunction>(table);
}

/** Returns true if the scalars may be colours with an alpha that the opacity test ignores, or that may be NaN. */
bool MayHaveOtherAlphas(vtkMapper* mapper, vtkScalarsToColors* table, vtkDataArray* scalars)
{
  const int components = scalars->GetNumberOfComponents();
  const bool haveAlpha = components == 2 || components > 3;
  const bool areNumbers =
    scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE;
  return haveAlpha &&
    (table->GetVectorMode() == vtkScalarsToColors::RGBCOLORS ||
      (mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS && !areNumbers));
}

/** Returns true if the colours for NaN and for annotated values are opaque. */
bool AreSingleColorsOpaque(vtkScalarsToColors* table)
{
  auto* function = vtkColorTransferFunction::SafeDownCast(table);
  bool areOpaque = !function || function->GetNanOpacity() >= 1.0;
  for (vtkIdType i = 0; table->GetIndexedLookup() && i < table->GetNumberOfAnnotatedValues(); ++i)
  {
    double color[4];
    table->GetIndexedColor(i, color);
    areOpaque = areOpaque && color[3] >= 1.0;
  }
  return areOpaque;
}
}

vtkAbstractArray* ScalarsOf(vtkMapper* mapper, vtkDataSet* data)
{
  int isOfCells = 0;
  return mapper->GetScalarVisibility()
    ? vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isOfCells)
    : nullptr;
}

bool BringTheirTable(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  auto* numbers = vtkDataArray::SafeDownCast(scalars);
  return numbers && numbers->GetLookupTable() &&
    numbers->GetLookupTable() != mapper->GetLookupTable();
}

bool AreColorsOpaque(vtkMapper* mapper, vtkDataSet* data)
{
  vtkAbstractArray* const scalars = ScalarsOf(mapper, data);
  if (!scalars)
  {
    return true; // A mapper without scalars need not have a table.
  }
  vtkScalarsToColors* const table = mapper->GetLookupTable();
  auto* const numbers = vtkDataArray::SafeDownCast(scalars);
  if (!numbers || BringTheirTable(mapper, scalars) || !IsKnownTable(table) ||
    MayHaveOtherAlphas(mapper, table, numbers))
  {
    return false;
  }
  table->Build();
  return AreSingleColorsOpaque(table) &&
    table->IsOpaque(numbers, mapper->GetColorMode(), mapper->GetArrayComponent());
}

bool AreBlockColorsOpaque(vtkMapper* mapper, vtkDataSet* block)
{
  if (!mapper->GetScalarVisibility() || ScalarsOf(mapper, block))
  {
    return AreColorsOpaque(mapper, block);
  }
  vtkScalarsToColors* const table = mapper->GetLookupTable();
  table->Build();
  return IsKnownTable(table) && table->IsOpaque();
}

}
