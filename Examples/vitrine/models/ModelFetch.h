/**
 * Models from the network as files.
 */
#ifndef VITRINE_MODEL_FETCH_H
#define VITRINE_MODEL_FETCH_H

#include "models/ModelManifest.h"

#include <functional>
#include <string>
#include <vector>

namespace program
{

class Progress;

/** What FetchModels() did about a model. */
enum class FetchOutcome
{
  WasThere,
  Fetched
};

/**
 * Fetch models into a folder, which is made, but for those that are there already, and tell what was done about each
 * when it is done. A file gets its name when its size and its hash are right. Throws InputError before anything is
 * fetched if a file is another one or cannot be fetched, and leaves what was there before. Throws RuntimeError if the
 * program was built without the libraries that fetch and check files.
 */
void FetchModels(const std::vector<Model>& models, const std::string& folder, Progress& progress,
  const std::function<void(const Model&, FetchOutcome)>& tell);

}
#endif
