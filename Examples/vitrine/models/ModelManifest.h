/**
 * The models that figures of the documentation name: where each comes from, and what it is.
 */
#ifndef VITRINE_MODEL_MANIFEST_H
#define VITRINE_MODEL_MANIFEST_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** A file of a model. Either Address or Reason is empty. */
struct Model
{
  std::string Name;    ///< The name of the file, without a folder.
  std::string Address; ///< Where exactly this file is, by http or https.
  std::string Reason;  ///< Why this file has no address.
  std::string Sha256;  ///< 64 hexadecimal digits in lower case.
  std::uint64_t Bytes;
  std::string Licence;
  std::string Author;
  std::string Source;     ///< The page that the file, or what it was made from, comes from.
  std::string Conversion; ///< What was changed.
};

bool CanBeFetched(const Model& model);

/** What a manifest says, as JSON and as models. */
struct ModelManifest
{
  std::string Text;
  std::vector<Model> Models;
};

/** Read a manifest, or the program's own if there is no `path`. Throws InputError. */
ModelManifest ReadModelManifest(const std::optional<std::string>& path);

/**
 * The models of these names, each once, in the order of the manifest. "all" stands for those that can be fetched.
 * Throws InputError if a name is unknown.
 */
std::vector<Model> ChooseModels(
  const ModelManifest& manifest, const std::vector<std::string>& names);

/** A table of the models, and why some cannot be fetched. */
std::string ToText(const ModelManifest& manifest);

}
#endif
