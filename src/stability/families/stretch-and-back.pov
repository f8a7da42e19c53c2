//! about: one of every shape, stretched by 10^X along a slanted axis and back again
//! extremity: 10^X
//! steps: 0 1 to 15 by 1
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
Zoo_View(1, 0)
object { Zoo_All
  rotate 33*z scale <pow(10, X), 1, 1> rotate -33*z
  rotate 33*z scale <pow(10, -X), 1, 1> rotate -33*z
}
