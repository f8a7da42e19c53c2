// A texture that only an installed POV-Ray has.
#version 3.7;
#include "textures.inc"
sphere { 0, 1 texture { Cork } }
