//! about: one of every shape, turned 10^X times, seven times round together
//! extremity: 10^X
//! steps: 0 1 2 3 3.5 4
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
Zoo_View(1, 0)
object { Zoo_All
  #local N = ceil(pow(10, X));
  #local I = 0;
  #while (I < N) rotate 2520 / N * z #local I = I + 1; #end
}
