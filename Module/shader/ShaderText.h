/**
 * The shaders of Module/Shaders as composed at build time (cmake/ComposeShader.cmake).
 */
#ifndef VITRINE_SHADER_SHADER_TEXT_H
#define VITRINE_SHADER_SHADER_TEXT_H

namespace vitrine
{
namespace shaders
{
extern const char* const FillProbe;
extern const char* const FullScreenVertex;
extern const char* const GBufferReadDec;
extern const char* const GBufferReadPhong;
extern const char* const GBufferReadPhysical;
extern const char* const GBufferWriteDec;
extern const char* const GBufferWriteFinished;
extern const char* const GBufferWritePhong;
extern const char* const GBufferWritePhysical;
extern const char* const LightAddPhong;
extern const char* const LightAddPhysical;
extern const char* const LightLoopDec;
extern const char* const LightLoopEnd;
extern const char* const LightLoopImpl;
extern const char* const LightSumsDec;
extern const char* const LightSumsPhong;
extern const char* const LightSumsPhysical;
extern const char* const LinkedListFillDec;
extern const char* const LinkedListFillImpl;
extern const char* const ListMergeRuns;
extern const char* const ListResolve;
extern const char* const ListSortLongRuns;
extern const char* const ListSortRuns;
extern const char* const MarkClusters;
extern const char* const PackedListFillDec;
extern const char* const PackedListFillImpl;
extern const char* const PlaceCounted;
extern const char* const PlacePredicted;
extern const char* const ScanCounts;
extern const char* const ScanDown;
extern const char* const ScanPrediction;
extern const char* const ScanUp;
extern const char* const SortBitonic;
extern const char* const SortInsertion;
extern const char* const SortNetwork;
extern const char* const SortNothing;
extern const char* const SortOddEvenMerge;
extern const char* const SortShell;
extern const char* const StencilFillImpl;
extern const char* const StencilMaskFillDec;
extern const char* const StencilMaskFilter;
extern const char* const StencilMaskMark;
extern const char* const StencilMaskResolve;
extern const char* const StencilOnly;
extern const char* const StencilRoutedFillDec;
extern const char* const StencilRoutedProbe;
extern const char* const StencilRoutedProbeVertex;
extern const char* const StencilRoutedResolve;
extern const char* const StencilRoutedResolveLong;
extern const char* const StencilRoutedVerdict;
extern const char* const TileClassify;
extern const char* const TileQuadVertex;
extern const char* const TruthFillDec;
extern const char* const TruthFillImpl;
extern const char* const TruthRead;
extern const char* const TruthWrite;
}
}
#endif
