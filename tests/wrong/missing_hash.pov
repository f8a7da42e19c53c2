// A directive in the middle of a block without its hash.
union {
  for (K, 0, 3)
    sphere { K * x, 0.5 }
  #end
}
