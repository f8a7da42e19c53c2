//! about: a wall seen through X reflections between two mirrors
//! extremity: X
//! steps: 0 to 200 by 20
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 255 adc_bailout 0 }
// Between mirrors at y = 0 and y = 1; the wall's stripes are even about both, so that unfolded they go on for ever.
#declare Slope = X + .31;
camera { orthographic location <0, .5, -1> direction <0, Slope, 1> right .8*x up <0, .006, 0> }
#declare Stripes = function(y) { .5 - .5 * cos(2 * pi * y) }
plane { z, 0 pigment { function { Stripes(y) } color_map { [0 rgb <1, .2, 0>][1 rgb <0, .5, 1>] } } finish { ambient 1 diffuse 0 } }
#ifndef (Right)
  #declare Mirror = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
  plane { y, 0 texture { Mirror } }
  plane { -y, -1 texture { Mirror } }
#end
