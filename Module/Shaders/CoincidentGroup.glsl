// Composites fragments with a tolerance. Reads fragments sorted by near end; adds to `color` and `transmittance`.
//
// Fragments are intervals of depth. Fragments whose intervals overlap, directly or through others, form a group. Groups
// depend on the intervals only, not on which fragment noise puts first. A group is composited as the mean over all
// orders of its fragments (Core/lists/CoincidentGroup). A single fragment is composited as usual.
//
// Give each fragment a random time in [0, 1], and let the earlier one be nearer. Then the mean weight of fragment i is
//
//   alpha_i * integral over t of the product over all others j of (1 - t * alpha_j)
//
// The integrands are summed fragment by fragment at the nodes of a Gaussian quadrature (C. F. Gauss, 1814). It has 4
// nodes below t = 1/8, where large groups have their weight, and 4 above. It is exact for up to 8 fragments. For more
// fragments, the weights are scaled to their known sum.
//
// If the alphas sum to more than GROUP_DENSE, all weight lies near t = 0, where weights are proportional to the alphas.
// The colour then is the mean weighted with the alphas, and the integrands, which vanish, are not used. For any number
// of any alphas the error is below a third of 1/255. The order of two fragments does not change a bit of the result.
// The order of more fragments changes only the rounding of sums.
//
// VITRINE_ADDITIVE: an additive colour has no alpha. Its weight is the integral of the product over all fragments.
#define GROUP_SPLIT 0.125
#define GROUP_DENSE 224.0
const vec4 groupNodes = vec4(0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629);
const vec4 groupWeights = vec4(0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693);

// The integrands at four nodes.
struct GroupNodes
{
  vec4 through; // product of all (1 - t alpha)
  vec4 red;     // sums of alpha * colour * product of the others
  vec4 green;
  vec4 blue;
  vec4 alpha;
};

uint groupSize = 0u;
float groupFarEnd;
vec4 groupFirst; // the colour of the first fragment
precise GroupNodes groupBelow;
precise GroupNodes groupAbove;
precise float groupAlphas;  // sum of the alphas
precise vec3 groupMean;     // mean of the colours, weighted with the alphas
precise float groupThrough; // product of all (1 - alpha)
precise float groupOpacity; // 1 - groupThrough, accurate even for the faintest fragments
#ifdef VITRINE_ADDITIVE
precise vec3 groupAdded;    // sum of the additive colours
#endif

float nearEnd(Fragment f)
{
#ifdef VITRINE_COMPACT_NODES
  return vitrineExpandDepth(f.key);
#else
  return uintBitsToFloat(f.key);
#endif
}

float farEnd(Fragment f)
{
  return nearEnd(f) + uintBitsToFloat(f.extra & VITRINE_EXTENT_MASK);
}

void addToNodes(precise inout GroupNodes n, vec4 t, vec4 c)
{
  precise vec3 premultiplied = c.a * c.rgb;
  precise vec4 stays = 1.0 - t * c.a;
  n.red = n.red * stays + premultiplied.r * n.through;
  n.green = n.green * stays + premultiplied.g * n.through;
  n.blue = n.blue * stays + premultiplied.b * n.through;
  n.alpha = n.alpha * stays + c.a * n.through;
  n.through *= stays;
}

void addToSums(vec4 c)
{
#ifdef VITRINE_ADDITIVE
  if (c.a == 0.0)
  {
    groupAdded += c.rgb;
    return;
  }
#endif
  addToNodes(groupBelow, groupNodes * GROUP_SPLIT, c);
  addToNodes(groupAbove, groupNodes * (1.0 - GROUP_SPLIT) + GROUP_SPLIT, c);
  groupAlphas += c.a;
  groupMean += (c.rgb - groupMean) * (c.a / max(groupAlphas, 1e-30)); // 0 if all alphas are
  groupOpacity = groupOpacity + c.a - groupOpacity * c.a;
  groupThrough *= 1.0 - c.a;
}

