//! about: an isosurface whose function is 10^X times as steep
//! extremity: 10^X
//! steps: 0 to 12 by 1, 20 to 200 by 20
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare K = pow(10, X);
isosurface { function { K * (x*x + y*y + z*z + .2 * sin(5*x) * sin(5*y) - .7) } max_gradient 5 * K accuracy 1e-4 contained_by { box { -1.1, 1.1 } }
  pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
