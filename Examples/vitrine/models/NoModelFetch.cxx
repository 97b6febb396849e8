// Takes the place of ModelFetch.cxx where libcurl or libcrypto is missing.
#include "models/ModelFetch.h"

#include "Errors.h"

namespace program
{

void FetchModels(const std::vector<Model>&, const std::string&, Progress&,
  const std::function<void(const Model&, FetchOutcome)>&)
{
  throw RuntimeError(
    "this program was built without libcurl or libcrypto, so it cannot fetch models; "
    "install libcurl4-openssl-dev and libssl-dev, and build it again");
}

}
