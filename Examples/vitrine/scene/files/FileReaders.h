/**
 * One reader for each kind of file. A reader checks what VTK's reader takes on trust, since VTK 9.1
 * reads beyond its arrays where a file is damaged, and throws InputError. What comes out is checked
 * once more, by ReadSceneFile().
 */
#ifndef VITRINE_FILE_READERS_H
#define VITRINE_FILE_READERS_H

#include "scene/Scene.h"
#include "scene/files/ReadingOptions.h"

#include <string>

namespace program
{

Scene ReadAssemblyFile(const std::string& path, const ReadingOptions& options);
Scene ReadCollectionFile(const std::string& path);
Scene ReadHdfFile(const std::string& path);
Scene ReadLegacyFile(const std::string& path);
Scene ReadMultiBlockFile(const std::string& path);
Scene ReadObjFile(const std::string& path);
Scene ReadPartitionedFile(const std::string& path);
Scene ReadPlyFile(const std::string& path);
Scene ReadPolyDataFile(const std::string& path);
Scene ReadStlFile(const std::string& path);
Scene ReadThreeMfFile(const std::string& path);
Scene ReadUnstructuredGridFile(const std::string& path);

/** A scene of one part, of VTK's default material, called by the file's name. */
Scene MakeSinglePartScene(const std::string& path, vtkPolyData* geometry);

}
#endif
