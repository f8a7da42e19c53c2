//! about: an isosurface that is a sheet 10^X thick
//! extremity: 10^X
//! steps: -1 to -8 by -1
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare T = pow(10, X);
#declare Look = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#ifdef (Right)
  box { <-1, -T / 2, -1>, <1, T / 2, 1> texture { Look } }
#else
  isosurface { function { abs(y) - T / 2 } max_gradient 1 accuracy T / 100 contained_by { box { -1, 1 } } texture { Look } }
#end
