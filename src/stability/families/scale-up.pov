//! about: one of every shape, the whole scene 10^X times as large
//! extremity: 10^X
//! steps: 0, 1 to 10 by 1, 12 to 36 by 3, 50
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
Zoo_View(pow(10, X), 0)
object { Zoo_All scale pow(10, X) }
