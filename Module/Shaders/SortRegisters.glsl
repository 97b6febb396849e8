  // Part of main(): sorts the registers by a network, then those of equal depth by colour.
  //Vitrine::Sort

  bool disordered;
  do
  {
    disordered = false;
    //Vitrine::OrderTies
  } while (disordered);
