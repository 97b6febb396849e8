#include "chart/FolderLock.h"

#include "Errors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace program
{

FolderLock::FolderLock(const std::string& folder)
  : Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  // File systems without locks have nothing to say against it.
  if (this->Descriptor >= 0 && flock(this->Descriptor, LOCK_EX | LOCK_NB) != 0 &&
    errno == EWOULDBLOCK)
  {
    close(this->Descriptor);
    throw InputError(folder, "is being written to by another run");
  }
}

FolderLock::~FolderLock()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
}

}
