//! about: one of every shape, the whole scene 2^X times as large
//! extremity: 2^X
//! steps: 0 1 -1 3 -7 20 -20 40 -40 60 -60 80 -80
//! note: an isosurface is left out, whose accuracy is a length of the world for hits and one of its own for normals, as in POV-Ray. Patches are as flat as the scene is large.
//! truth: the first step to the last bit
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Zoo_Exact = 1;
#declare Zoo_Flatness = .001 * pow(2, X);
#include "zoo.inc"
Zoo_View(pow(2, X), 0)
object { Zoo_All scale pow(2, X) }
