// Draws that change the stencil alone.
void main()
{
}
