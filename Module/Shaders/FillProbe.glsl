// A mapper's fragment shader with nothing of a mapper in it: a method's fill is joined to it as to VTK's own, to learn
// whether the driver takes it.
//VTK::Output::Dec
//VTK::DepthPeeling::Dec
void main()
{
  //VTK::UniformFlow::Impl
  gl_FragData[0] = vec4(0.5);
#ifdef VITRINE_WRITES_DEPTH
  gl_FragDepth = 0.5;
#endif
  //VTK::DepthPeeling::Impl
}
