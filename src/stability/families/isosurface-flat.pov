//! about: an isosurface scaled by 10^X along an axis
//! extremity: 10^X
//! steps: 0 to -10 by -1
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#ifdef (Right)
  sphere { 0, 1 scale <1, pow(10, X), 1> pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#else
  isosurface { function { x*x + y*y + z*z - 1 } max_gradient 4 accuracy 1e-5 contained_by { box { -1.1, 1.1 } }
    scale <1, pow(10, X), 1> pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
#end
