//! about: one of every shape, the whole scene moved by 10^X times <1, .7, .3>
//! extremity: 10^X
//! steps: 0 1 to 15 by 1
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
#declare Offset = <1, .7, .3> * (X > 0 ? pow(10, X) : 0);
Zoo_View(1, Offset)
object { Zoo_All translate Offset }
