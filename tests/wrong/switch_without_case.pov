// A #switch that goes straight to its #else.
#switch (2)
  #else sphere { 0, 1 }
#end
