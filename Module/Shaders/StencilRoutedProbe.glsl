// Stencil routing, driver probe: writes a fragment that is identified by its number.
uniform int number;

//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(float(number) / 255.0);
  gl_FragData[1] = vec4(float(number) / 255.0);
}
