// A loop without its #end.
#for (K, 0, 3)
  sphere { K * x, 0.4 pigment { rgb 1 } }
