//! about: one of every shape, the whole scene 2^X times as large
//! extremity: 2^X
//! steps: 0 1 -1 3 -7 20 -20 40 -40 60
//! truth: the first step to the last bit
#version 3.7;
global_settings { assumed_gamma 1 }
#include "zoo.inc"
Zoo_View(pow(2, X), 0)
object { Zoo_All scale pow(2, X) }
