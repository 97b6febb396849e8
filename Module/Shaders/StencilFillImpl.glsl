  // Stencil masks and stencil routing, fill pass: writes the fragment's colour and depth. The stencil lets them pass to
  // one place of the pixel. Hidden fragments are discarded here: a failed stencil test counts before the depth test.
  {
#include "TakeFragment.glsl"
    gl_FragData[0] = vitrineColor(gl_FragData[0]);
    gl_FragData[1] = vec4(VITRINE_KEPT_DEPTH(vitrineZ), 0.0, 0.0, 0.0);
  }
