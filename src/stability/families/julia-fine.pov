//! about: a julia set of 10^X iterations, cut by hypersphere slices, self-shaded
//! extremity: 10^X
//! steps: 1 1.5 2 2.5
//! truth: the picture with Right declared
//! tolerance: .02
//! note: a fractal has no other surface than the one that a search finds, and POV-Ray's own search, which is kept, meets it again right where a ray leaves it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <2, 2.5, -4>, 1 }
background { rgb <.1, .2, .3> }
julia_fractal { <-.083, 0, -.83, -.025> quaternion sqr max_iteration ceil(pow(10, X)) precision 100
  pigment { rgb 1 } finish { ambient 0 diffuse 1 } #ifdef (Right) no_shadow #end }
