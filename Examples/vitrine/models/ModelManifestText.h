/**
 * The manifest that is built into the program.
 */
#ifndef VITRINE_MODEL_MANIFEST_TEXT_H
#define VITRINE_MODEL_MANIFEST_TEXT_H

namespace model_manifest
{

extern const char* const manifest;

}
#endif
