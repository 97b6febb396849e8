namespace vitrine
{
}
