/**
 * VTK's mapper of many blocks, by the name that it has here.
 */
#ifndef VITRINE_TESTING_COMPOSITE_MAPPER_H
#define VITRINE_TESTING_COMPOSITE_MAPPER_H

#if __has_include("vtkCompositePolyDataMapper2.h") // up to VTK 9.2
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

#endif
