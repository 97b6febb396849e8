// A minimal fragment shader in place of a mapper's. It reads nothing and writes a constant colour, and a depth if asked
// to. A method's fill is joined to it in the same way as to VTK's shaders, to test whether the driver compiles it.
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
