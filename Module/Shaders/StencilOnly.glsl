// Fragment shader of draws that change only the stencil. It reads and writes nothing.
void main()
{
}
