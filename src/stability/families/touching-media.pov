//! about: glass, water and glass with gaps of 10^X between them, at last none
//! extremity: 10^X
//! steps: -3 -5 -7 -9 -11 -13 -15 -400
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 20 }
camera { location <0, 0, 10> direction -z right .8*x up .6*y }
#declare T = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }
#declare Gap = pow(10, X);
plane { z, -5 pigment { gradient x triangle_wave color_map { [0 rgb 0][1 rgb 1] } scale 6 } finish { ambient 1 diffuse 0 } }
box { <-30, -30, 2>, <30, 30, 3> texture { T } interior { ior 1.5 } }
box { <-30, -30, 1 + Gap>, <30, 30, 2 - Gap> texture { T } interior { ior 1.33 } }
box { <-30, -30, 0>, <30, 30, 1> texture { T } interior { ior 1.5 } }
