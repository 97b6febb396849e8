// Marks the clusters that contain a lit pixel. It reads the place layer of the G-buffer and writes the marks. Another
// shader may round a point into the next cluster, so that one is marked, too, if the point is close to its side.
#include "GBufferSample.glsl"
#include "ClusterOf.glsl"

const vec3 Slack = vec3(1e-3);

layout(std430, binding = VITRINE_BINDING_CLUSTERS) buffer Marks
{
  uint marks[]; // nonzero for each cluster that contains a lit pixel
};

void mark(vec3 at)
{
  int cluster = vitrineClusterOf(at);
  if (cluster >= 0 && cluster < marks.length() && marks[cluster] == 0u)
  {
    marks[cluster] = 1u;
  }
}

void markAround(vec4 place)
{
  vec3 at = vitrineGridAt(place);
  vec3 first = floor(at - Slack), last = floor(at + Slack);
  // A loop with a variable end in place of a condition: llvmpipe would run the conditional code for every pixel.
  int corners = first != last ? 8 : 1;
  for (int corner = 0; corner < corners; ++corner)
  {
    mark(vec3(corner & 1, (corner >> 1) & 1, corner >> 2) * (last - first) + first);
  }
}

void main()
{
  for (int i = 0; i < max(VITRINE_SAMPLES, 1); ++i)
  {
    vec4 place = vitrineGBufferSample(VITRINE_GBUFFER_PLACE, i);
    if (place.w >= VITRINE_SHOWS_PHONG)
    {
      markAround(vec4(place.xyz, 1.0));
    }
  }
}
