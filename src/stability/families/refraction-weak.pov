//! about: a ball of ior 1 + 10^X: in the end it is not there
//! extremity: 10^X
//! steps: -4 to -16 by -2
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, 10> direction -z right .4*x up .3*y }
plane { z, -5 pigment { gradient x triangle_wave color_map { [0 rgb 0][1 rgb 1] } scale 4 } finish { ambient 1 diffuse 0 } }
#ifndef (Right)
  sphere { 0, 1.5 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1 + pow(10, X) } }
#end
