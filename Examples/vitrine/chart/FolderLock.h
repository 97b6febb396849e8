/**
 * One run at a time in a folder.
 */
#ifndef VITRINE_FOLDER_LOCK_H
#define VITRINE_FOLDER_LOCK_H

#include <string>

namespace program
{

/** Holds a folder until it goes, or the process ends; leaves no file behind. */
class FolderLock
{
public:
  /** Throws InputError if another holds the folder. */
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

private:
  int Descriptor;
};

}
#endif
