/**
 * The shaders of Module/Shaders as composed at build time (cmake/ComposeShader.cmake).
 */
#ifndef VITRINE_SHADER_TEXT_H
#define VITRINE_SHADER_TEXT_H

namespace vitrine
{
namespace shaders
{
extern const char* const FillProbe;
extern const char* const FullScreenVertex;
extern const char* const LinkedListFillDec;
extern const char* const LinkedListFillImpl;
extern const char* const LinkedListMergeRuns;
extern const char* const LinkedListResolve;
extern const char* const LinkedListResolveLong;
extern const char* const LinkedListSortRuns;
extern const char* const StencilMaskFillDec;
extern const char* const StencilMaskFillImpl;
extern const char* const StencilMaskFilter;
extern const char* const StencilMaskMark;
extern const char* const StencilMaskResolve;
extern const char* const TileClassify;
extern const char* const TileQuadVertex;
extern const char* const TruthFillDec;
extern const char* const TruthFillImpl;
extern const char* const TruthRead;
extern const char* const TruthWrite;
}
}
#endif
