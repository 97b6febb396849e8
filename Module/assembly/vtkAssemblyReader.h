/**
 * @class   vtkAssemblyReader
 * @brief   read a file of an assembly as a tree of named parts
 *
 * This reads glTF 2.0 (.gltf, .glb), with compressed and quantized geometry, instances, skins and morph targets at
 * rest. A part is a piece of geometry of one material at one place. Parts of the same mesh share its geometry.
 *
 * STEP, IGES and BREP (.step, .stp, .iges, .igs, .brep) are read by way of a converter, which is a program of its own
 * that makes glTF of them: in metres, with Y upwards. What it made is kept in a folder, so that the same file opens
 * quickly the next time.
 *
 * Open() reads the file. Then parts can be asked for, or drawn by vtkAssemblyActors. The pipeline's output has the
 * parts in world coordinates: a vtkPartitionedDataSetCollection with one partitioned data set for each part, in the
 * order of the parts, and a vtkDataAssembly with the tree. Its nodes have the attribute "label", which is the name.
 *
 * @code
 * vtkNew<vtkAssemblyReader> reader;
 * reader->SetFileName("machine.glb");
 * if (!reader->Open())
 * {
 *   cerr << reader->GetErrorMessage() << "\n";
 * }
 * @endcode
 *
 * @sa
 * vtkAssemblyActors
 */
#ifndef vtkAssemblyReader_h
#define vtkAssemblyReader_h

#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for the parts
#include <string> // for names

#ifndef VTK_UNBLOCKTHREADS // VTK 9.1: Python's other threads wait
#define VTK_UNBLOCKTHREADS
#endif

namespace vitrine
{
struct Assembly;
}

class vtkIdList;
class vtkInformation;
class vtkMatrix4x4;
class vtkPolyData;
class vtkProperty;

class VTKVITRINERENDERING_EXPORT vtkAssemblyReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkAssemblyReader* New();
  vtkTypeMacro(vtkAssemblyReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Set/Get the name of the file. Default is null.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Set/Get the number of the scene that is read, of a file with several. Default is -1: the scene that the file names.
   */
  vtkSetMacro(Scene, int);
  vtkGetMacro(Scene, int);
  ///@}

  ///@{
  /**
   * Set/Get the converter of STEP, IGES and BREP: a command, with quotes as in a shell. Default is null: the variable
   * VITRINE_CAD_CONVERTER, or else vitrine-cad beside the program, beside this library or on PATH.
   */
  vtkSetFilePathMacro(Converter);
  vtkGetFilePathMacro(Converter);
  ///@}

  ///@{
  /**
   * Set/Get how far triangles may be from the shapes of STEP, IGES and BREP, in metres. Default is 0: a thousandth of
   * the diagonal of the box around all.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get how long a conversion may take, in seconds. Default is 3600. 0 stands for no limit.
   */
  vtkSetMacro(ConversionTimeLimit, double);
  vtkGetMacro(ConversionTimeLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get whether conversions are kept for the next time that a file of the same content is read. Default is on.
   */
  vtkSetMacro(UseCache, bool);
  vtkGetMacro(UseCache, bool);
  vtkBooleanMacro(UseCache, bool);
  ///@}

  ///@{
  /**
   * Set/Get the folder of kept conversions. Default is null: vitrine/cad in $XDG_CACHE_HOME, or in ~/.cache.
   */
  vtkSetFilePathMacro(CacheFolder);
  vtkGetFilePathMacro(CacheFolder);
  ///@}

  ///@{
  /**
   * Set/Get how many MiB the kept conversions may take. Those that were not used for longest are removed. Default is
   * 2048.
   */
  vtkSetMacro(CacheLimit, int);
  vtkGetMacro(CacheLimit, int);
  ///@}

  /**
   * Read the file, unless it was read since the last change of a setting. Returns false if it cannot be read. Then
   * GetErrorMessage() says why, and there are no parts.
   */
  VTK_UNBLOCKTHREADS
  bool Open();

  /**
   * Get why the file could not be read, in one line. It is empty if it could.
   */
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

  /**
   * Get the number of parts. Parts are numbered from 0, in the order of the tree.
   */
  int GetNumberOfParts() const;

  ///@{
  /**
   * Get a part's name, and its path: the names of its nodes from the root, each after a slash. Both tell all parts
   * apart. A number out of range is an error and gives an empty text.
   */
  std::string GetPartName(int part);
  std::string GetPartPath(int part);
  std::string GetPartMaterialName(int part);
  ///@}

  /**
   * Find the parts that a pattern chooses, in their order:
   *
   * - `bolt*` chooses each node of that name, with its subtree.
   * - `/Housing/lid*` chooses each node of that whole path, with its subtree. `*` stops at a slash and `**` does not.
   * - `material:glass*` chooses the parts of each material of that name.
   *
   * `?` stands for one character. A backslash takes the meaning from the character after it. Case counts. Returns an
   * empty string, or why there are no such parts, with names that are near.
   */
  std::string FindParts(const std::string& pattern, vtkIdList* parts);

  ///@{
  /**
   * Get a part's geometry in model coordinates, and its place: the matrix from model to world coordinates. The matrix
   * is null if these are the same. Both are null if the number is out of range. Do not change the geometry.
   */
  vtkPolyData* GetPartGeometry(int part);
  vtkMatrix4x4* GetPartPlace(int part);
  ///@}

  ///@{
  /**
   * Get a part's property, which it shares with the other parts of its material, and the property keys that its actor
   * needs for its textures, or null.
   */
  vtkProperty* GetPartProperty(int part);
  vtkInformation* GetPartKeys(int part);
  ///@}

  /**
   * Return true if the material of a part may be translucent by its texture or its colours.
   */
  bool GetPartIsTranslucent(int part);

  /**
   * Get the unit in which a file of STEP, IGES or BREP has its lengths, such as "inch". Parts are in metres all the
   * same. It is empty for other files, and where the file does not tell.
   */
  std::string GetLengthUnit() const;

  ///@{
  /**
   * Get what is shown otherwise than the file says, one line each.
   */
  int GetNumberOfNotes() const;
  std::string GetNote(int note);
  ///@}

protected:
  vtkAssemblyReader();
  ~vtkAssemblyReader() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkAssemblyReader(const vtkAssemblyReader&) = delete;
  void operator=(const vtkAssemblyReader&) = delete;

  struct Content;

  bool IsPart(int part);
  vitrine::Assembly ReadFile();

  char* FileName = nullptr;
  int Scene = -1;
  char* Converter = nullptr;
  double Tolerance = 0.0;
  double ConversionTimeLimit = 3600.0;
  bool UseCache = true;
  char* CacheFolder = nullptr;
  int CacheLimit = 2048;
  std::string ErrorMessage;
  std::unique_ptr<Content> Read;
  vtkMTimeType ReadTime = 0;
};

#endif
