// Which cluster of a ClusterGrid, or which cell of a WorldGrid, a place in view coordinates is in.
uniform mat4 vitrineToClip;   // from view coordinates; of cells of the world, to -1 to 1 on each of their axes
uniform vec3 vitrineClusters; // columns, rows, slices
uniform vec2 vitrineTileScale;
uniform vec3 vitrineSliceTerms; // x, y of ClusterGrid::SliceTerms() and the law; 3: slices follow the third axis

// Column, row and slice, with what is behind the point.
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
