//! about: a pane of ior 10^X: rays run along its normal
//! extremity: 10^X
//! steps: 2 3 4 5 6 8 10
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
// The pane shortens the way to the wall by its thickness, but for 1/ior of it.
camera { location <0, 0, 10> direction -z right .8*x up .6*y }
#declare Wall = texture { pigment { gradient x triangle_wave color_map { [0 rgb 0][1 rgb 1] } scale 8 } finish { ambient 1 diffuse 0 } }
#ifdef (Right)
  plane { z, -5 + 2 * (1 - pow(10, -X)) texture { Wall } }
#else
  plane { z, -5 texture { Wall } }
  box { <-30, -30, 0>, <30, 30, 2> pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior pow(10, X) } }
#end
