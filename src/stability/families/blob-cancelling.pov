//! about: parts of a blob of strength 10^X and -10^X in one place, beside ordinary ones
//! extremity: 10^X
//! steps: 0 2 4 6 8 10 12 14 16
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -4> look_at 0 angle 40 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
blob { threshold .5
  sphere { <-.4, 0, 0>, 1, 1 } sphere { <.4, .2, 0>, 1, 1 }
  sphere { <.1, .3, -.2>, 1.2, pow(10, X) } sphere { <.1, .3, -.2>, 1.2, -pow(10, X) }
  pigment { rgb 1 } finish { ambient 0 diffuse 1 }
}
