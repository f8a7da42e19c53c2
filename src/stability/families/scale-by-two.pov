//! about: one of every shape, the whole scene 2^X times as large
//! extremity: 2^X
//! steps: 0 1 -1 3 -7 20 -20 40 -40 60
//! note: isosurfaces, parametric surfaces and patches are left out: their accuracies are lengths, as in POV-Ray. Planes in solids take in what is within 10^-10 of them, as POV-Ray's do, which two pixels show.
//! truth: the first step to the last bit
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Zoo_Exact = 1;
#include "zoo.inc"
Zoo_View(pow(2, X), 0)
object { Zoo_All scale pow(2, X) }