void addToGroup(Fragment f)
{
  vec4 c = fragmentColor(f);
  if (groupSize == 0u)
  {
    groupFirst = c;
  }
  else
  {
    if (groupSize == 1u)
    {
      groupBelow = GroupNodes(vec4(1.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
      groupAbove = groupBelow;
      groupAlphas = 0.0;
      groupMean = vec3(0.0);
      groupThrough = 1.0;
      groupOpacity = 0.0;
#ifdef VITRINE_ADDITIVE
      groupAdded = vec3(0.0);
#endif
      addToSums(groupFirst);
    }
    addToSums(c);
  }
  ++groupSize;
}

float integral(vec4 below, vec4 above)
{
  precise float sum = GROUP_SPLIT * dot(below, groupWeights) + (1.0 - GROUP_SPLIT) * dot(above, groupWeights);
  return sum;
}

// Returns the group's premultiplied colour.
vec3 colorOfGroup()
{
  precise vec4 sum = vec4(integral(groupBelow.red, groupAbove.red), integral(groupBelow.green, groupAbove.green),
    integral(groupBelow.blue, groupAbove.blue), integral(groupBelow.alpha, groupAbove.alpha));
  precise vec3 scaled = sum.a > 0.0 ? sum.rgb * (groupOpacity / sum.a) : vec3(0.0);
  precise vec3 seen = groupAlphas > GROUP_DENSE ? groupOpacity * groupMean : scaled;
#ifdef VITRINE_ADDITIVE
  precise float through =
    integral(groupBelow.through, groupAbove.through) * (sum.a > 0.0 ? groupOpacity / sum.a : 1.0);
  seen += groupAdded * (groupAlphas > GROUP_DENSE ? groupOpacity / groupAlphas : through);
#endif
  return seen;
}

// Composites the group, and begins another one.
#define BLEND_REST \
  if (groupSize == 1u) \
  { \
    BLEND_COLOR(groupFirst) \
  } \
  else if (groupSize > 1u) \
  { \
    color += transmittance * colorOfGroup(); \
    transmittance *= groupThrough; \
  } \
  groupSize = 0u;

// A fragment without an extent is invisible.
#define BLEND_NEXT(f) \
  if ((f.extra & VITRINE_EXTENT_MASK) != 0u) \
  { \
    if (groupSize > 0u && nearEnd(f) > groupFarEnd) \
    { \
      BLEND_REST \
    } \
    groupFarEnd = groupSize == 0u ? farEnd(f) : max(groupFarEnd, farEnd(f)); \
    addToGroup(f); \
  }

// A network's registers are composited as if no fragments coincided, and copied to an array of VITRINE_BIN. If some do
// coincide, the array is composited again. So the code for groups is in the program once, not for each register.
#if defined(VITRINE_BLENDS_IN_TURN)
#define BLEND_LIST BLEND_REST
#elif defined(VITRINE_BIN)
Fragment sorted[VITRINE_BIN];
int sortedSize = 0;
bool sortedMeet = false;
float sortedFarEnd = -1.0;

#define BLEND(f) \
  { \
    vec4 c = fragmentColor(f); \
    BLEND_COLOR(c) \
    sorted[sortedSize++] = f; \
    sortedMeet = sortedMeet || (f.key != NO_KEY && nearEnd(f) <= sortedFarEnd); \
    sortedFarEnd = max(sortedFarEnd, farEnd(f)); \
  }

#define BLEND_LIST \
  if (sortedMeet) \
  { \
    color = vec3(0.0); \
    transmittance = 1.0; \
    for (int i = 0; i < sortedSize; ++i) \
    { \
      Fragment next = sorted[i]; \
      if (next.key == NO_KEY) \
      { \
        break; \
      } \
      BLEND_NEXT(next) \
    } \
    BLEND_REST \
  }
#endif
