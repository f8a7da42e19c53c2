//! about: a torus and a lathe seen from 10^X away, in parallel rays
//! extremity: 10^X
//! steps: 1 to 13 by 1
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -pow(10, X) * z direction z right 3.2*x up 2.4*y }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
union {
  torus { .8, .25 rotate 50*x }
  lathe { cubic_spline 6, <0, -1.2>, <.1, -.9>, <.5, -.3>, <.2, .3>, <.3, .8>, <.4, 1> translate -1.2*x }
  pigment { rgb 1 } finish { ambient 0 diffuse 1 }
}
