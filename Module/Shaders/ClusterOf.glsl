// Finds the cluster of a ClusterGrid, or the cell of a WorldGrid, that contains a point. It reads the uniforms that
// ViewGrid or WorldCells sets.

// From VC to clip coordinates. For a WorldGrid: from VC to -1 to 1 on each axis of its cells.
uniform mat4 vitrineToClip;
uniform vec3 vitrineClusters; // numbers of columns, rows and slices
uniform vec2 vitrineTileScale;
// x and y of ClusterGrid::SliceTerms(), and the SliceLaw. A law of 3 means slices along the third axis.
uniform vec3 vitrineSliceTerms;

// Returns the column, row and slice of a point in view coordinates (VC), with their fractional parts.
vec3 vitrineGridAt(vec4 place)
{
  vec4 clip = vitrineToClip * place;
  float x = vitrineSliceTerms.x, y = vitrineSliceTerms.y, d = -place.z;
  float along = vitrineSliceTerms.z == 0.0 ? log(d * x) * y
    : vitrineSliceTerms.z == 1.0           ? (d - x) * y
    : vitrineSliceTerms.z == 2.0           ? x + y / d
                                           : (clip.z / clip.w + x) * y;
  return vec3((clip.xy / clip.w + 1.0) * vitrineTileScale, along);
}

int vitrineClusterOf(vec3 at)
{
  vec3 cluster = floor(clamp(at, vec3(0.0), vitrineClusters - 1.0));
  return (int(cluster.z) * int(vitrineClusters.y) + int(cluster.y)) * int(vitrineClusters.x) +
    int(cluster.x);
}
