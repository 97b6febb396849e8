  // Stencil masks and stencil routing: colour and depth. The stencil lets them through to one place of the pixel's; what opaque
  // geometry hides must not get there, since a failed stencil test counts before the depth is tested.
  {
#include "TakeFragment.glsl"
    gl_FragData[0] = vitrineColor(gl_FragData[0]);
    gl_FragData[1] = vec4(VITRINE_KEPT_DEPTH(vitrineZ), 0.0, 0.0, 0.0);
  }
